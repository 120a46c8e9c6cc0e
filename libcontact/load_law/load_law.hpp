#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/joint/joint.hpp"

/// Dry friction that depends on the load, in few numbers and as a function in
/// another language: docs/how-to/equivalent.md.
namespace contact {

/// The friction moment of a pin by its radial load R and its coefficient f:
///
///     M = rho f N S,  N = R/sqrt(1 + f^2)
///
/// with S of all loads, the sum of the pressures over N, a polynomial in
///     u = N/(N + R0)          with a clearance: c0 + c1 u + c2 u^2 + ...
///     u = sqrt(1 - R0/N)      with interference above its lift-off load R0,
///                             below which N is R0:
///                             c0 + u^2 (c1 + c2 (2u - 1) + ...)
/// and with adhesion, where f is that of the joint, M = R S in the logarithm of
/// R between two loads.
struct PinLoadLaw {
  enum class Form { clearance, interference, adhesion };
  Form form = Form::clearance;
  double radius = 0;                ///< rho, m
  double scale = 0;                 ///< R0, N; with adhesion 0
  std::vector<double> numbers;      ///< c0, c1, ...
  std::pair<double, double> loads;  ///< R, N, between which it was compared
  /// Largest relative error of M there, in double and in float.
  double error = 0;
  double float_error = 0;
};

/// Finds the law with the fewest numbers (4 to 12) whose error is as wanted.
/// @param pin    dry, or with Stribeck's law of the speed
/// @param error  above 0; 1e-4 takes 4 to 8 numbers, 1e-6 some 12
/// @param loads  least and largest R, N; none: ten decades, which the law does
///               not need to know, or with adhesion four, which it does
/// @return errors are those against solve() at 2000 loads; another comparison
///         finds up to 1.2 times as much (tests/python/test_load_law.py)
/// @throws Error for other joints, of those with a [seat] or [relief] too, and
///   for an error that 12 numbers do not reach
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
  std::string name = "friction";  ///< the function's
  double error = 1e-4;            ///< the largest that is wanted, above 0
  /// R, N: of a ball the loads that it is for, without them load parameters of
  /// 1e-3 to 10; of a pin as pin_load_law().
  std::optional<std::pair<double, double>> loads = {};
  std::string joint = "";  ///< name of the joint, for the comment
};
/// Writes the law: a comment with units, frame, range, errors and what is left
/// out, and the function. Of a ball it has M_t, R_n and a flag by R and Dw, and
/// there is a second one, NAME_hold(): the utilisation of at_rest(), to 2e-5,
/// and a third, NAME_gradient(): dM/dR and dM/dDw in closed form, 99 of 100
/// states to 20 times the error of M_t, at the rim to 300 times. Balls have a
/// clearance and dry friction without adhesion.
/// @return errors of a ball are those of the vector M_t in 100,000 states, from
///         5e-3 to 1e-6 (tests/python/test_load_law.py)
/// @throws Error as pin_load_law(), for a language or name that is none, for
///         other balls, and for the language st with a ball
LoadLawText load_law_text(const Joint& joint, const LoadLawOptions& options);

}  // namespace contact
