#include "libcontact/half_angle/exact.hpp"

#include <cmath>
#include <limits>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/approach_table.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/half_angle/table.hpp"

namespace contact {

struct detail::ExactRelation {
  HalfAngleTable load;
  ApproachTable::Solver approach = {};  // none: no contact has one
};

namespace {

using detail::ApproachTable;
using detail::ExactRelation;

// beta and w_2 are known to 4e-16; what so little of them does is below
// rounding.
constexpr double negligible = 1e-15;
constexpr double infinity = std::numeric_limits<double>::infinity();

// An incompressible pin in a rigid hole: F = cos^4(theta0/2) has a zero of
// fourth order at the limit half-angle of 180 deg, which no series of the
// table's kind can follow. The fitted law is the closed form there.
bool closes_up(JointKind kind, const ElasticPair& pair, InnerLoading loading) {
  return kind == JointKind::pin && !loading.is_back() &&
         pair.outer_compliance_share() <= negligible &&
         std::abs(pair.dundurs_beta()) <= negligible;
}

template <class Contact>
ExactRelation relation_of(JointKind kind, const Contact& contact,
                          const ExactHalfAngle& limit,
                          double thickness = infinity) {
  return {{kind,
           [&contact](double theta) { return contact.reciprocal_load(theta); },
           limit.half_angle, limit.status == Status::ok, thickness},
          [contact](double theta) { return contact.approach(theta); }};
}

template <class Pair>
ExactRelation ball_relation(const Pair& pair, InnerLoading loading,
                            double thickness = infinity) {
  const BallContact ball(pair, loading);
  return relation_of(JointKind::ball, ball, ball.limit_half_angle(), thickness);
}

ExactRelation pin_relation(const ElasticPair& pair, InnerLoading loading) {
  constexpr JointKind kind = JointKind::pin;
  if (!loading.is_back() && std::abs(pair.dundurs_beta()) <= negligible) {
    const PinClosedForm pin(pair.outer_compliance_share());
    return {{kind, [&pin](double theta) { return pin.reciprocal_load(theta); },
             pin.limit_half_angle(), true}};
  }
  const PinContact pin(pair, loading);
  const ExactHalfAngle limit = pin.limit_half_angle();
  if (limit.status == Status::ok) return relation_of(kind, pin, limit);
  const PinContact fine(pair, loading, PinContact::max_unknowns);
  return relation_of(kind, fine, fine.limit_half_angle());
}

ExactRelation walled_pin_relation(const LayeredPair& pair,
                                  InnerLoading loading) {
  constexpr JointKind kind = JointKind::pin;
  const double thickness = pair.relative_thickness();
  const PinContact pin(pair, loading);
  const ExactHalfAngle limit = pin.limit_half_angle();
  if (limit.status != Status::ok) {
    // Thin walls have as many unknowns, or more.
    const PinContact fine(pair, loading, PinContact::max_unknowns);
    if (fine.largest() > pin.largest()) {
      return relation_of(kind, fine, fine.limit_half_angle(), thickness);
    }
  }
  return relation_of(kind, pin, limit, thickness);
}

}  // namespace

ExactLaw::ExactLaw(JointKind kind, const ElasticPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind, MadeFor(pair, {.loading = loading})) {
  if (closes_up(kind, pair, loading)) {
    closed_form_ = std::make_unique<const FittedLaw>(kind, pair);
    return;
  }
  relation_ = std::make_unique<const ExactRelation>(
      kind == JointKind::pin ? pin_relation(pair, loading)
                             : ball_relation(pair, loading));
}

ExactLaw::ExactLaw(JointKind kind, const LayeredPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind, MadeFor(pair.surfaces(), {loading, pair})),
      relation_(std::make_unique<const ExactRelation>(
          kind == JointKind::pin
              ? walled_pin_relation(pair, loading)
              : ball_relation(pair, loading, pair.relative_thickness()))) {}

ExactLaw::~ExactLaw() = default;

HalfAngleResult ExactLaw::half_angle(double load_parameter) const noexcept {
  return relation_ ? relation_->load.half_angle(load_parameter)
                   : closed_form_->half_angle(load_parameter);
}

LoadParameterResult ExactLaw::load_parameter(double half_angle) const noexcept {
  return relation_ ? relation_->load.load_parameter(half_angle)
                   : closed_form_->load_parameter(half_angle);
}

double ExactLaw::limit_half_angle() const noexcept {
  return relation_ ? relation_->load.largest()
                   : closed_form_->limit_half_angle();
}

ContactApproach ExactLaw::approach(double half_angle) const {
  std::call_once(approach_asked_, [this] {
    if (!relation_ || !relation_->approach) return;
    const auto& [load, solver] = *relation_;
    // A contact has an approach at all half-angles or at none.
    if (std::isnan(solver(load.largest() / 2).approach)) return;
    approach_ =
        std::make_unique<const ApproachTable>(joint_kind(), load, solver);
  });
  return approach_ ? (*approach_)(half_angle)
                   : HalfAngleLaw::approach(half_angle);
}

std::vector<std::string> ExactLaw::validity_notes(const ElasticPair&) const {
  if (!relation_ || relation_->load.reaches_limit()) return {};
  return {
      detail::message("the exact solution ends at {:.4g} deg, before the limit "
                      "half-angle of this pair",
                      relation_->load.largest() / degree)};
}

namespace detail {

extern constexpr HalfAngleEntry exact_law = {
    .about = {.name = "exact",
              .meaning = "the theory of elasticity itself",
              .accuracy = "1e-6 deg",
              .needs = LawEntry::Needs::conditions,
              .allows_back = true,
              .allows_walls = true,
              .is_slow_to_make = true},
    .ball_cost = 25,
    .pin_cost = 15,
    .make = [](const HalfAngleRequest& asked) -> std::unique_ptr<HalfAngleLaw> {
      const auto& [loading, walls] = asked.conditions;
      return walls
                 ? std::make_unique<ExactLaw>(asked.kind, *walls, loading)
                 : std::make_unique<ExactLaw>(asked.kind, asked.pair, loading);
    }};

}  // namespace detail
}  // namespace contact
