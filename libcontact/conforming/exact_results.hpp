#pragma once

#include "libcontact/base/error.hpp"

/// The results of both directions of the exact solutions.
namespace contact {

/// A half-angle from an exact solution.
struct ExactHalfAngle {
  /// theta0, rad. NaN if out_of_range; the largest angle the solution
  /// reaches if not_converged.
  double half_angle;
  Status status;
  /// Width of the last bracket about the root, rad.
  double bracket;
  /// Solutions of the contact problem that it took.
  int evaluations;
};

/// A load parameter from an exact solution.
struct ExactLoad {
  /// lambda (pin) or mu (ball); NaN if out_of_range.
  double load_parameter;
  Status status;
  /// Estimate of the truncation error of 1/load_parameter: its change from
  /// four unknowns fewer, an upper bound in all measured cases.
  double reciprocal_error;
};

}  // namespace contact
