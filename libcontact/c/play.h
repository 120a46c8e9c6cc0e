/* SPDX-License-Identifier: MIT */
/* Joints with play: the force law of a clearance, impacts, and the joint as a
 * force without constraint (docs/how-to/play.md). */
#ifndef LIBCONTACT_C_PLAY_H
#define LIBCONTACT_C_PLAY_H

#include <stddef.h>

#include "libcontact/c/joint.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct contact_play contact_play;

/* Set all that is not used to 0. */
typedef struct contact_play_options {
  double damping; /* a of F (1 + a d penetration/dt), s/m; or by the next two */
  double restitution;          /* 0 to 1; 0: by damping */
  double reference_speed;      /* at which it is that, m/s */
  double regularisation_speed; /* for friction, m/s; 0: 0.001 */
} contact_play_options;

/* Makes the table of the force law, which takes 0.01 to 0.5 s.
 * CONTACT_BAD_INPUT for a pin in an infinite hole, loading through the back,
 * and friction that is not dry. options: NULL for no damping. */
contact_status contact_play_make(const contact_joint* joint,
                                 const contact_play_options* options,
                                 contact_play** play);
void contact_play_free(contact_play* play);

/* The force law at a penetration, m from first touch; all 0 (force_ratio 1)
 * below 0, CONTACT_OUT_OF_RANGE above contact_play_largest_penetration(). */
typedef struct contact_force_state {
  double force;            /* N */
  double slope;            /* dF/d penetration, N/m */
  double energy;           /* J, whose derivative the force is */
  double half_angle;       /* theta0, rad */
  double force_ratio;      /* S */
  double half_angle_slope; /* rad/m */
} contact_force_state;
contact_status contact_play_force_law(const contact_play* play,
                                      double penetration,
                                      contact_force_state* state);
contact_status contact_play_largest_penetration(const contact_play* play,
                                                double* penetration);

/* One impact without forces other than the contact's. */
typedef struct contact_impact {
  double restitution;
  double penetration;      /* the largest, m */
  double elastic_force;    /* there, N */
  double peak_force;       /* with damping, N */
  double half_angle;       /* at the largest penetration, rad */
  double peak_pressure;    /* the largest, with damping, Pa */
  double compression_time; /* s */
  double restitution_time; /* s */
} contact_impact;
/* mass: kg, of two bodies m1 m2/(m1 + m2); speed: at touch, m/s. */
contact_status contact_play_impact(const contact_play* play, double mass,
                                   double speed, contact_impact* impact);

/* The ball or pin relative to its seat, in a frame fixed to the seat. */
typedef struct contact_play_motion {
  double position[3]; /* from the seat's centre to the ball's or pin's, m */
  double velocity[3]; /* its derivative, m/s */
  double angular_velocity[3]; /* rad/s */
  double axis[3];             /* unit vector; pins only */
} contact_play_motion;
/* Load on the ball or pin; the seat has, about its centre, -force and
 * -moment - position x force. */
typedef struct contact_play_force {
  double force[3];       /* N */
  double moment[3];      /* about the centre of the ball or pin, N m */
  double penetration;    /* m; its zero is touching and parting */
  double normal_force;   /* N */
  double energy;         /* J */
  double damping_power;  /* W */
  double friction_power; /* W */
} contact_play_force;
/* derivatives: of force and moment (6 rows) over position, velocity and angular
 * velocity (9 columns), by rows; may be NULL. */
contact_status contact_play_evaluate(const contact_play* play,
                                     const contact_play_motion* motion,
                                     contact_play_force* force,
                                     double derivatives[54]);

/* Notes on where a motion or an impact leaves the model, one sentence per line,
 * cut to `size` with its final 0; empty if it does not. density: kg/m^3, 0 if
 * it is not known. */
contact_status contact_play_motion_notes(const contact_play* play,
                                         const contact_play_motion* motion,
                                         char* text, size_t size);
contact_status contact_play_impact_notes(const contact_play* play, double mass,
                                         double speed, double density,
                                         char* text, size_t size);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
