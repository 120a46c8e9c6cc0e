/* SPDX-License-Identifier: MIT */
/* Joints that slide or rest under a known reaction. */
#ifndef LIBCONTACT_C_SLIP_H
#define LIBCONTACT_C_SLIP_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

typedef enum contact_state {
  CONTACT_SLIDING = 0,
  CONTACT_RESTING = 1, /* angular velocity exactly 0: no friction */
  CONTACT_UNLOADED = 2 /* no reaction, no interference: no friction */
} contact_state;

/* Forces and moments act on the body, the opposite ones on the carrier. */
typedef struct contact_solution {
  contact_status status;
  contact_state state;
  int evaluations; /* evaluations of the contact's friction */
  double residual; /* estimate of |f/tan g - 1| that is left */

  double reaction[3];        /* R = R_n n + R_t, N */
  double normal[3];          /* n, unit */
  double normal_force;       /* R_n, N */
  double friction_force[3];  /* R_t, N */
  double friction_moment[3]; /* M_t about the joint's centre, N m */
  double textbook_moment;    /* f0 rho R of dry friction, else NaN, N m */
  double slip_velocity[3];   /* at the contact's centre, m/s */
  double power;              /* M_t . Dw, W, never positive */

  double reaction_angle;  /* b of R and Dw, rad, [0, pi] */
  double friction_angle;  /* g, rad, [0, pi/2], tan g = R_t/R_n */
  double slip_axis_angle; /* a, rad, [-pi/2, pi/2] */

  double force_coefficient;    /* R_t/R_n = f */
  double sliding_coefficient;  /* moment normal to n over -rho R_n */
  double spinning_coefficient; /* moment about n over -rho R_n */
  double adhesion_number;      /* A rho^2/(f0 R_n) */

  double load_parameter; /* mu or lambda */
  double half_angle;     /* theta0, rad */
  double peak_pressure;  /* Pa */
  double contact_area;   /* m^2 */

  double memory[20]; /* for the next solution, which starts from this one */
} contact_solution;

/* sizeof(contact_solution) of the library, which differs from a program's if
 * its headers are of another version. */
size_t contact_solution_size(void);

typedef struct contact_slip {
  double reaction[3];         /* R on the body, N */
  double angular_velocity[3]; /* Dw of the body against the carrier, rad/s */
  double axis[3];             /* unit axis of a pin; 0: the axis of Dw */
} contact_slip;

/* Friction under a reaction while the halves turn.
 * last: NULL, or the solution for a similar slip of the same joint, from which
 * it is found faster; it may be `solution` itself. */
contact_status contact_joint_solve(const contact_joint* joint,
                                   const contact_slip* slip,
                                   const contact_solution* last,
                                   contact_solution* solution);
/* Friction under a known normal force R_n n, given as the slip's reaction. */
contact_status contact_joint_solve_contact(const contact_joint* joint,
                                           const contact_slip* known,
                                           contact_solution* solution);

/* Reasons to doubt a solution, one sentence per line, cut to `size` with its
 * final 0: what the model leaves out beside a rim of the seat; how
 * far the contact goes beyond a rim in a joint without its seat. None if it is
 * not CONTACT_OK: the message of its call has said why. */
contact_status contact_joint_solution_notes(const contact_joint* joint,
                                            const contact_solution* solution,
                                            char* text, size_t size);

/* Many slips. A stride is the number of bytes from one row to the next; with 0
 * all rows use the first one. */
typedef struct contact_slips {
  size_t count;
  const double* reaction;
  ptrdiff_t reaction_stride;
  const double* angular_velocity;
  ptrdiff_t angular_velocity_stride;
  const double* axis; /* NULL: no axis */
  ptrdiff_t axis_stride;
  int warm;         /* each row starts from the one before */
  double tolerance; /* stop at this residual; 0: 1e-13 */
} contact_slips;
/* All rows are solved whatever comes of some of them; returns the first status
 * that is not CONTACT_OK, and the message names it. A refused call says so in
 * the first solution.
 * stride: bytes from one solution to the next. */
contact_status contact_joint_solve_rows(const contact_joint* joint,
                                        const contact_slips* slips,
                                        contact_solution* solutions,
                                        ptrdiff_t stride);

typedef struct contact_hold {
  double reaction[3]; /* R on the body, N */
  double moment[3];   /* M on the body that friction has to supply, N m */
  double axis[3];     /* unit axis of a pin; 0: the axis of M */
} contact_hold;
typedef struct contact_rest {
  contact_status status;
  int solves;          /* sliding solutions that were needed */
  double utilisation;  /* the joint holds if it is <= 1 */
  double direction[3]; /* unit: in which it would begin to slide */
  /* The sliding about it at 1 rad/s, whose moment is M/utilisation. */
  contact_solution slip;
} contact_rest;
/* Decides whether the joint rests under R while holding M. A viscous joint
 * holds nothing: its utilisation is infinite.
 * last: as above. */
contact_status contact_joint_at_rest(const contact_joint* joint,
                                     const contact_hold* hold,
                                     const contact_rest* last,
                                     contact_rest* rest);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
