// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/joint/joint.hpp"

/// Dry friction over the load, with few numbers and as a function in another
/// language: docs/how-to/equivalent.md.
namespace contact {

/// The friction moment of a pin as a function of its radial load R and its
/// coefficient f:
///
///     M = rho f N S,  N = R/sqrt(1 + f^2)
///
/// with S, the integral of the pressure over N, for all loads a polynomial in
///     u = N/(N + R0)          with a clearance: c0 + c1 u + c2 u^2 + ...
///     u = sqrt(1 - R0/N)      with interference above its lift-off load R0,
///                             below which N is R0:
///                             c0 + u^2 (c1 + c2 (2u - 1) + ...)
/// and with adhesion, with the f of the joint, M = R S in the logarithm of R
/// between two loads.
struct PinLoadLaw {
  enum class Form { clearance, interference, adhesion };
  Form form = Form::clearance;
  double radius = 0;                ///< rho, m
  double scale = 0;                 ///< R0, N; with adhesion 0
  std::vector<double> numbers;      ///< c0, c1, ...
  std::pair<double, double> loads;  ///< R, N, range of the comparison
  /// Largest relative error of M in this range, in double and in float.
  double error = 0;
  double float_error = 0;
};

/// Finds the law with the fewest numbers (4 to 12) that has the required error.
/// @param pin    dry, or with Stribeck's law of the speed
/// @param error  above 0; 1e-4 needs 4 to 8 numbers, 1e-6 some 12
/// @param loads  least and largest R, N; none: ten decades, on which the law
///               does not depend, or with adhesion four, on which it depends
/// @return law with its errors against solve() at 2000 loads; another
///         comparison finds up to 1.2 times as much
///         (tests/python/test_load_law.py)
/// @throws Error for other joints, also with a [seat] or [relief], and for an
///   error that 12 numbers do not reach
PinLoadLaw pin_load_law(
    const Joint& pin, double error,
    const std::optional<std::pair<double, double>>& loads = {});

/// A load law as text.
struct LoadLawText {
  std::string text;
  double error = 0;
  double float_error = 0;
};
struct LoadLawOptions {
  std::string language = "c";     ///< c, cuda, glsl, jax, js, numpy or st
  std::string name = "friction";  ///< function name
  double error = 1e-4;            ///< largest allowed, above 0
  /// R, N: for a ball the range of loads, by default load parameters of 1e-3 to
  /// 10; for a pin as in pin_load_law().
  std::optional<std::pair<double, double>> loads = {};
  std::string joint = "";  ///< name of the joint, for the comment
};
/// Writes the law: a comment with units, frame, range, errors and neglected
/// effects, and the function. For a ball it computes M_t, R_n and a flag from R
/// and Dw. A second function, NAME_hold(), gives the utilisation of at_rest(),
/// to 2e-5; a third, NAME_gradient(), gives dM/dR and dM/dDw in closed form,
/// for 99 of 100 states to 20 times the error of M_t, at the rim to 300 times.
/// Balls must have a clearance and dry friction without adhesion.
/// @return text; the errors of a ball refer to the vector M_t in 100,000
///         states, from 5e-3 to 1e-6 (tests/python/test_load_law.py)
/// @throws Error as pin_load_law(), for an unknown language, for a name that is
///         no identifier, for other balls, and for the language st with a ball
LoadLawText load_law_text(const Joint& joint, const LoadLawOptions& options);

}  // namespace contact
