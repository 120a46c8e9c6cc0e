#include "libcontact/tools/reference/half_angle_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/fitted_relation.hpp"

namespace contact::reference {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

// One exact half-angle and its load.
struct Sample {
  double half_angle;
  double relation;  // F = (2 sin(theta0/2)/x)^power
  // dln(theta0)/dF at the same load.
  double weight;
};

// Chebyshev points of [0, theta0*]: crowded at both ends.
std::vector<Sample> samples_of(JointKind kind, const ElasticPair& pair,
                               int count) {
  const ExactLaw law(kind, pair);
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double phi = std::numbers::pi * (i + 0.5) / count;
    const double half_angle =
        law.limit_half_angle() * std::sin(phi / 2) * std::sin(phi / 2);
    const double load = law.load_parameter(half_angle).load_parameter;
    const double relation = detail::raised(kind, 2 * std::sin(half_angle / 2)) /
                            (detail::power_per_load(kind) * load);
    // At a given half-angle dF/F = -dload/load.
    samples.push_back(
        {half_angle, relation, law.half_angle(load).log_slope / relation});
  }
  return samples;
}

struct Fit {
  Vector coefficients;
  double largest_error;
};

// Lawson's iteration: rows with large errors gain weight. It does not fall
// steadily; the best of the steps counts.
template <class Equations>
Fit lawson(const Equations& equations, int rows) {
  constexpr int steps = 60;
  Vector weight = Vector::Ones(rows);
  Fit best{{}, infinity};
  Vector coefficients;
  for (int i = 0; i < steps; ++i) {
    const auto [matrix, right] = equations(coefficients);
    const Vector root = weight.cwiseSqrt();
    coefficients = (root.asDiagonal() * matrix)
                       .colPivHouseholderQr()
                       .solve(root.cwiseProduct(right));
    const Vector error = (matrix * coefficients - right).cwiseAbs();
    const double largest = error.maxCoeff();
    if (i > 0 && largest < best.largest_error) best = {coefficients, largest};
    // The root damps the iteration, 0.05 keeps small errors in play.
    weight = weight.cwiseProduct(
        (error / largest + Vector::Constant(rows, 0.05)).cwiseSqrt());
    weight /= weight.maxCoeff();
  }
  return best;
}

std::vector<ElasticPair> fit_pairs() {
  std::vector<ElasticPair> pairs;
  constexpr int steps = 5;  // in Poisson's ratio
  for (const double ratio :
       {0.0, 0.03, 0.1, 0.3, 0.6, 1.0, 1.7, 3.0, 10.0, 30.0, infinity}) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        // A rigid body's Poisson's ratio has no influence.
        if ((ratio == 0 && j > 0) || (std::isinf(ratio) && i > 0)) continue;
        pairs.push_back(ElasticPair::from_modulus_ratio(ratio, 0.5 * i / steps,
                                                        0.5 * j / steps));
      }
    }
  }
  return pairs;
}

}  // namespace

FittedCoefficients fit_fitted_law(JointKind kind) {
  constexpr int count = 41;
  constexpr int terms = detail::fitted_terms;
  const std::vector<ElasticPair> pairs = fit_pairs();
  const int features =
      static_cast<int>(detail::fitted_features(kind, pairs[0]).size());
  const int rows = count * static_cast<int>(pairs.size());
  Matrix matrix(rows, features * terms);
  Vector right(rows);
  int row = 0;
  for (const ElasticPair& pair : pairs) {
    const double constant = detail::fitted_constant(kind, pair);
    const std::vector<double> feature = detail::fitted_features(kind, pair);
    for (const Sample& sample : samples_of(kind, pair, count)) {
      const double sine = std::sin(sample.half_angle / 2);
      const double cosine = std::cos(sample.half_angle / 2);
      double power = sample.weight * detail::fitted_weight(kind, cosine);
      for (int k = 0; k < terms; ++k) {
        power *= sine;
        for (int i = 0; i < features; ++i) {
          matrix(row, i * terms + k) = feature[i] * power;
        }
      }
      right(row) =
          sample.weight * (sample.relation -
                           detail::fitted_closed_form(
                               kind, constant, sample.half_angle, sine, cosine)
                               .value);
      ++row;
    }
  }
  const Fit fit = lawson(
      [&](const Vector&) {
        return std::pair<const Matrix&, const Vector&>(matrix, right);
      },
      rows);
  FittedCoefficients result{{}, fit.largest_error};
  for (int i = 0; i < features; ++i) {
    const Vector part = fit.coefficients.segment(i * terms, terms);
    result.rows.emplace_back(part.begin(), part.end());
  }
  return result;
}

std::string half_angle_coefficients_header() {
  const auto list = [](const std::vector<double>& values) {
    std::string cells;
    for (const double v : values) {
      cells += (cells.empty() ? "" : ", ") + fmt::format("{:.5f}", v);
    }
    return "{" + cells + "}";
  };
  std::string text = R"(#pragma once

// clang-format off
/// Made by the program fit-half-angle (reference/half_angle_fit.hpp); do not
/// edit. Largest relative error of theta0 on the pairs of the fit above each.
namespace contact::detail {
)";
  for (const JointKind kind : {JointKind::pin, JointKind::ball}) {
    const char* joint = kind == JointKind::pin ? "pin" : "ball";
    const FittedCoefficients fitted = fit_fitted_law(kind);
    text += fmt::format(
        "\n// {:.2g} %\ninline constexpr double fitted_{}[{}][{}] = {{\n",
        100 * fitted.largest_error, joint, fitted.rows.size(),
        detail::fitted_terms);
    for (const auto& row : fitted.rows) text += "    " + list(row) + ",\n";
    text += "};\n";
  }
  return text + "\n}  // namespace contact::detail\n";
}

}  // namespace contact::reference
