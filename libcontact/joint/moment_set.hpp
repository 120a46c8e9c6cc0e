// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include "libcontact/base/error.hpp"
#include "libcontact/joint/contact.hpp"

namespace contact {

namespace detail {
class ContactMoments;
}  // namespace detail

/// The friction moments of one contact whose n, R_n and theta0 are FIXED: a
/// convex set C, even in M and round about n, which a contact at a rim of its
/// seat is not. Dry friction only; a viscous joint holds no moment and its set
/// is {0}. The set of a friction stress uses tau(p, 0); if tau falls with the
/// speed the power is not convex, and everything is NaN.
///
/// Its support function is the friction power
///
///     Phi(Dw) = rho |Dw| { f0 R_n (sigma_Y cos a + sigma_Z sin a)
///                           + A rho^2 (J[1] cos a + K[1] sin a) }
///             = max over M in C of M . Dw,   M_t = -dPhi/dDw
///
/// (sigma, J, K: docs/explanation/friction.md). This potential exists at fixed
/// n, R_n and theta0 only: under a fixed reaction R all three move with Dw, M_t
/// has no potential, and Joint::at_rest() gives the moments that a resting
/// joint holds, not this set with n = R/|R|.
///
/// A set refers to the joint that made it and must not outlive it. Const
/// functions do not throw, and do not allocate but at a rim; NaN gives NaN.
/// At a rim they agree with each other as closely as elsewhere, and with the
/// exact set to 1e-3 of rho R_n (seat/moment_set_test.cpp).
class MomentSet {
 public:
  /// @param normal             n, unit vector; 0 without load
  /// @param normal_force       R_n, N, >= 0
  /// @param half_angle         theta0, rad
  MomentSet(const JointContact& contact, const Eigen::Vector3d& normal,
            double normal_force, double half_angle) noexcept;
  MomentSet(const JointContact&&, const Eigen::Vector3d&, double,
            double) = delete;
  /// Moments of a contact that is not round about n.
  MomentSet(const JointContact& contact,
            std::shared_ptr<const detail::ContactMoments> moments) noexcept;

  /// Phi, W for Dw in rad/s; 0 at 0.
  double support(const Eigen::Vector3d& angular_velocity) const noexcept;
  /// M_t = -dPhi/dDw, N m; the point of the set's edge where it opposes Dw
  /// most. NaN at Dw = 0, where every moment of the set is possible.
  Eigen::Vector3d moment(
      const Eigen::Vector3d& angular_velocity) const noexcept;

  /// Smallest tau with M in tau C: the joint holds M if it is <= 1.
  /// 0 at M = 0; infinite outside of a set without extent in that direction.
  /// Relative error at most 1e-12 (joint/moment_set_test.cpp).
  double utilisation(const Eigen::Vector3d& moment) const noexcept;

  /// The moment of the set nearest to M.
  /// Error at most 1e-12 of |M| (joint/moment_set_test.cpp).
  Eigen::Vector3d project(const Eigen::Vector3d& moment) const noexcept;

  /// Answer of prox().
  struct Prox {
    /// alpha, of the kind of `free`: exactly 0 where the joint holds.
    Eigen::Vector3d angular_velocity;
    /// M_t = W (alpha - free), on the body; on the edge of the set where the
    /// joint slides.
    Eigen::Vector3d moment;
    Status status;
    /// Newton steps; 0 where the joint holds.
    int iterations;
    /// |W (alpha - free) - M_t| over |W free|.
    double residual;
  };
  /// The motion that friction leaves of a free one:
  ///
  ///     argmin over alpha of (alpha - free) . W (alpha - free)/2 + Phi(alpha)
  ///
  /// With W the inertia about the joint and `free` the relative angular
  /// acceleration (or velocity) without friction, it is the one with
  /// friction: 0 where C holds W free, else M_t(alpha) = W (alpha - free).
  ///
  /// @param inertia  W, symmetric and positive definite
  /// @param guess    a motion near to the answer, for speed; 0: none
  /// @return residual at most 1e-12, or what the rounding of alpha leaves
  Prox prox(
      const Eigen::Matrix3d& inertia, const Eigen::Vector3d& free,
      const Eigen::Vector3d& guess = Eigen::Vector3d::Zero()) const noexcept;

  /// Second derivative of Phi at a unit vector, N m: -dM_t/dDw times |Dw|.
  /// Differences of the set's edge, for Newton's method: relative error at most
  /// 1e-4/theta0 (joint/moment_set_test.cpp).
  Eigen::Matrix3d curvature(const Eigen::Vector3d& direction) const noexcept;
  /// The same for half the time, where moment(direction) is known.
  Eigen::Matrix3d curvature(const Eigen::Vector3d& direction,
                            const Eigen::Vector3d& moment_there) const noexcept;

 private:
  /// A point of the edge: parts along the tangent plane and along n.
  struct Edge {
    double sliding;
    double spinning;
  };
  Edge edge(SlipAxis axis) const noexcept;
  Eigen::Vector3d normal_at(const Eigen::Vector3d& held) const noexcept;
  Eigen::Matrix3d curvature_of_any(
      const Eigen::Vector3d& direction) const noexcept;
  double most_sliding() const noexcept { return edge({0, 1}).sliding; }
  SlipAxis axis_of_moment(double sliding, double spinning) const noexcept;

  const JointContact* contact_;
  Eigen::Vector3d normal_;
  double normal_force_;
  double half_angle_;
  double radius_;  // NaN where the power is not convex
  std::shared_ptr<const detail::ContactMoments> moments_ = {};
};

}  // namespace contact
