#include "libcontact/tools/reference/elliptic_fit.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/friction/elliptic/integrals_real.hpp"

namespace contact::reference {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                  boost::multiprecision::et_off>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// The error is scanned on x = (i/samples)^power: its extrema crowd towards
// x = 0, the first one near 1e-4 at order 9.
constexpr int samples = 1000;
constexpr int power = 4;

Real abscissa(const Real& position) { return pow(position / samples, power); }

/// One integral at one x: the function to fit, less its fixed terms, and the
/// basis, all divided by the function.
struct Sample {
  Real position, fixed;
  Vector basis;
};

Sample sample(EllipticKind kind, int order, const Real& position) {
  using boost::math::constants::ln_two;
  const Real x = abscissa(position);
  const Real logarithm = log(x);
  const bool first = kind == EllipticKind::k;
  const Real function = first ? elliptic_k<Real>(x) : elliptic_e<Real>(x);
  Sample result{
      position,
      (first ? Real(2 * ln_two<Real>() - logarithm / 2) : Real(1)) / function -
          1,
      Vector(2 * order)};
  Real term = 1 / function;
  for (int i = 0; i < order; ++i) {
    term *= x;
    result.basis[i] = term;
    result.basis[order + i] = -term * logarithm;
  }
  return result;
}

Real relative_error(const Sample& s, const Vector& coefficients) {
  return s.fixed + s.basis.dot(coefficients);
}

/// Coefficients and level of the error that alternates over the points.
std::pair<Vector, Real> levelled(const std::vector<Sample>& points) {
  const int n = static_cast<int>(points.size());
  Matrix matrix(n, n);
  Vector right(n);
  for (int row = 0; row < n; ++row) {
    matrix.row(row).head(n - 1) = points[row].basis.transpose();
    matrix(row, n - 1) = row % 2 == 0 ? 1 : -1;
    right[row] = -points[row].fixed;
  }
  const Vector solution = matrix.partialPivLu().solve(right);
  return {solution.head(n - 1), abs(solution[n - 1])};
}

/// The largest error of each stretch of one sign, refined by a parabola
/// through its neighbours; the smaller end is dropped while there are more
/// than `wanted`.
std::vector<Sample> extrema(EllipticKind kind, int order,
                            const std::vector<Sample>& grid,
                            const Vector& coefficients, std::size_t wanted) {
  std::vector<Real> error;
  for (const Sample& s : grid) error.push_back(relative_error(s, coefficients));
  std::vector<int> peaks{0};
  for (int i = 1; i < samples; ++i) {
    const bool same_sign = (error[i] < 0) == (error[peaks.back()] < 0);
    if (!same_sign) {
      peaks.push_back(i);
    } else if (abs(error[i]) > abs(error[peaks.back()])) {
      peaks.back() = i;
    }
  }
  std::vector<Sample> result;
  for (const int i : peaks) {
    if (i == 0 || i == samples - 1) {
      result.push_back(grid[i]);
      continue;
    }
    const Real left = error[i - 1], right = error[i + 1];
    const Real shift = (left - right) / (2 * (left - 2 * error[i] + right));
    result.push_back(sample(kind, order, grid[i].position + shift));
  }
  const auto size = [&](const Sample& s) {
    return Real(abs(relative_error(s, coefficients)));
  };
  while (result.size() > wanted) {
    if (size(result.front()) < size(result.back())) {
      result.erase(result.begin());
    } else {
      result.pop_back();
    }
  }
  return result;
}

}  // namespace

EllipticLogFit fit_elliptic_log_form(EllipticKind kind, int order) {
  if (order < 1 || order > 9) {
    throw Error(detail::must_be(
        "elliptic log form: order = " + std::to_string(order), "1 to 9"));
  }
  const std::size_t wanted = 2 * order + 1;
  std::vector<Sample> grid;
  for (int i = 1; i <= samples; ++i) grid.push_back(sample(kind, order, i));
  std::vector<Sample> points;
  for (std::size_t j = 1; j <= wanted; ++j) {
    // Start: squares of Chebyshev points, x = sin^4(angle), at
    // x = (position/samples)^power.
    const Real angle = boost::math::constants::half_pi<Real>() * j / wanted;
    points.push_back(sample(kind, order, samples * sin(angle)));
  }
  for (int exchange = 1; exchange <= 30; ++exchange) {
    const auto [coefficients, level] = levelled(points);
    points = extrema(kind, order, grid, coefficients, wanted);
    if (points.size() < wanted) break;
    Real largest = 0;
    for (const Sample& s : points) {
      largest = (std::max)(largest, Real(abs(relative_error(s, coefficients))));
    }
    if (largest < level * (1 + Real(1e-9))) {
      EllipticLogFit fit{{}, {}, static_cast<double>(largest), exchange};
      for (int i = 0; i < order; ++i) {
        fit.p.push_back(static_cast<double>(coefficients[i]));
        fit.q.push_back(static_cast<double>(coefficients[order + i]));
      }
      return fit;
    }
  }
  throw Error("elliptic log form: the exchange of order " +
              std::to_string(order) + " did not converge");
}

std::string elliptic_log_coefficients_header() {
  std::string text = R"(#pragma once

// clang-format off
/// Made by the program fit-elliptic (reference/elliptic_fit.hpp); do not edit.
/// Row n - 1 is order n: a bound of the fit's relative error (0.1 % above its
/// largest), then the coefficients of x, ..., x^n in P and in Q.
namespace contact::detail {

struct EllipticLogCoefficients {
  double error;
  double p[9];
  double q[9];
};
)";
  const auto list = [](const std::vector<double>& values) {
    std::string cells;
    for (const double v : values) {
      cells += (cells.empty() ? "" : ",\n      ") + fmt::format("{}", v);
    }
    return "{" + cells + "}";
  };
  for (const EllipticKind kind : {EllipticKind::k, EllipticKind::e}) {
    text += fmt::format(
        "\ninline constexpr EllipticLogCoefficients elliptic_{}_log[9] = {{\n",
        kind == EllipticKind::k ? 'k' : 'e');
    for (int order = 1; order <= 9; ++order) {
      const EllipticLogFit fit = fit_elliptic_log_form(kind, order);
      text += fmt::format("    {{{:.3e},\n     {},\n     {}}},\n",
                          1.001 * fit.error, list(fit.p), list(fit.q));
    }
    text += "};\n";
  }
  return text + "\n}  // namespace contact::detail\n";
}

}  // namespace contact::reference
