#pragma once

#include <Eigen/Core>
#include <memory>

#include "libcontact/joint/moment_set.hpp"

namespace contact {

class SeatJoint;

namespace detail {
struct SeatWork;
}  // namespace detail

/// MomentSet of a ball in a seat that ends: the friction moments of one contact
/// whose force F on the seat is FIXED. A convex set, even in M, but at a rim
/// not round about F. Its support function is the friction power Phi of
/// docs/seat_joint.md. Dry friction only; everything is NaN without a contact.
///
/// A set refers to the joint that made it and must not outlive it. Vectors are
/// in the axes of the joint's reaction. Functions agree with each other as
/// those of MomentSet do; with the exact set to 1e-3 of rho F, which
/// SeatJoint's friction is good to (seat/moment_set_test.cpp).
class SeatMomentSet {
 public:
  SeatMomentSet(const SeatJoint& joint,
                std::shared_ptr<const detail::SeatWork> contact);

  /// Phi, W for Dw in rad/s; 0 at 0.
  double support(const Eigen::Vector3d& angular_velocity) const;
  /// M_t = -dPhi/dDw, N m; NaN at Dw = 0.
  Eigen::Vector3d moment(const Eigen::Vector3d& angular_velocity) const;
  /// Smallest tau with M in tau C; 0 at M = 0, infinite without friction.
  double utilisation(const Eigen::Vector3d& moment) const;
  /// The moment of the set nearest to M.
  Eigen::Vector3d project(const Eigen::Vector3d& moment) const;
  /// As MomentSet::prox().
  /// @param inertia  W, kg m^2, symmetric and positive definite
  /// @param free     motion without friction, rad/s^2 or rad/s
  MomentSet::Prox prox(const Eigen::Matrix3d& inertia,
                       const Eigen::Vector3d& free) const;

 private:
  Eigen::Matrix3d curvature(const Eigen::Vector3d& direction) const;
  Eigen::Vector3d normal(const Eigen::Vector3d& moment) const;

  const SeatJoint* joint_;
  std::shared_ptr<const detail::SeatWork> contact_;
  bool has_contact_;
};

}  // namespace contact
