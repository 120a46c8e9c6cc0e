#pragma once

#include <Eigen/Core>
#include <span>

#include "multibody/system/force_model.hpp"
#include "multibody/system/loading.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// Between states and what applications see: bodies in given axes and
/// inertial ones. Nothing allocates.

/// C of a load on the carrier: load axes to carrier axes.
Eigen::Matrix3d relative_rotation(const Link& link, const double* load_state);
/// Relative angular velocity, load axes.
Eigen::Vector3d relative_rate(const Link& link, const double* load_state);

/// @param bodies  1 + number of loads; the hinge angle of a load that is
///                released stays what it is
void set_bodies(const System& system, const StateLayout& layout,
                std::span<const JointMode> modes, const double* state,
                std::span<BodyMotion> bodies);

/// Forces in inertial axes into body axes (carrier's and load axes).
void set_loading(const System& system, std::span<const BodyMotion> bodies,
                 std::span<const BodyForce> forces, Loading<double>& loading);

/// The 13 numbers of a body of its own.
/// @param axes  axes of the state's quaternion to given axes
void put_body(const BodyMotion& body, const Eigen::Matrix3d& axes, double* to);

/// Kinetic energy of a body, J; inertia in the axes `axes` (to given axes).
double kinetic_energy(double mass, const Eigen::Matrix3d& inertia,
                      const Eigen::Matrix3d& axes, const BodyMotion& body);

/// Makes every quaternion of a state one of length 1.
void normalise(const System& system, const StateLayout& layout,
               std::span<const JointMode> modes, double* state);

}  // namespace multibody
