/* star_run CASE TIME...: the angles of a, b and c at these times, deg, a line
 * each. A program of its own: Simbody brings functions of the names of those of
 * SUNDIALS. */
#include <stdio.h>
#include <stdlib.h>

#include "libcontact/c/contact.h"
#include "separation/c/run.h"

static void must(contact_status status) {
  if (status == CONTACT_OK) return;
  fprintf(stderr, "%s\n", contact_last_message());
  exit(1);
}

int main(int count, char** arguments) {
  static const char* const names[] = {"a.angle_deg", "b.angle_deg",
                                      "c.angle_deg"};
  contact_run* run;
  must(contact_run_open(arguments[1], NULL, 0, &run));
  const size_t columns = contact_run_column_count(run);
  double* const values = malloc(columns * sizeof *values);
  for (int i = 2; i < count; ++i) {
    must(contact_run_advance(run, atof(arguments[i])));
    must(contact_run_values(run, values, columns));
    for (int k = 0; k < 3; ++k) {
      size_t at;
      must(contact_run_find_column(run, names[k], &at));
      printf("%.17g ", values[at]);
    }
    printf("\n");
  }
  free(values);
  contact_run_free(run);
  return 0;
}
