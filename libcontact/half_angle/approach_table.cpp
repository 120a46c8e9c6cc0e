#include "libcontact/half_angle/approach_table.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

// Coefficients at the end fall like k^-5.
constexpr double negligible = 2e-8;

double squared_chord(double half_angle) {
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
    series_ = tabulated(40, solver);
    return;
  }
  series_ = tabulated(64, solver);
  if (!series_.is_resolved(negligible, 2)) {
    series_ = tabulated(128, solver);  // thin free rings
  }
}

ChebyshevTable ApproachTable::tabulated(int count, const Solver& solver) const {
  return {count, [&](double half_phase) -> Eigen::RowVectorXd {
            const double cosine = std::cos(half_phase);
            const double sine = std::sin(half_phase);
            const auto [half_angle, rest] =
                variable_.half_angle(cosine * cosine, sine * sine);
            const ForcePoint solved = solver(half_angle);
            // Converts the approach to the other table's load: near the limit
            // both loads are small differences with different roundings.
            const double same_load =
                solved.reciprocal_load *
                load_.load_parameter(half_angle).load_parameter;
            const double complement = load_.reaches_limit() ? rest : 1;
            const double unit = squared_chord(half_angle);
            const double l = logarithm(half_angle);
            const auto h = [&](double value) {
              return std::log(complement * (value / unit - l));
            };
            // The growth and the stiffness are each other's reciprocal.
            return Eigen::RowVector2d(
                h(same_load * solved.approach.approach),
                h(stiffness(half_angle, solved.approach.stiffness)));
          }};
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
  const auto value = [&](int column) {
    const double h = series_.value(column, v);
    return squared_chord(half_angle) * (std::exp(h) / complement + l);
  };
  return {value(0), stiffness(half_angle, value(1))};
}

}  // namespace contact::detail
