/* SPDX-License-Identifier: MIT */
/* Contacts that end, of balls in a [seat] (docs/explanation/seats.md) and pins
 * of finite length (docs/how-to/finite_pin.md), and any quantity of any joint
 * by its key. */
#ifndef LIBCONTACT_C_ENDS_H
#define LIBCONTACT_C_ENDS_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/quantity.h"
#include "libcontact/c/slip.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* How the halves lie to each other. Set all that is not used to 0. */
typedef struct contact_placement {
  size_t size; /* sizeof(contact_placement) */
  /* Rotation from the axes of the body with the seat to the axes of the
   * vectors, row by row; all 0: the same axes. */
  double from_seat[9];
  double tilt[3]; /* known slope of a pin's axis in its hole */
  int is_placed;  /* the reaction acts at `place`, and the tilt is found */
  double place;   /* along the pin from its middle, m */
  double axial_velocity; /* velocity of the body along a pin's axis, m/s */
} contact_placement;

/* The solution that was found last, of one joint and one thread at a time. */
typedef struct contact_memory contact_memory;
/* Makes an empty one: the first solution begins from nothing. */
contact_status contact_memory_make(contact_memory** memory);
void contact_memory_free(contact_memory* memory);

/* `count` quantities of a slip by their keys, one behind the other, a vector as
 * three numbers. NaN where there is none, as of an angle about the contact's
 * axis at a rim.
 * placement: NULL: the vectors are in the axes of the seat, and a pin is level
 *     and infinite. Its vectors are in the frame of the call; a pin that has
 *     one ends, level or tilted, and requires slip.axis or a turn, dry
 *     friction, clearance and a wall with an end.
 * memory: NULL, or the last solution, to begin from, which this one replaces: a
 *     contact at a rim takes a third to two thirds of the time (13 ms for 24 to
 *     39 ms) if R and Dw have changed by less than 1 %. Both agree within
 *     the accuracy of the seat's grid. A call that is not CONTACT_OK leaves
 *     the memory as it was. */
contact_status contact_joint_get(const contact_joint* joint,
                                 const contact_slip* slip,
                                 const contact_placement* placement,
                                 contact_memory* memory,
                                 const char* const* keys, size_t count,
                                 double* values);
/* Quantity i of a slip: first of solutions (contact_solution_quantity()), then
 * of the rims of a seat, then of finite-length pins; NULL after the last. */
const contact_quantity* contact_joint_quantity(size_t i);

/* Pressures of a solution, Pa, at `count` places: unit vectors from the joint's
 * centre, three numbers each. 0 outside the contact, infinite at a rim that is
 * reached, as exact as SeatContact::pressure(). A contact that is at a rim is
 * found anew, in some 30 ms; so it is by contact_joint_solution_notes(),
 * contact_rating_get(), contact_joint_edge() and the like. */
contact_status contact_joint_pressures(const contact_joint* joint,
                                       const contact_solution* solution,
                                       const double* places, size_t count,
                                       double* pressures);

/* The joint whose contact goes on beyond the rims of its seat: for comparison,
 * and where the direction of the load is unknown. A [seat] with a friction that
 * it cannot have is left out by the setting {"seat.left_out", "true"}. */
contact_status contact_joint_without_seat(const contact_joint* joint,
                                          contact_joint** endless);

/* The joint with a table of the contacts between these loads, N, that reach a
 * rim: made in 7 to 20 s; each is then read in some 20 us, to 1e-3 of the load.
 * CONTACT_BAD_INPUT for a joint without [seat]. */
contact_status contact_joint_tabulate(const contact_joint* joint,
                                      double least_load, double most_load,
                                      contact_joint** tabulated);
/* The table in `size` bytes, for a program to keep; valid as long as the joint.
 * NULL, and 0 bytes, of a joint without one. */
const char* contact_joint_table(const contact_joint* joint, size_t* size);
/* Largest error that 100 random states of the table have shown, over the load;
 * NaN without a table. */
double contact_joint_table_error(const contact_joint* joint);
/* The joint with a table that contact_joint_table() gave of the same joint. */
contact_status contact_joint_set_table(const contact_joint* joint,
                                       const char* table, size_t size,
                                       contact_joint** tabulated);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
