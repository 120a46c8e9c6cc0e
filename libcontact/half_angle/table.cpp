#include "libcontact/half_angle/table.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Negligible in a series of ln G: the accuracy of the solvers of walled
// contacts.
constexpr double negligible = 1e-9;

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
      terms_(terms_for(kind, largest)),
      largest_(largest),
      is_limit_(is_limit),
      variable_(kind, largest, thickness) {
  if (variable_.has_walls()) {
    for (terms_ = 64;; terms_ = max_terms) {
      tabulate(reciprocal);
      if (terms_ == max_terms || is_resolved()) break;
    }
    while (std::abs(coefficients_[terms_ - 1]) < negligible) --terms_;
    // ln G(0) = 0 in truth.
    coefficients_[0] -= std::log(evaluate(0).value);
  } else {
    tabulate(reciprocal);
    // G(0) = 1 in truth.
    coefficients_[0] += 1 - evaluate(0).value;
  }
  // The start does not know the variable of walls.
  start_.emplace(
      kind, [this](double theta, double, double) { return evaluate(theta); },
      largest, variable_.has_walls() ? 512 : 128);
}

void HalfAngleTable::tabulate(const std::function<double(double)>& reciprocal) {
  coefficients_ = {};
  std::array<double, 4 * max_terms> cosine;  // cos(m pi/(2 terms))
  for (int m = 0; m < 4 * terms_; ++m) {
    cosine[m] = std::cos(pi / 2 * m / terms_);
  }
  for (int i = 0; i < terms_; ++i) {
    // u = (1 + cos(phi))/2 at the Chebyshev points phi, 1 - u = sin^2(phi/2).
    const double half_phi = pi / 2 * (i + 0.5) / terms_;
    const auto [half_angle, complement] =
        variable_.half_angle(std::cos(half_phi) * std::cos(half_phi),
                             std::sin(half_phi) * std::sin(half_phi));
    const double g = raised(kind_, 2 * std::sin(half_angle / 2)) *
                     reciprocal(half_angle) / power_per_load(kind_) /
                     (is_limit_ ? complement : 1);
    const double value = variable_.has_walls() ? std::log(g) : g;
    // Discrete orthogonality: T_k at the point is cos(k phi).
    for (int k = 0; k < terms_; ++k) {
      coefficients_[k] += (k == 0 ? 1.0 : 2.0) / terms_ * value *
                          cosine[k * (2 * i + 1) % (4 * terms_)];
    }
  }
}

bool HalfAngleTable::is_resolved() const {
  for (int k = terms_ - 4; k < terms_; ++k) {
    if (!(std::abs(coefficients_[k]) < negligible)) return false;
  }
  return true;
}

RelationValue HalfAngleTable::evaluate(double half_angle) const noexcept {
  const auto [u, du] = variable_(half_angle);
  // Clenshaw's recurrence for the series and its derivative in v = 2u - 1.
  const double twice_v = 2 * (2 * u - 1);
  double b0 = 0, b1 = 0, d0 = 0, d1 = 0;
  for (int k = terms_ - 1; k > 0; --k) {
    const double d = 2 * b0 + twice_v * d0 - d1;
    d1 = d0;
    d0 = d;
    const double b = coefficients_[k] + twice_v * b0 - b1;
    b1 = b0;
    b0 = b;
  }
  double g = coefficients_[0] + twice_v / 2 * b0 - b1;
  double slope = 2 * du * (b0 + twice_v / 2 * d0 - d1);
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
