/* star_run CASE COLUMN,... TIME...: prints columns of a history at these times,
 * one line each. A separate program, because functions of Simbody and SUNDIALS
 * have the same names. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "libcontact/c/contact.h"
#include "separation/c/run.h"

static void must(contact_status status) {
  if (status == CONTACT_OK) return;
  fprintf(stderr, "%s\n", contact_last_message());
  exit(1);
}

int main(int count, char** arguments) {
  contact_run* run;
  must(contact_run_open(arguments[1], NULL, 0, &run));
  const size_t columns = contact_run_column_count(run);
  double* const values = malloc(columns * sizeof *values);
  size_t* const at = malloc(columns * sizeof *at);
  int wanted = 0;
  for (char* name = strtok(arguments[2], ","); name; name = strtok(NULL, ",")) {
    must(contact_run_find_column(run, name, &at[wanted++]));
  }
  for (int i = 3; i < count; ++i) {
    must(contact_run_advance(run, atof(arguments[i])));
    must(contact_run_values(run, values, columns));
    for (int k = 0; k < wanted; ++k) printf("%.17g ", values[at[k]]);
    printf("\n");
  }
  free(at);
  free(values);
  contact_run_free(run);
  return 0;
}
