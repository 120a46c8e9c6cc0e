#pragma once

#include <cstddef>

#include "libcontact/base/error.hpp"
#include "libcontact/friction/integrals.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact::reference {

/// Result of the quadrature for one contact and slip axis.
struct QuadratureResult {
  FrictionIntegrals value;
  /// Estimated absolute errors, from GSL; `normal` is exact and has 0.
  FrictionIntegrals error;
  /// ok if GSL met the tolerance in all six integrals; not_converged if not,
  /// with the best values found and their estimates.
  Status status;
  /// Evaluations of a two-dimensional integrand, all six integrals together.
  std::size_t evaluations;
};

/// Friction integrals and coefficients of a ball joint with the cosine
/// pressure (3.3), straight from their definition
/// (docs/explanation/friction.md): for each of the six integrals an adaptive
/// quadrature over the colatitude t from the contact's centre, whose integrand
/// is an adaptive quadrature over the longitude f. The independent check of the
/// other methods and the baseline of the benchmarks; shares nothing with them.
///
/// The integrands jump in direction at the poles of the slip axis
/// (t = 90 deg - |a| and 90 deg + |a|, f = +-90 deg): the outer interval is
/// split there, the inner one runs from f = 90 deg to -90 deg and is split
/// close to its ends. GSL's QAGP serves both.
///
/// @param half_angle  theta0, rad, [0, pi]; the limits at theta0 = 0
/// @param axis        slip axis, sine and cosine of a in [-pi/2, pi/2]
/// @param tolerance   largest relative error asked for, [1e-13, 1e-2]
/// @return all dimensionless. With the tolerance 1e-10 the relative errors on
///         data/reference are at most 1e-10, and below the estimates
///         (friction/special_test.cpp). K is a small difference when
///         theta0 sin a is small; there the estimate, some 1e-14/(theta0
///         sin a), and the status say so.
///         By symmetry K = 0 at a = 0 and I = J = 0 at a = 90 deg exactly.
///         NaN if an argument is NaN or outside its interval, with the status
///         out_of_range.
QuadratureResult quadrature_friction_integrals(double half_angle, SlipAxis axis,
                                               double tolerance = 1e-10);

/// The same for any pressure law of a ball: `pressure` has the weight p/p(0)
/// and `normal` is 1/p(0), as in friction_integrals(). Steep edges are left to
/// GSL's extrapolation.
QuadratureResult quadrature_friction_integrals(const PressureLaw& law,
                                               double half_angle, SlipAxis axis,
                                               double tolerance = 1e-10);

}  // namespace contact::reference
