/* SPDX-License-Identifier: MIT */
/* Joints and their contacts: half-angle, pressure, friction coefficients. */
#ifndef LIBCONTACT_C_JOINT_H
#define LIBCONTACT_C_JOINT_H

#include <stddef.h>

#include "libcontact/c/status.h"

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct contact_joint contact_joint;

/* From a joint file (docs/reference/joint_file.md). CONTACT_BAD_INPUT with the
 * line and key that are wrong, or without friction. */
contact_status contact_joint_read(const char* path,
                                  const contact_setting* settings, size_t count,
                                  contact_joint** joint);
/* From the text of one. folder: what paths in it are relative to; NULL: the
 * working directory. */
contact_status contact_joint_parse(const char* text, const char* folder,
                                   const contact_setting* settings,
                                   size_t count, contact_joint** joint);

typedef enum contact_kind { CONTACT_BALL = 0, CONTACT_PIN = 1 } contact_kind;

typedef struct contact_material {
  double youngs_modulus; /* Pa, above 0; infinite: rigid (one of the two) */
  double poissons_ratio; /* 0 to 0.5 */
} contact_material;

/* Set all that is not used to 0. What is not here (walls, coatings, loading
 * through the back) a text can say. */
typedef struct contact_joint_numbers {
  int kind;                /* a contact_kind */
  int body_has_inner;      /* the body has the ball or pin; 0: the carrier */
  double radius;           /* rho of the ball or pin, m */
  double radial_clearance; /* difference of the radii, m; < 0: interference */
  double length;           /* contact length of a pin, m */
  contact_material inner;  /* ball or pin */
  contact_material outer;  /* seat or hole */
  /* Friction stress f0 p + A (dry), or (k0 + k1 p) v (viscous != 0). */
  int viscous;
  double coefficient;      /* f0 */
  double adhesion;         /* A, Pa */
  double viscous_constant; /* k0, Pa s/m */
  double viscous_slope;    /* k1, s/m */
  /* Names as in the files; NULL: "fitted", with interference "exact", and
   * "exact". */
  const char* half_angle_law;
  const char* pressure_law;
} contact_joint_numbers;

contact_status contact_joint_make(const contact_joint_numbers* numbers,
                                  contact_joint** joint);
/* Builds with assertions refuse joints that have been freed. */
void contact_joint_free(contact_joint* joint);

/* Numbers of a joint, however it was made. */
typedef struct contact_joint_size {
  int kind;                 /* a contact_kind */
  int body_has_inner;       /* the body has the ball or pin; 0: the carrier */
  double radius;            /* rho of the ball or pin, m */
  double radial_clearance;  /* m */
  double length;            /* contact length of a pin, m; NaN of a ball */
  double effective_modulus; /* E = 2 E* of the surfaces, Pa */
  int has_seat;             /* the contact is confined to its [seat] */
} contact_joint_size;
contact_status contact_joint_get_size(const contact_joint* joint,
                                      contact_joint_size* size);

/* Limits of the theory or of its laws that the joint exceeds: sentence i, NULL
 * behind the last one. Valid as long as the joint. */
const char* contact_joint_note(const contact_joint* joint, size_t i);

/* Limits of the theory and of the materials that contacts go beyond whose
 * largest half-angle (rad) and peak pressure (Pa) these were, one sentence per
 * line, cut to `size` with its final 0. NaN goes beyond nothing. */
contact_status contact_joint_contact_notes(const contact_joint* joint,
                                           double half_angle,
                                           double peak_pressure, char* text,
                                           size_t size);

/* The contact under a normal force R_n, N, above 0; with interference 0 too. */
typedef struct contact_patch {
  double load_parameter; /* mu (ball) or lambda (pin) */
  double half_angle;     /* theta0, rad */
  double peak_pressure;  /* Pa */
  double mean_pressure;  /* Pa */
  double area;           /* m^2 */
} contact_patch;
contact_status contact_joint_patch(const contact_joint* joint,
                                   double normal_force, contact_patch* patch);
/* The inverse: R_n, N, of a half-angle in rad. */
contact_status contact_joint_normal_force(const contact_joint* joint,
                                          double half_angle,
                                          double* normal_force);
/* Pressure, Pa, under R_n at the angle theta (rad) from the contact's centre;
 * 0 outside the contact. */
contact_status contact_joint_pressure(const contact_joint* joint,
                                      double normal_force, double theta,
                                      double* pressure);
/* How far R_n presses the two bodies into each other from first touch, m, and
 * dR_n/d(approach), N/m. The half-angle law "exact" alone has them, and makes
 * a table when first asked; CONTACT_OUT_OF_RANGE where there is none: another
 * law, no load, loaded through the back, a pin in an infinite hole. */
contact_status contact_joint_approach(const contact_joint* joint,
                                      double normal_force, double* approach,
                                      double* stiffness);

/* Friction integrals of a contact, with which
 *
 *     R_t = c R_n coefficient[0] + k area[0]
 *
 * and the moments (1: sliding, 2: spinning) the same times rho; (c, k) is
 * (f0, A rho^2) if dry, (k1 rho |Dw|, k0 rho^3 |Dw|) if viscous. */
typedef struct contact_friction {
  double coefficient[3];
  double area[3];
} contact_friction;
/* half_angle: theta0, rad. slip_axis_angle: a, rad, -pi/2 to pi/2, from pure
 * sliding (0) to pure spinning; without influence for a pin. CONTACT_BAD_INPUT
 * for a stress of pressure and speed, which has no such integrals;
 * CONTACT_OUT_OF_RANGE for pi with interference, where they depend on R_n. */
contact_status contact_joint_friction(const contact_joint* joint,
                                      double half_angle, double slip_axis_angle,
                                      contact_friction* friction);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
