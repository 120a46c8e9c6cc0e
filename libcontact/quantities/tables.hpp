// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/quantities/quantity.hpp"

/// The tables, in the order of columns.
namespace contact {

std::span<const Quantity<JointSolution>> solution_quantities();
std::span<const Quantity<RestSolution>> rest_quantities();
std::span<const Quantity<SlidingContact::Rating>> rating_quantities();
std::span<const Quantity<JointStep>> step_quantities();
std::span<const Quantity<MomentSet::Prox>> prox_quantities();

/// The contact under a normal force.
struct ContactPatch {
  const JointContact& contact;
  double normal_force;  ///< R_n, N
  double half_angle;    ///< theta0, rad; NaN where the law has none
};
/// Quantities that do not exist without a half-angle say so.
std::span<const Quantity<ContactPatch>> patch_quantities();
std::span<const Quantity<ContactApproach>> approach_quantities();

/// The last of these: columns of joints without clearance and with
/// interference.
std::span<const Quantity<ContactPatch>> preload_quantities();
/// The two before these: columns of joints with an approach.
std::span<const Quantity<ContactPatch>> presliding_quantities();

/// Coefficients of pure friction, f = f0, over the contact.
std::span<const Quantity<FrictionTriple>> coefficient_quantities();
/// The friction integrals, and those coefficients last.
std::span<const Quantity<FrictionIntegrals>> integral_quantities();

/// Quantities of a time of a cycle beside its solution.
std::span<const Quantity<JointCycle::Instant>> instant_quantities();
/// Integrals and means of a cycle; each is computed when it is asked for.
std::span<const Quantity<JointCycle>> cycle_quantities();
/// The largest values of a cycle, and those at the rims of a seat.
std::span<const Quantity<JointCycle>> worst_quantities();
std::span<const Quantity<WearIn::State>> worn_quantities();

}  // namespace contact
