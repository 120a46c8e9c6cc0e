/* SPDX-License-Identifier: MIT */
/* Moments for iterative solvers of several bodies: those that a contact holds,
 * and how friction answers to its causes. */
#ifndef LIBCONTACT_C_MOMENTS_H
#define LIBCONTACT_C_MOMENTS_H

#include "libcontact/c/joint.h"
#include "libcontact/c/slip.h"
#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* The friction moments of a ball's solution at fixed n, R_n and theta0 are a
 * convex set. CONTACT_BAD_INPUT for a pin, whose moments are those up to that
 * of its solution; CONTACT_OUT_OF_RANGE for friction that falls with the speed.
 */

/* Moment of the set that opposes an angular velocity, rad/s, most. */
typedef struct contact_edge {
  double power;     /* the largest -M_t . Dw, W */
  double moment[3]; /* M_t of it, N m */
} contact_edge;
contact_status contact_joint_edge(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double angular_velocity[3],
                                  contact_edge* edge);

/* How a moment on the body, N m, lies to the set. */
typedef struct contact_held {
  double utilisation; /* it is held if this is <= 1 */
  double nearest[3];  /* moment of the set, N m */
} contact_held;
contact_status contact_joint_held(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double moment[3], contact_held* held);

/* The motion that friction leaves of a free one: M_t = W (alpha - free). */
typedef struct contact_prox {
  contact_status status;
  int iterations;             /* Newton steps; 0 where the joint holds */
  double residual;            /* equation's, over |W free| */
  double angular_velocity[3]; /* alpha; exactly 0 where the joint holds */
  double moment[3];           /* M_t on the body, N m */
} contact_prox;
/* inertia: W, row by row, symmetric and positive definite: inertia about the
 *     joint, or that over the time step.
 * free: relative angular acceleration without friction, rad/s^2, or angular
 *     velocity, rad/s. */
contact_status contact_joint_prox(const contact_joint* joint,
                                  const contact_solution* solution,
                                  const double inertia[9], const double free[3],
                                  contact_prox* prox);

/* How M_t of a sliding joint answers, row by row; rows are parts of M_t. For
 * implicit integrators. */
typedef struct contact_derivatives {
  double over_rate[9];     /* dM_t/dDw under a known reaction, N m s */
  double over_reaction[9]; /* dM_t/dR, m */
  double at_contact[9];    /* dM_t/dDw at fixed n, R_n and theta0, N m s */
} contact_derivatives;
/* solution: the solution of the slip. CONTACT_OUT_OF_RANGE at rest, and for a
 * solution that is not CONTACT_OK. */
contact_status contact_joint_derivatives(const contact_joint* joint,
                                         const contact_slip* slip,
                                         const contact_solution* solution,
                                         contact_derivatives* derivatives);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
