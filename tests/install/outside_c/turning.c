/* A hip that turns under 2000 N, and two stages that turn apart. */
#include <libcontact/c/contact.h>
#include <stdio.h>
#include <stdlib.h>

/* A call that fails ends the program with its message. */
static void must(contact_status status) {
  if (status == CONTACT_OK) return;
  fprintf(stderr, "%s\n", contact_last_message());
  exit(1);
}

static void turn_hip(void) {
  contact_joint* hip;
  const contact_slip slip = {.reaction = {0, 0, 2000},           /* N */
                             .angular_velocity = {0.8, 0, 0.6}}; /* rad/s */
  contact_solution s;
  must(contact_joint_read("data/joints/hip_cocr_uhmwpe.toml", NULL, 0, &hip));
  must(contact_joint_solve(hip, &slip, NULL, &s));
  printf("half-angle %.4f rad, peak %.2f MPa, power %.4f W\n", s.half_angle,
         s.peak_pressure / 1e6, s.power);
  contact_joint_free(hip);
}

static void turn_stages(void) {
  contact_run* run;
  const contact_setting rubs = {
      "body[stage].hinge.joint[1].friction.coefficient", "0.3"};
  size_t columns, angle;
  double* values;
  must(contact_run_open("data/cases/two_stage_turn.toml", &rubs, 1, &run));
  columns = contact_run_column_count(run);
  values = malloc(columns * sizeof *values);
  must(contact_run_find_column(run, "stage.angle_deg", &angle));
  while (contact_run_time(run) < contact_run_end_time(run)) {
    must(contact_run_advance(run, contact_run_time(run) + 1));
    must(contact_run_values(run, values, columns));
    printf("%.1f s: %.3f deg\n", contact_run_time(run), values[angle]);
  }
  free(values);
  contact_run_free(run);
}

int main(void) {
  turn_hip();
  turn_stages();
  return 0;
}
