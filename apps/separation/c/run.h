/* Runs of hinge-separation: bodies on hinges with friction through time.
 *
 * The library contact_runs_c; statuses, messages and null pointers are treated
 * as in libcontact/c/contact.h. A run is used by one thread at a time; runs
 * have nothing in common. Runs and saved bytes are given back by
 * contact_run_free() and contact_free(), which take NULL too. */
#ifndef LIBCONTACT_C_RUN_H
#define LIBCONTACT_C_RUN_H

#include <stddef.h>

#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* A case of hinge-separation on its way: motion, friction, events. */
typedef struct contact_run contact_run;

/* Opens a case file with settings of its keys; the run is at its start. */
contact_status contact_run_open(const char* path,
                                const contact_setting* settings, size_t count,
                                contact_run** run);
void contact_run_free(contact_run* run);

/* Moves on to a time, s, or to the end of the case, with the events on the
 * way. Where it stops changes nothing of what follows, to the last bit.
 * CONTACT_RUN_FAILED: it came to contact_run_time() and cannot go on. */
contact_status contact_run_advance(contact_run* run, double time);
double contact_run_time(const contact_run* run);     /* s; NaN of NULL */
double contact_run_end_time(const contact_run* run); /* s; NaN of NULL */

/* The columns of hinge-separation's history
 * (libcontact/docs/reference/separation_output.md): modes, angles, reactions,
 * pressures, positions, velocities, distances, energies. */
size_t contact_run_column_count(const contact_run* run);
/* NULL behind the last one. Valid until the run is restored or freed. */
const char* contact_run_column(const contact_run* run, size_t i);
/* CONTACT_BAD_INPUT if there is none of that name. */
contact_status contact_run_find_column(const contact_run* run, const char* name,
                                       size_t* i);
/* The values of all columns at contact_run_time(). */
contact_status contact_run_values(const contact_run* run, double* values,
                                  size_t count);
/* The history so far: rows of contact_run_column_count() numbers at the case's
 * output times and events. NULL behind the last one; valid until the run goes
 * on, is restored or freed. */
size_t contact_run_row_count(const contact_run* run);
const double* contact_run_row(const contact_run* run, size_t i);

/* Event of a run: "release: axis breaks". */
typedef struct contact_event {
  double time; /* s */
  const char* body;
  const char* what;
} contact_event;
size_t contact_run_event_count(const contact_run* run);
/* Its texts are valid as long as a row. */
contact_status contact_run_event(const contact_run* run, size_t i,
                                 contact_event* event);

/* Notes on the joints so far: which leave the theory, or what their materials
 * bear, and what the model of a seat leaves out at rims that were come near to.
 * One sentence per line, cut to `size` with its final 0. */
contact_status contact_run_notes(const contact_run* run, char* text,
                                 size_t size);

/* A run that goes on from here as this one does, to the last bit. To take a
 * copy begins the steps of both anew, as contact_run_save() does. */
contact_status contact_run_copy(contact_run* run, contact_run** copy);

/* All that a run of the same file and settings needs to go on from here, as
 * bytes, with its history; give them back by contact_free(). To save begins the
 * steps anew: this run and restored ones then go on the same to the last bit,
 * and differ from one that was never saved by the tolerances. */
contact_status contact_run_save(contact_run* run, void** bytes, size_t* size);
contact_status contact_run_restore(contact_run* run, const void* bytes,
                                   size_t size);
void contact_free(void* bytes);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
