/* SPDX-License-Identifier: MIT */
/* Steps of a simulator with joints that slide, come to rest, hold and let go.
 */
#ifndef LIBCONTACT_C_STEP_H
#define LIBCONTACT_C_STEP_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/slip.h"
#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* A joint at the start of a step. */
typedef struct contact_step_start {
  double reaction[3];         /* R on the body, N, of the step before */
  double angular_velocity[3]; /* Dw, rad/s; exactly 0: it rests */
  double free[3]; /* Dw at the end of the step if it had no friction, rad/s */
  double axis[3]; /* unit axis of a pin; 0: the axis of Dw or `free` */
} contact_step_start;

/* The same joint at its end. */
typedef struct contact_step {
  contact_status status;
  int holds;                  /* it has come to rest, or rests on */
  double angular_velocity[3]; /* Dw, rad/s; exactly 0 where the joint holds */
  double moment[3];           /* M_t on the body during the step, N m */
  contact_solution solution;  /* friction at the start */
  contact_rest rest;          /* if the joint rested: what it had to hold */
} contact_step;

/* One implicit step: M_t = W (Dw - free), M_t opposite to Dw. A torque of
 * contact_joint_solve() alone never stops a body, it creeps; here it stops, and
 * stays as long as the joint holds it. n, R_n and theta0 are those at the
 * start. inertia: W, row by row: inertia about the joint over the time step, N
 * m s, symmetric (to 1e-6) and positive definite, else CONTACT_BAD_INPUT; of a
 * pin its part along the axis counts. last: NULL, or the step before, from
 * which this one is found faster; it may be `step` itself. */
contact_status contact_joint_step(const contact_joint* joint,
                                  const contact_step_start* start,
                                  const double inertia[9],
                                  const contact_step* last, contact_step* step);

/* How steps of several joints have come to fit each other. */
typedef struct contact_sweeps {
  contact_status status;
  int sweeps;
  double residual; /* change of a moment in the last sweep, over W free */
} contact_sweeps;

/* The same of joints of one mechanism: M_i = sum_j W_ij (Dw_j - free_j), by
 * Newton steps and sweeps over the joints until the residual is 1e-12.
 * inertia: W, mass matrix over the time step in the joints' angular velocities,
 *     three rows for a ball and one, about its axis, for a pin. Whether it is
 *     symmetric and the joints' blocks positive definite is looked at.
 * steps: in: of the step before, or all 0; a better guess of Dw than `starts`
 *     has may replace it, for speed; out: the result.
 * sweeps: NULL, or the report on them. */
contact_status contact_joints_step(const contact_joint* const* joints,
                                   size_t count,
                                   const contact_step_start* starts,
                                   const double* inertia, contact_step* steps,
                                   contact_sweeps* sweeps);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
