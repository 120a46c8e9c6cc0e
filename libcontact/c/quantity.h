/* SPDX-License-Identifier: MIT */
/* Quantities of results by name, as in Python and in columns of programs. */
#ifndef LIBCONTACT_C_QUANTITY_H
#define LIBCONTACT_C_QUANTITY_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/slip.h"
#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct contact_quantity {
  const char* key;     /* "friction_moment" */
  const char* symbol;  /* "M_t"; "" if there is none */
  const char* unit;    /* "N m"; "" if there is none */
  const char* meaning; /* "friction moment on the body about ..." */
  size_t size;         /* how many numbers: 3 of a vector, else 1 */
} contact_quantity;

/* Quantity i of a result; NULL behind the last one. */
const contact_quantity* contact_solution_quantity(size_t i);
const contact_quantity* contact_rest_quantity(size_t i);
const contact_quantity* contact_patch_quantity(size_t i);
const contact_quantity* contact_rating_quantity(size_t i);

/* A quantity by its key, `size` numbers; NaN where it has no meaning, as angles
 * at rest. CONTACT_BAD_INPUT for a key that is not there. */
contact_status contact_solution_get(const contact_solution* solution,
                                    const char* key, double* value);
contact_status contact_rest_get(const contact_rest* rest, const char* key,
                                double* value);
/* Quantity of a contact under a normal force R_n, N, above 0; with interference
 * 0 too, where it has its "unloaded_moment", N m, and the like at any load. */
contact_status contact_patch_get(const contact_joint* joint,
                                 double normal_force, const char* key,
                                 double* value);

/* p v and heat over the contact of a slip and its solution
 * (docs/how-to/duty.md); computed anew at each call. At a rim of a seat there
 * are pv_max, 0.02 radii (report_distance) or more from every rim, pv_total, to
 * 5e-3 and 1e-3, and heat. */
contact_status contact_rating_get(const contact_joint* joint,
                                  const contact_slip* slip,
                                  const contact_solution* solution,
                                  const char* key, double* value);

/* A joint that friction holds (docs/explanation/presliding.md): what its
 * quantities are made from. */
typedef struct contact_stuck {
  double load_stiffness;  /* K_load, N m/rad: the load stays */
  double held_stiffness;  /* K_held, N m/rad: the centre stays */
  double spin_stiffness;  /* K_spin, N m/rad: about the load; NaN of a pin */
  double friction_moment; /* M_s, N m: of slow sliding across the load */
  double shape;           /* b of the way to sliding */
} contact_stuck;
/* Its contact under R_n, N, above 0, in some 10 ms: to 5e-4, M_s and b as
 * stuck_joint() says. Numbers that do not exist are NaN, K_held of a pin in an
 * infinite hole; CONTACT_OUT_OF_RANGE if there is no K_load: with interference,
 * half-angles outside 0.01 to 3.1 rad, layers below 1e-3 radii. */
contact_status contact_joint_stuck(const contact_joint* joint,
                                   double normal_force, contact_stuck* stuck);
const contact_quantity* contact_stuck_quantity(size_t i);
contact_status contact_stuck_get(const contact_stuck* stuck, const char* key,
                                 double* value);
/* Notes on limits of the stiffness under R_n, one sentence per line,
 * cut to `size` with its final 0. */
contact_status contact_joint_stuck_notes(const contact_joint* joint,
                                         double normal_force, char* text,
                                         size_t size);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
