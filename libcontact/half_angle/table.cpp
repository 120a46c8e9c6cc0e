#include "libcontact/half_angle/table.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

// Negligible in a series of ln G: the accuracy of the solvers of walled
// contacts.
constexpr double negligible_term = 1e-9;

// Terms that bring G to 1e-12: the closer theta0* comes to the singularity at
// theta0 = pi, the more.
int terms_for(JointKind kind, double largest) {
  const bool pin = kind == JointKind::pin;
  if (largest < 1.65) return pin ? 18 : 28;  // 95 deg
  if (largest < 2.4) return pin ? 30 : 40;   // 138 deg
  return 64;
}

}  // namespace

HalfAngleTable::HalfAngleTable(JointKind kind,
                               const std::function<double(double)>& reciprocal,
                               double largest, bool is_limit, double thickness)
    : kind_(kind),
      largest_(largest),
      is_limit_(is_limit),
      variable_(kind, largest, thickness) {
  if (variable_.has_walls()) {
    series_ = tabulated(64, reciprocal);
    if (!series_.is_resolved(negligible_term, 1)) {
      series_ = tabulated(128, reciprocal);
    }
    series_.shorten(negligible_term);
    // ln G(0) = 0 in truth.
    series_.shift(0, -std::log(evaluate(0).value));
  } else {
    series_ = tabulated(terms_for(kind, largest), reciprocal);
    // G(0) = 1 in truth.
    series_.shift(0, 1 - evaluate(0).value);
  }
  // The start does not know the variable of walls.
  start_.emplace(
      kind, [this](double theta, double, double) { return evaluate(theta); },
      largest, variable_.has_walls() ? 512 : 128);
}

ChebyshevTable HalfAngleTable::tabulated(
    int count, const std::function<double(double)>& reciprocal) const {
  return {count, [&](double half_phase) {
            const double cosine = std::cos(half_phase);
            const double sine = std::sin(half_phase);
            const auto [half_angle, complement] =
                variable_.half_angle(cosine * cosine, sine * sine);
            const double g = raised(kind_, 2 * std::sin(half_angle / 2)) *
                             reciprocal(half_angle) / power_per_load(kind_) /
                             (is_limit_ ? complement : 1);
            return Eigen::RowVectorXd::Constant(
                1, variable_.has_walls() ? std::log(g) : g);
          }};
}

RelationValue HalfAngleTable::evaluate(double half_angle) const noexcept {
  const auto [u, du] = variable_(half_angle);
  auto [g, slope] = series_.tangent(0, 2 * u - 1);
  slope *= 2 * du;
  if (variable_.has_walls()) {
    g = std::exp(g);
    slope *= g;
  }
  if (!is_limit_) return {g, slope};
  const double complement = (largest_ - half_angle) / largest_;
  return {complement * g, complement * slope - g / largest_};
}

HalfAngleResult HalfAngleTable::half_angle(
    double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range};
  if (load_parameter == 0) return {0, Status::ok, 1.0 / load_power(kind_)};
  if (is_limit_) {
    if (std::isinf(load_parameter)) return {largest_, Status::ok, 0};
  } else if (load_parameter > this->load_parameter(largest_).load_parameter) {
    return {largest_, Status::not_converged, 0};
  }
  return solve_half_angle(
      kind_, [this](double theta, double, double) { return evaluate(theta); },
      *start_, largest_, load_parameter);
}

LoadParameterResult HalfAngleTable::load_parameter(
    double half_angle) const noexcept {
  if (!(half_angle >= 0 && half_angle <= largest_)) {
    return {nan, Status::out_of_range};
  }
  if (half_angle == 0) return {0, Status::ok};
  if (is_limit_ && half_angle == largest_) return {infinity, Status::ok};
  const auto relation = [this](double theta, double, double) {
    return evaluate(theta);
  };
  return {load_at(kind_, relation, half_angle), Status::ok};
}

}  // namespace contact::detail
