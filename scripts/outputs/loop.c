/* Numbers of libcontact/c with all digits: loop JOINT... */
#include <stdio.h>

#include "libcontact/c/contact.h"

static void show(const char* name, const double* numbers, size_t count) {
  printf("%s", name);
  for (size_t i = 0; i < count; ++i) printf(" %.17g", numbers[i]);
  printf("\n");
}

static int loop(const char* file) {
  contact_joint* joint = NULL;
  if (contact_joint_read(file, NULL, 0, &joint) != CONTACT_OK) {
    printf("%s: %s\n", file, contact_last_message());
    return 1;
  }
  contact_solution last;
  contact_step step;
  for (int i = 0; i < 8; ++i) {
    const contact_slip slip = {
        {1000.0 - 300 * i, 200, 100.0 * i}, {0.1, 0.1 * i, 0.5}, {0}};
    contact_joint_solve(joint, &slip, i == 0 ? NULL : &last, &last);
    printf("%s %d\n", file, (int)last.status);
    show("M_t", last.friction_moment, 3);
    show("p A theta0",
         (double[]){last.peak_pressure, last.contact_area, last.half_angle}, 3);
    const contact_hold hold = {
        {1000.0 - 300 * i, 200, 100.0 * i}, {0.01, 0.01 * i, 0.05}, {0}};
    contact_rest rest;
    contact_joint_at_rest(joint, &hold, NULL, &rest);
    show("tau u",
         (double[]){rest.utilisation, rest.direction[0], rest.direction[1],
                    rest.direction[2]},
         4);
    const contact_step_start start = {{1000.0 - 300 * i, 200, 100.0 * i},
                                      {0.1, 0.1 * i, 0.5},
                                      {0.1, 0.1, 0.4},
                                      {0}};
    const double inertia[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    contact_joint_step(joint, &start, inertia, i == 0 ? NULL : &step, &step);
    printf("step %d %d\n", (int)step.status, step.holds);
    show("Dw M",
         (double[]){step.angular_velocity[0], step.angular_velocity[1],
                    step.angular_velocity[2], step.moment[0], step.moment[1],
                    step.moment[2]},
         6);
  }
  contact_joint_free(joint);
  return 0;
}

int main(int count, char** files) {
  int failed = 0;
  for (int i = 1; i < count; ++i) failed |= loop(files[i]);
  return failed;
}
