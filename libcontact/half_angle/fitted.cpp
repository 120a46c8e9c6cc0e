#include "libcontact/half_angle/fitted.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/coefficients.hpp"
#include "libcontact/half_angle/fitted_relation.hpp"
#include "libcontact/pair/poisson_notes.hpp"

namespace contact {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Root of a function that changes its sign on [low, high], to 53 bits.
template <class Function>
RootBracket root_between(const Function& f, double low, double high) {
  return shrink_bracket(f, low, high, f(low), f(high), 53);
}

// theta0*, where F falls to 0. An incompressible inner body in a rigid outer
// one closes up: pi.
double limit_of(const detail::FittedRelation& relation) {
  const auto f = [&relation](double theta) {
    return relation(theta, std::sin(theta / 2), std::cos(theta / 2)).value;
  };
  // All pairs reach 60 deg. Next to pi the sign of F may be rounding.
  for (const double distance : {1e-6, 1e-3}) {
    const double high = pi * (1 - distance);
    if (!(f(high) < 0)) continue;
    return root_between(f, pi / 3, high).middle();
  }
  return pi;
}

}  // namespace

class detail::FittedHalfAngle {
 public:
  FittedHalfAngle(JointKind kind, const ElasticPair& pair)
      : relation(kind, pair),
        limit(limit_of(relation)),
        start(kind, relation, limit) {}

  FittedRelation relation;
  double limit;
  HalfAngleStart start;
};

FittedLaw::FittedLaw(JointKind kind, const ElasticPair& pair)
    : HalfAngleLaw(kind),
      fit_(std::make_unique<const detail::FittedHalfAngle>(kind, pair)) {}

FittedLaw::~FittedLaw() = default;

HalfAngleResult FittedLaw::half_angle(double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range};
  if (load_parameter == 0) {
    return {0, Status::ok, 1.0 / detail::load_power(joint_kind())};
  }
  if (std::isinf(load_parameter)) return {fit_->limit, Status::ok, 0};
  return fit_->relation.solve(fit_->start, fit_->limit, load_parameter);
}

LoadParameterResult FittedLaw::load_parameter(
    double half_angle) const noexcept {
  if (!(half_angle >= 0 && half_angle <= fit_->limit)) {
    return {nan, Status::out_of_range};
  }
  if (half_angle == 0) return {0, Status::ok};
  if (half_angle == fit_->limit) return {infinity, Status::ok};
  return {detail::load_at(joint_kind(), fit_->relation, half_angle),
          Status::ok};
}

double FittedLaw::limit_half_angle() const noexcept { return fit_->limit; }

std::vector<std::string> FittedLaw::validity_notes(const ElasticPair&) const {
  return {};
}

namespace {

// Infinity without infinity/infinity.
double al_of(double modulus_ratio) {
  detail::require(modulus_ratio >= 0, "nominal law", "modulus_ratio",
                  modulus_ratio, "0 to inf");
  return modulus_ratio < 1 ? (modulus_ratio - 1) / (modulus_ratio + 1)
                           : (1 - 1 / modulus_ratio) / (1 + 1 / modulus_ratio);
}

double quadratic(const double (&c)[3], double al) {
  return c[0] + al * (c[1] + al * c[2]);
}

double limit_deg(const double (&c)[4], double al) {
  return c[0] + al * (c[1] + al * (c[2] + al * c[3]));
}

}  // namespace

NominalLaw::NominalLaw(JointKind kind, double modulus_ratio)
    : NominalLaw(kind, al_of(modulus_ratio),
                 kind == JointKind::ball ? detail::nominal_ball
                                         : detail::nominal_pin) {}

NominalLaw::NominalLaw(JointKind kind, double al,
                       const detail::NominalCoefficients& table)
    : SaturatingLaw(
          kind, LimitHalfAngle::given(limit_deg(table.limit_deg, al) * degree),
          1),
      n1_(quadratic(table.n1, al)),
      n2_(quadratic(table.n2, al)),
      d1_(quadratic(table.d1, al)),
      d2_(quadratic(table.d2, al)) {}

std::vector<std::string> NominalLaw::validity_notes(
    const ElasticPair& pair) const {
  return detail::poisson_notes("the law is made", pair);
}

NominalLaw::Shape NominalLaw::shape(double xi) const noexcept {
  if (xi <= 1) {
    // g^2 = xi^2 p/q
    const double p = 1 + xi * (n1_ + xi * n2_);
    const double q = 1 + xi * (d1_ + xi * (d2_ + xi * (n1_ + xi * n2_)));
    const double dp = n1_ + 2 * xi * n2_;
    const double dq = d1_ + xi * (2 * d2_ + xi * (3 * n1_ + xi * 4 * n2_));
    const double root = std::sqrt(p / q);
    return {xi * root, root * (1 + xi / 2 * (dp / p - dq / q))};
  }
  // The same in y = 1/xi: g^2 = p/q, q - p = y^2 (d2 - 1 + d1 y + y^2).
  const double y = 1 / xi;
  const double p = n2_ + y * (n1_ + y);
  const double q = p + y * y * (d2_ - 1 + y * (d1_ + y));
  const double dp = n1_ + 2 * y;
  const double dq = n1_ + y * (2 * d2_ + y * (3 * d1_ + 4 * y));
  const double value = std::sqrt(p / q);
  return {value, -y * y / 2 * value * (dp / p - dq / q)};
}

NominalLaw::InverseResult NominalLaw::inverse_shape(
    double ratio, double complement) const noexcept {
  const auto result = [](const RootBracket& root, double xi) {
    return InverseResult{xi,
                         root.converged ? Status::ok : Status::not_converged};
  };
  // g lies between xi/1.2 and 1.2 xi for small xi.
  if (ratio <= 0.5) {
    const RootBracket root =
        root_between([&](double v) { return shape(v).value - ratio; },
                     ratio / 1.2, 2 * ratio);
    return result(root, root.middle());
  }
  // q - p = (1 - ratio^2) q in y = 1/xi.
  const double rest = complement * (1 + ratio);
  const RootBracket root = root_between(
      [&](double y) {
        const double p = n2_ + y * (n1_ + y);
        const double difference = y * y * (d2_ - 1 + y * (d1_ + y));
        return (1 - rest) * difference - rest * p;
      },
      // rest p -> rest n2 and difference <= some y^2 as y -> 0.
      0.1 * std::sqrt(rest), 1.2 / ratio);
  return result(root, 1 / root.middle());
}

}  // namespace contact
