#include "libcontact/tools/reference/pressure_mixture_fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/mixture_coefficients.hpp"

namespace contact::reference {
namespace {

std::vector<ElasticPair> fit_pairs() {
  std::vector<ElasticPair> pairs;
  for (const double ratio :
       {0.0, 0.1, 1.0, 10.0, std::numeric_limits<double>::infinity()}) {
    for (const double inner : {0.0, 0.2, 0.3, 0.4, 0.5}) {
      for (const double outer : {0.0, 0.2, 0.3, 0.4, 0.5}) {
        // A rigid body's Poisson's ratio has no influence.
        if (ratio == 0 && outer > 0) continue;
        if (std::isinf(ratio) && inner > 0) continue;
        pairs.push_back(ElasticPair::from_modulus_ratio(ratio, inner, outer));
      }
    }
  }
  return pairs;
}

}  // namespace

MixtureFit fit_pressure_mixture(JointKind kind) {
  constexpr int terms = detail::mixture_terms;
  constexpr int count = 24;
  const int power = kind == JointKind::ball ? detail::ball_mixture.power
                                            : detail::pin_mixture.power;
  const std::vector<ElasticPair> pairs = fit_pairs();
  const SqrtTanPressure sqrt_tan(kind);
  const CosinePressure cosine(kind);
  Eigen::MatrixXd matrix(pairs.size() * count, 2 * terms);
  Eigen::VectorXd right(pairs.size() * count);
  int row = 0;
  for (const ElasticPair& pair : pairs) {
    const ExactPressure exact(kind, pair);
    const double contrast = pressure_contrast(kind, pair);
    const double largest = std::min(ExactLaw(kind, pair).limit_half_angle(),
                                    exact.largest_half_angle());
    for (int i = 0; i < count; ++i, ++row) {
      const double theta0 = largest * (i + 1) / count;
      const double s = exact.force_ratio(theta0);
      const double narrow = cosine.force_ratio(theta0);
      const double weight = (sqrt_tan.force_ratio(theta0) - narrow) / s *
                            std::pow(std::cos(theta0 / 2), power);
      double term = weight;
      for (int k = 0; k < terms; ++k) {
        term *= std::sin(theta0 / 2);
        matrix(row, k) = term;
        matrix(row, terms + k) = contrast * term;
      }
      right(row) = weight + (narrow - s) / s;
    }
  }
  const Eigen::VectorXd x = matrix.colPivHouseholderQr().solve(right);
  const Eigen::VectorXd part = x.head(terms);
  const Eigen::VectorXd contrast = x.tail(terms);
  return {{part.begin(), part.end()},
          {contrast.begin(), contrast.end()},
          (matrix * x - right).cwiseAbs().maxCoeff()};
}

std::string pressure_mixture_header() {
  const auto law = [](JointKind kind, const char* name, int power) {
    const MixtureFit fit = fit_pressure_mixture(kind);
    return fmt::format(
        "// S: {:.2f} %\ninline constexpr MixtureCoefficients {} = {{\n"
        "    {},\n    {{{:.4f}}},\n    {{{:.4f}}},\n}};\n\n",
        100 * fit.largest_error, name, power, fmt::join(fit.equal, ", "),
        fmt::join(fit.contrast, ", "));
  };
  return fmt::format(
      R"(#pragma once

// clang-format off
/// Made by the program fit-pressure-mixture
/// (reference/pressure_mixture_fit.hpp); do not edit. Largest relative error
/// of S on the pairs of the fit above each.
namespace contact::detail {{

inline constexpr int mixture_terms = {};
struct MixtureCoefficients {{
  int power;                       ///< of cos(theta0/2)
  double equal[mixture_terms];     ///< c_k, k = 1, 2, ...
  double contrast[mixture_terms];  ///< d_k
}};

{}{}}}  // namespace contact::detail
// clang-format on
)",
      detail::mixture_terms,
      law(JointKind::ball, "ball_mixture", detail::ball_mixture.power),
      law(JointKind::pin, "pin_mixture", detail::pin_mixture.power));
}

}  // namespace contact::reference
