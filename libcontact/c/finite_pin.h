/* Pins that end, tilt and are relieved (docs/finite_pin.md). */
#ifndef LIBCONTACT_C_FINITE_PIN_H
#define LIBCONTACT_C_FINITE_PIN_H

#include <stddef.h>

#include "libcontact/c/joint.h"
#include "libcontact/c/quantity.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct contact_finite_pin contact_finite_pin;

/* Makes the table of its slices' law, which takes 0.01 to 0.5 s.
 * CONTACT_BAD_INPUT for a ball, friction that is not dry, a relief that does
 * not fit, and a pin in an infinite hole. */
contact_status contact_finite_pin_make(const contact_joint* joint,
                                       contact_finite_pin** pin);
void contact_finite_pin_free(contact_finite_pin* pin);

/* A pin that turns and slides under a reaction. z is the hole's axis from the
 * middle of the contact, x and y are across; set all that is not used to 0. */
typedef struct contact_finite_pin_load {
  double reaction[2]; /* R on the body, N */
  double rate;        /* turn of the body about z, rad/s: its sign counts */
  double tilt[2];     /* known slope of the pin's axis */
  int is_placed; /* the reaction acts at z = place, and the tilt is found */
  double place;  /* m */
  double axial_velocity; /* speed of the body along z, m/s */
} contact_finite_pin_load;

typedef struct contact_finite_pin_solution {
  contact_status status;
  int iterations;
  int pieces;      /* contacts along z */
  double residual; /* error of the load over its size */

  double shift[2];        /* shift of the pin's axis at z = 0, m */
  double tilt[2];         /* slope of the pin's axis */
  double force[2];        /* F of the pressures on the hole, N */
  double force_moment[2]; /* G = sum of z F(z), N m */
  double energy;          /* U, J; F = dU/d shift, G = dU/d tilt */
  /* Derivatives of F and G by shift and tilt; symmetric. */
  double stiffness[16];

  double low; /* outermost ends of the contacts, m; NaN without contact */
  double high;
  double peak_pressure;      /* Pa */
  double peak_place;         /* z of it, m */
  double largest_half_angle; /* rad */
  double half_angle_place;   /* z of it, m */
  double end_pressure[2];    /* at -length/2 and length/2, Pa */
  double end_half_angle[2];  /* rad */

  double friction_force[2];    /* R_t on the body, N */
  double axial_friction_force; /* along z, N */
  double moment[3]; /* about the middle, N m: x and y of the contact with
                       friction, z of friction */
} contact_finite_pin_solution;

/* Numbers to 1e-8, with liners thinner than 0.05 radii to 5e-8.
 * CONTACT_OUT_OF_RANGE beyond the end of the slices' law. */
contact_status contact_finite_pin_solve(const contact_finite_pin* pin,
                                        const contact_finite_pin_load* load,
                                        contact_finite_pin_solution* solution);

/* As in quantity.h. */
const contact_quantity* contact_finite_pin_quantity(size_t i);
contact_status contact_finite_pin_get(
    const contact_finite_pin_solution* solution, const char* key,
    double* value);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
