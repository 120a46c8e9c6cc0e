/* A hip that turns under 2000 N. */
#include <libcontact/c/contact.h>
#include <stdio.h>
#include <stdlib.h>

/* A call that fails ends the program with its message. */
static void must(contact_status status) {
  if (status == CONTACT_OK) return;
  fprintf(stderr, "%s\n", contact_last_message());
  exit(1);
}

int main(void) {
  contact_joint* hip;
  const contact_slip slip = {.reaction = {0, 0, 2000},           /* N */
                             .angular_velocity = {0.8, 0, 0.6}}; /* rad/s */
  contact_solution s;
  must(contact_joint_read("data/joints/hip_cocr_uhmwpe.toml", NULL, 0, &hip));
  must(contact_joint_solve(hip, &slip, NULL, &s));
  printf("half-angle %.4f rad, peak %.2f MPa, power %.4f W\n", s.half_angle,
         s.peak_pressure / 1e6, s.power);
  contact_joint_free(hip);
  return 0;
}
