#pragma once

#include "libcontact/base/vector_rows.hpp"

namespace multibody::detail {

using contact::VectorRows;

/// JointTracker::Largest
struct TrackerLargest {
  double trust;  ///< 1 where the radius of trust ends
  double error;  ///< JointTracker::error()
  /// |M_t less the applied moment| over sqrt(4 M_t^2 + floor^2); and before
  /// correct() corrected M_t.
  double residual, uncorrected;
  bool is_trusted() const { return trust < 1; }
};

/// Data exchanged by JointTracker's callers, its kernel and the evaluation of
/// contacts, for 8 joints side by side. Part of joint_tracker.hpp.
struct TrackerExchange {
  static constexpr int size = VectorRows::lanes;
  using Row = double[size];
  struct alignas(64) Vectors {
    Row x, y, z;
  };
  Vectors reaction;  ///< R, N
  Vectors rate;      ///< Dw, rad/s
  Vectors moment;    ///< M_t for R, N m
  Vectors applied;   ///< the moment used for the motion
  Vectors step;      ///< its last change
  Row tracked;       ///< 1 or 0
  Row trust;         ///< moves over the radius in which slopes are trusted
  Row error;         ///< relative error of M_t
  Row due;           ///< 1: its contact is to be evaluated

  // The contact to be evaluated.
  Row force;                           ///< R_n, N
  Row axis_sin, axis_cos;              ///< angle a
  Row half_angle_sin, half_angle_cos;  ///< theta0 (balls)
  Row asked;                           ///< 1: its laws have to be asked
  Row outside;                         ///< 1: R_n is not in the window
  Row exact;                           ///< 1: by `integrals` alone
  double integrals[6][size];           ///< as CapKernel::few() has them
  Row friction, sliding, spinning;     ///< f/cos a, c_Y/cos a, c_Z/sin a
};

}  // namespace multibody::detail
