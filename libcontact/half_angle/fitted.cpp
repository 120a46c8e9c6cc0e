#include "libcontact/half_angle/fitted.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/coefficients.hpp"
#include "libcontact/half_angle/fitted_relation.hpp"
#include "libcontact/half_angle/registry.hpp"

namespace contact {
namespace {

using detail::infinity;
using detail::nan;
using detail::pi;

// Root of a function that changes its sign on [low, high], to 53 bits.
template <class Function>
RootBracket root_between(const Function& f, double low, double high) {
  return shrink_bracket(f, low, high, f(low), f(high), 53);
}

// theta0*, where F falls to 0. An incompressible inner body in a rigid outer
// one closes up: pi.
double limit_of_fit(const detail::FittedRelation& relation) {
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
        limit(limit_of_fit(relation)),
        start(kind, relation, limit) {}

  FittedRelation relation;
  double limit;
  HalfAngleStart start;
};

FittedLaw::FittedLaw(JointKind kind, const ElasticPair& pair)
    : HalfAngleLaw(kind, MadeFor(pair)),
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

namespace detail {

extern constexpr HalfAngleEntry fitted_law = {
    .about = {.name = "fitted",
              .meaning = "explicit load(theta0), fitted to the exact contact",
              .accuracy = "0.021 % (pin), 0.07 % (ball)",
              .needs = LawEntry::Needs::materials},
    .ball_cost = 13,
    .pin_cost = 10,
    .make = [](const HalfAngleRequest& asked) -> std::unique_ptr<HalfAngleLaw> {
      return std::make_unique<FittedLaw>(asked.kind, asked.pair);
    }};

}  // namespace detail
}  // namespace contact
