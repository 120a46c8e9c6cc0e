#include "libcontact/half_angle/approach_table.hpp"

#include <algorithm>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Coefficients at the end fall like k^-5.
constexpr double negligible = 2e-8;

double square(double half_angle) {
  const double s = 2 * std::sin(half_angle / 2);
  return s * s;
}

}  // namespace

ApproachTable::ApproachTable(JointKind kind, const HalfAngleTable& load,
                             const Solver& solver)
    : kind_(kind),
      load_(load),
      variable_(JointKind::ball, load.largest(), load.thickness()) {
  if (!variable_.has_walls()) {
    tabulate(40, solver);
    return;
  }
  tabulate(64, solver);
  if (!is_resolved()) tabulate(128, solver);  // thin free rings
}

void ApproachTable::tabulate(int count, const Solver& solver) {
  approach_.assign(count, 0);
  growth_.assign(count, 0);
  for (int i = 0; i < count; ++i) {
    const double phi = pi * (i + 0.5) / count;
    const double cosine = std::cos(phi / 2);
    const double sine = std::sin(phi / 2);
    const auto [half_angle, rest] =
        variable_.half_angle(cosine * cosine, sine * sine);
    const ForcePoint solved = solver(half_angle);
    // The approach is made that of the other table's load: near the limit both
    // loads are small differences, whose roundings are not each other's.
    const double same_load = solved.reciprocal_load *
                             load_.load_parameter(half_angle).load_parameter;
    const double complement = load_.reaches_limit() ? rest : 1;
    const double unit = square(half_angle);
    const double l = logarithm(half_angle);
    const auto h = [&](double value) {
      return std::log(complement * (value / unit - l));
    };
    // The growth and the stiffness are each other's reciprocal.
    const double approach = h(same_load * solved.approach.approach);
    const double growth = h(stiffness(half_angle, solved.approach.stiffness));
    for (int k = 0; k < count; ++k) {
      const double factor = 2.0 / count * std::cos(k * phi);
      approach_[k] += factor * approach;
      growth_[k] += factor * growth;
    }
  }
}

bool ApproachTable::is_resolved() const {
  const auto ends = [](const Series& series) {
    return std::all_of(series.end() - 4, series.end(),
                       [](double c) { return std::abs(c) < negligible; });
  };
  return ends(approach_) && ends(growth_);
}

double ApproachTable::logarithm(double half_angle) const {
  if (kind_ == JointKind::ball) return 0;
  // A share that leaves something at any half-angle.
  const double scale = std::min(variable_.thickness(), 1.0) / 8;
  return std::log1p(scale / (2 * std::sin(half_angle / 2))) / 2;
}

double ApproachTable::stiffness(double half_angle, double growth) const {
  // R_n = (2/3) mu eps rho E, P = (pi/2) lambda eps E.
  const double unit = kind_ == JointKind::ball ? 2.0 / 3 : pi / 2;
  return unit * load_.load_parameter(half_angle).load_parameter / growth;
}

ContactApproach ApproachTable::operator()(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle < load_.largest())) return {nan, nan};
  const double v = 2 * variable_(half_angle).first - 1;
  const double complement =
      load_.reaches_limit() ? (load_.largest() - half_angle) / load_.largest()
                            : 1;
  const double l = logarithm(half_angle);
  const auto value = [&](const Series& series) {
    const double h = boost::math::chebyshev_clenshaw_recurrence(
        series.data(), series.size(), v);
    return square(half_angle) * (std::exp(h) / complement + l);
  };
  return {value(approach_), stiffness(half_angle, value(growth_))};
}

}  // namespace contact::detail
