#pragma once

#include <span>

#include "libcontact/joint/joint.hpp"

namespace contact {

/// One step of the paper's inner loop, (4.1) to (4.3).
struct FixedPointStep {
  int step;                     ///< from 1
  double friction_angle;        ///< g, rad
  double slip_axis_angle;       ///< a, rad
  double normal_force;          ///< R_n = R cos g, N
  double adhesion_number;       ///< Abar
  double load_parameter;        ///< mu
  double half_angle;            ///< theta0, rad
  double friction_coefficient;  ///< f; the next g is its arctangent
};

/// When the inner loop starts and stops.
struct FixedPointOptions {
  /// Stop when |f/tan g - 1| is at most this.
  double tolerance = 1e-12;
  int step_limit = 1000;
  /// tan g_1, instead of the paper's 0: the last f, when the loop goes on
  /// under another reaction.
  double start = 0;
};

/// How the inner loop ended.
struct FixedPointResult {
  /// ok; not_converged at the step limit; out_of_range where a step leaves
  /// g <= min(b, pi - b), so that (4.2) has no a.
  Status status;
  int steps;
  /// |f/tan g - 1| at the last step.
  double residual;
};

/// The paper's inner loop (section 4): g_1 = 0, then a, R_n, theta0, f and
/// g = atan f in turn. It may crawl or fail where Joint::solve() does not.
///
/// @param trace  filled with the steps, as many as it has room for
FixedPointResult fixed_point(const Joint& joint, const Joint::Slip& slip,
                             std::span<FixedPointStep> trace,
                             const FixedPointOptions& options = {}) noexcept;

}  // namespace contact
