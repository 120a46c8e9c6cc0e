/* Two stages that turn apart. */
#include <libcontact/c/contact.h>
#include <libcontact/c/run.h>
#include <stdio.h>
#include <stdlib.h>

/* A call that fails ends the program with its message. */
static void must(contact_status status) {
  if (status == CONTACT_OK) return;
  fprintf(stderr, "%s\n", contact_last_message());
  exit(1);
}

int main(void) {
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
  return 0;
}
