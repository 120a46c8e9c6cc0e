/* Balls in seats that end: rings, cups, sockets (docs/seats.md). */
#ifndef LIBCONTACT_C_SEAT_H
#define LIBCONTACT_C_SEAT_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/quantity.h"
#include "libcontact/c/slip.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* A joint whose contact is confined to its [seat]. */
typedef struct contact_seat contact_seat;

/* Set all that is not used to 0. */
typedef struct contact_seat_options {
  /* N: a table of the contacts between these loads that reach a rim is made, in
   * 7 to 20 s; each is then read in some 10 us, to 1e-3 of the load. 0: none */
  double least_load;
  double most_load;
  /* Table that contact_seat_table() gave of the same joint, instead. */
  const char* table;
  size_t table_size; /* bytes */
} contact_seat_options;

/* Takes some milliseconds, the first contact at a rim 0.1 to 1 s, and much
 * more with a table. CONTACT_BAD_INPUT for a joint
 * without [seat], a friction stress, loading through the back, layers thinner
 * than 0.001 radii, and a table that is of another joint. options: NULL for no
 * table. */
contact_status contact_seat_make(const contact_joint* joint,
                                 const contact_seat_options* options,
                                 contact_seat** seat);
void contact_seat_free(contact_seat* seat);

/* The table in `size` bytes, for a program to keep; valid as long as the seat.
 * NULL, and 0 bytes, of a seat without one. */
const char* contact_seat_table(const contact_seat* seat, size_t* size);
/* Largest error that 100 random states of the table have shown, over the load;
 * NaN without a table. */
double contact_seat_table_error(const contact_seat* seat);

typedef enum contact_seat_status {
  CONTACT_SEAT_OK = 0,
  CONTACT_SEAT_NOT_CONVERGED = 1,
  CONTACT_SEAT_OUT_OF_SEAT = 2, /* no pressure on the seat carries the load */
  CONTACT_SEAT_NO_LOAD = 3
} contact_seat_status;

/* At a rim of the seat. */
typedef struct contact_seat_rim {
  double intensity; /* K = lim p sqrt(2 pi s), Pa m^0.5; 0: not reached */
  double longitude; /* place where K is largest, rad, 0 or pi */
  double half_arc;  /* over which the contact follows the rim, rad */
  /* On the rounding of edge_radius: largest p, Pa, and how far the contact goes
   * on beyond the rim as drawn, m. NaN: sharp, or not reached. */
  double peak_pressure;
  double reach;
  double distance; /* to the rim in the plane of the load, rad; 0: reached,
                      infinite: there is none */
  double gap;      /* the same along the seat, m */
} contact_seat_rim;

/* Vectors are in the axes of the body that has the seat, as the seat's axis is;
 * forces and moments act on the body. Polar angles are counted from the seat's
 * axis, longitudes from the plane of the load. */
typedef struct contact_seat_solution {
  contact_seat_status status;
  int is_free;     /* the contact reaches no rim: the exact laws answer */
  int evaluations; /* contacts that were found */

  double reaction[3];       /* R, N */
  double seat_force[3];     /* F on the seat, N: R = F + R_t, or -F + R_t if the
                               body has the ball */
  double friction_force[3]; /* R_t, N */
  double friction_moment[3]; /* M_t about the ball's centre, N m */
  double power;              /* M_t . Dw, W, never positive */
  double moment_coefficient; /* |M_t|/(rho R) */
  double nominal_area;       /* the area of catalogues, m^2 */

  double shift[3];         /* shift of the ball's centre from concentric, m */
  double pressure_at_load; /* pressure where F pierces the seat, Pa */
  /* Largest p report_distance off rims, Pa; NaN where it is below the mean
   * pressure: the contact lies nearer to a rim. */
  double peak_pressure;
  double peak_polar_angle; /* its place, rad */
  double peak_longitude;
  double lower_end; /* ends of the contact in the plane of the load, rad */
  double upper_end;
  double half_width;        /* from F to its end across that plane, rad */
  double force_ratio;       /* S, sum of the pressures over F */
  double contact_area;      /* m^2 */
  contact_seat_rim rims[2]; /* lower, upper */
} contact_seat_solution;

/* Friction under a reaction while the halves turn; the slip's axis is left out.
 * CONTACT_OUT_OF_RANGE, with the reason as message, where the seat carries no
 * such load. */
contact_status contact_seat_solve(const contact_seat* seat,
                                  const contact_slip* slip,
                                  contact_seat_solution* solution);

/* The contact that was found last, of one seat and one thread at a time. */
typedef struct contact_seat_memory contact_seat_memory;
/* Empty: the first solution begins from nothing. */
contact_status contact_seat_memory_make(contact_seat_memory** memory);
void contact_seat_memory_free(contact_seat_memory* memory);
/* The same begun from the memory, which then has this solution: a contact at a
 * rim takes a third to two thirds of the time (13 ms for 24 to 39 ms) where R
 * and Dw have changed by less than 1 %. Both agree within the accuracy of the
 * seat's grid. A refused call leaves the memory as it was. */
contact_status contact_seat_solve_from(const contact_seat* seat,
                                       const contact_slip* slip,
                                       contact_seat_memory* memory,
                                       contact_seat_solution* solution);

typedef struct contact_seat_rest {
  double utilisation;  /* the joint holds if it is <= 1 */
  double direction[3]; /* unit: in which it would begin to slide */
  /* The sliding about it at 1 rad/s, whose moment is M/utilisation. */
  contact_seat_solution slip;
} contact_seat_rest;
/* Decides whether the joint rests under R while holding M. Viscous friction
 * holds nothing: utilisation is infinite. NaN where no direction was found. */
contact_status contact_seat_at_rest(const contact_seat* seat,
                                    const contact_hold* hold,
                                    contact_seat_rest* rest);

/* Pressures of a solution, Pa, at `count` places: unit vectors from the ball's
 * centre, three numbers each. Never below 0, 0 outside the contact, infinite at
 * a rim that is reached, as exact as SeatContact::pressure(). A contact that is
 * at a rim is found anew by each call, in some 10 ms. */
contact_status contact_seat_pressure(const contact_seat* seat,
                                     const contact_seat_solution* solution,
                                     const double* places, size_t count,
                                     double* pressure);

/* p v over the contact of a solution, and where it is largest. */
typedef struct contact_seat_rating {
  double pv_total; /* integral of p v over the contact, W */
  double pv_max;   /* the largest report_distance off rims, W/m^2: at a rim
                      itself p v is infinite, what wears there is unknown */
  double pv_max_place[3]; /* unit vector from the ball's centre to it */
} contact_seat_rating;
/* p v of a solution for this slip, to 1e-3 and 5e-3; of a contact that reaches
 * no rim by the exact law. A contact at a rim is found anew, in some 10 ms. */
contact_status contact_seat_rate(const contact_seat* seat,
                                 const contact_seat_solution* solution,
                                 const contact_slip* slip,
                                 contact_seat_rating* rating);

/* Notes on a solution, one sentence per line, cut to `size` with its final 0:
 * why there is none, and beside a rim what the model leaves out, up to 18 %. */
contact_status contact_seat_notes(const contact_seat* seat,
                                  const contact_seat_solution* solution,
                                  char* text, size_t size);

/* As in quantity.h. */
const contact_quantity* contact_seat_solution_quantity(size_t i);
contact_status contact_seat_solution_get(const contact_seat_solution* solution,
                                         const char* key, double* value);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
