/* SPDX-License-Identifier: MIT */
/* Runs of hinge-separation: bodies on hinges with friction through time.
 *
 * The library contact_runs_c; statuses, messages and null pointers are treated
 * as in libcontact/c/contact.h. A run is used by one thread at a time; runs
 * share no data. contact_run_free() and contact_free() free runs and saved
 * bytes, and accept NULL. */
#ifndef LIBCONTACT_C_RUN_H
#define LIBCONTACT_C_RUN_H

#include <stddef.h>

#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* A running case of hinge-separation: motion, friction, events. */
typedef struct contact_run contact_run;

/* Opens a case file with settings of its keys; the run is at its start. */
contact_status contact_run_open(const char* path,
                                const contact_setting* settings, size_t count,
                                contact_run** run);
void contact_run_free(contact_run* run);

/* Advances to a time, s, or to the end of the case, with all events before.
 * The later motion is bit-identical, independent of intermediate stops.
 * CONTACT_RUN_FAILED: it reached contact_run_time() and cannot continue. */
contact_status contact_run_advance(contact_run* run, double time);
double contact_run_time(const contact_run* run);     /* s; NaN for NULL */
double contact_run_end_time(const contact_run* run); /* s; NaN for NULL */

/* The columns of hinge-separation's history
 * (libcontact/docs/reference/separation_output.md): modes, angles, reactions,
 * pressures, positions, velocities, distances, energies. */
size_t contact_run_column_count(const contact_run* run);
/* NULL after the last one. Valid until the run is restored or freed. */
const char* contact_run_column(const contact_run* run, size_t i);
/* CONTACT_BAD_INPUT if no column has this name. */
contact_status contact_run_find_column(const contact_run* run, const char* name,
                                       size_t* i);
/* The values of all columns at contact_run_time(). */
contact_status contact_run_values(const contact_run* run, double* values,
                                  size_t count);
/* Inputs: loads from outside the case, as of a controller. Of each body NAME
 * NAME.applied_force_x_N to _z_N at its centre of mass and
 * NAME.applied_moment_x_N_m to _z_N_m, in the body's axes; of a body on an axis
 * NAME.applied_hinge_moment_N_m about it, with the opposite one on the body
 * that carries the hinge, until that breaks. A carrier that is fixed or driven
 * has none. They are 0 at the start, and part of saved states. */
size_t contact_run_input_count(const contact_run* run);
/* NULL after the last one. Valid until the run is freed. */
const char* contact_run_input(const contact_run* run, size_t i);
/* CONTACT_BAD_INPUT if no input has this name. */
contact_status contact_run_find_input(const contact_run* run, const char* name,
                                      size_t* i);
/* Sets all inputs, finite numbers: they act from contact_run_time() on,
 * constant until they are set again. contact_run_values() at this time are
 * those before. Equal values change nothing; others restart the steps. */
contact_status contact_run_set_inputs(contact_run* run, const double* values,
                                      size_t count);

/* The history so far: rows of contact_run_column_count() numbers at the case's
 * output times and events. NULL after the last one; valid until the run
 * advances, is restored or freed. */
size_t contact_run_row_count(const contact_run* run);
const double* contact_run_row(const contact_run* run, size_t i);

/* Event of a run: "release: axis breaks". */
typedef struct contact_event {
  double time; /* s */
  const char* body;
  const char* what;
} contact_event;
size_t contact_run_event_count(const contact_run* run);
/* The texts of the event are valid as long as a row. */
contact_status contact_run_event(const contact_run* run, size_t i,
                                 contact_event* event);

/* Notes on the joints so far: joints beyond the theory or the limits of their
 * materials, and neglected effects of seats for contacts near rims. One
 * sentence per line, truncated to `size` including the final 0. */
contact_status contact_run_notes(const contact_run* run, char* text,
                                 size_t size);

/* A run with bit-identical later motion. Copying restarts the steps of both
 * runs, like contact_run_save(). */
contact_status contact_run_copy(contact_run* run, contact_run** copy);

/* State from which a run of the same file and settings can continue, as bytes,
 * with its history; free them by contact_free(). Saving restarts the steps:
 * this run and restored runs then continue bit-identically, and differ from a
 * run that was never saved within the tolerances. */
contact_status contact_run_save(contact_run* run, void** bytes, size_t* size);
contact_status contact_run_restore(contact_run* run, const void* bytes,
                                   size_t size);
void contact_free(void* bytes);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
