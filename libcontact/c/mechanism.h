/* SPDX-License-Identifier: MIT */
/* Steps of a simulator's mechanism whose joints have friction, in the
 * simulator's own generalized rates. */
#ifndef LIBCONTACT_C_MECHANISM_H
#define LIBCONTACT_C_MECHANISM_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/status.h"
#include "libcontact/c/step.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* The simulator solves H q'' = forces + J^T lambda + friction; friction and the
 * constraints are found in turns. In each step, `force` being 0 at first:
 *
 *     contact_mechanism_weigh(); contact_mechanism_begin();
 *     do { contact_mechanism_turn(); q'' with `force`; weigh again; }
 *     while there are constraints and `change` is above 1e-8
 *
 * The rates of joints that hold are exactly 0 at the end of the step: the
 * simulator has to keep them and their angles as they are. apps/hosts/mujoco is
 * such a simulator. One step at a time: not for two threads at once. */
typedef struct contact_mechanism contact_mechanism;

/* A joint in the rates: Dw of a ball in any axes, three from `first`; the rate
 * of a pin about its axis, one. The joint must stay. */
typedef struct contact_mechanism_joint {
  const contact_joint* joint;
  size_t first;
} contact_mechanism_joint;

/* A joint as a step begins. */
typedef struct contact_mechanism_start {
  double reaction[3];  /* R on the body, N, of the step before: of a ball in the
                          axes of its rates, for a pin in the axes of `axis` */
  double axis[3];      /* unit axis of a pin */
  double from_seat[9]; /* for a ball with a [seat], row by row: rotation from
                          the axes of the body with the seat to the axes of the
                          rates; all 0: they coincide */
} contact_mechanism_start;

/* size: of the generalized rates. */
contact_status contact_mechanism_make(const contact_mechanism_joint* joints,
                                      size_t count, size_t size,
                                      contact_mechanism** mechanism);
void contact_mechanism_free(contact_mechanism* mechanism);

/* The mass matrix as it is now.
 * inertia: H, size x size, with dt times the dampings.
 * rows, stiffness: J, count x size, row by row, and D of the constraints whose
 *     force is linear in the acceleration now: they count in H as J^T D J.
 * time_step: dt, s. */
contact_status contact_mechanism_weigh(contact_mechanism* mechanism,
                                       const double* inertia,
                                       const double* rows,
                                       const double* stiffness, size_t count,
                                       double time_step);

/* starts: of all joints. rates: q'. likely: those that the step will end with,
 * as far as they can be guessed, for speed. */
contact_status contact_mechanism_begin(contact_mechanism* mechanism,
                                       const contact_mechanism_start* starts,
                                       const double* rates,
                                       const double* likely);

/* rates_at_end: q' + dt q'' with `force`. force: generalized force of friction,
 * in and out, changed in the joints' rates alone. change: NULL, or what the
 * force has changed by, over itself. */
contact_status contact_mechanism_turn(contact_mechanism* mechanism,
                                      const double* rates_at_end, double* force,
                                      double* change);

/* The force with which the joints' rates would stay as they are, for the
 * reactions of the first step: rates, rates_at_end as above with no friction.
 */
contact_status contact_mechanism_hold(const contact_mechanism* mechanism,
                                      const double* rates,
                                      const double* rates_at_end,
                                      double* force);

/* The i-th joint in the last turn, in the axes of its rates. sweeps: NULL, or
 * how all of them have come to fit. */
contact_status contact_mechanism_get(const contact_mechanism* mechanism,
                                     size_t i, contact_step* step,
                                     contact_sweeps* sweeps);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
