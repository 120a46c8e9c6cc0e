#pragma once

#include <Eigen/Core>
#include <span>

#include "multibody/system/active_forces.hpp"
#include "multibody/system/force_model.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// Conversion between states and the bodies of applications, in body axes and
/// inertial axes. Does not allocate.

/// C of a body in its hinge: link axes to parent axes.
Eigen::Matrix3d relative_rotation(const Link& link, const double* link_state);
/// Relative angular velocity, link axes.
Eigen::Vector3d relative_rate(const Link& link, const double* link_state);
void set_relative_rate(const Link& link, double* link_state,
                       const Eigen::Vector3d& rate);

/// Motion of the carrier, and of a body on its parent or released (then without
/// a hinge angle).
/// @param numbers  its own
BodyMotion carrier_at(const double* numbers);
BodyMotion body_at(const Link& link, JointMode mode, const double* numbers,
                   const BodyMotion& parent);

/// @param bodies  1 + number of bodies; the hinge angle of a released body does
///                not change
void set_bodies(const System& system, const StateLayout& layout,
                std::span<const JointMode> modes, const double* state,
                std::span<BodyMotion> bodies);

/// Transforms forces from inertial axes to carrier and link axes.
void set_active_forces(const System& system, std::span<const BodyMotion> bodies,
                       std::span<const BodyForce> forces,
                       ActiveForces<double>& active);

/// The 13 numbers of a body without a hinge.
/// @param axes  axes of the state's quaternion to body axes
void put_body(const BodyMotion& body, const Eigen::Matrix3d& axes, double* to);

/// Kinetic energy of a body, J; inertia in the axes `axes` (to body axes).
double kinetic_energy(double mass, const Eigen::Matrix3d& inertia,
                      const Eigen::Matrix3d& axes, const BodyMotion& body);

/// Normalises every quaternion of a state.
void normalise(const System& system, const StateLayout& layout,
               std::span<const JointMode> modes, double* state);

}  // namespace multibody
