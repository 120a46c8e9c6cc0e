#include "libcontact/half_angle/exact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/gap/ball_gap.hpp"
#include "libcontact/conforming/gap/pin_gap.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/half_angle/approach_table.hpp"
#include "libcontact/half_angle/closing_table.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/half_angle/table.hpp"

namespace contact {

struct detail::ExactRelation {
  HalfAngleTable load;
  ApproachTable::Solver approach = {};  // none: no contact has one
  // Without a table where there is no interference.
  std::function<std::unique_ptr<ClosingTable>(double limit)> make_closing = {};
};

namespace {

using detail::ApproachTable;
using detail::ClosingTable;
using detail::ExactRelation;
using detail::HalfAngleTable;

// beta and w_2 are known to 4e-16; what so little of them does is below
// rounding.
constexpr double negligible = 1e-15;
using detail::infinity;

// An incompressible pin in a rigid hole: F = cos^4(theta0/2) has a zero of
// fourth order at the limit half-angle of 180 deg, which no series of the
// table's kind can follow. The fitted law is the closed form there.
bool closes_up(JointKind kind, const ElasticPair& pair, InnerLoading loading) {
  return kind == JointKind::pin && !loading.is_back() &&
         pair.outer_compliance_share() <= negligible &&
         std::abs(pair.dundurs_beta()) <= negligible;
}

using detail::pi;

// Below this half-angle the solutions by the pressure serve, above it those by
// the gap: both are good to 1e-11 for 15 deg on either side.
constexpr double from_gap = 115 * degree;

// Nodes that resolve the table of walls down to 0.03 radii. What is left of
// thick and homogeneous bodies is the psi^2 ln psi of a pin.
int closing_nodes(JointKind kind, const LayeredPair& pair) {
  if (pair.relative_thickness() < 0.5) return 40;
  return kind == JointKind::ball ? 24 : 48;
}

template <class Contact, class Gap>
std::unique_ptr<ClosingTable> make_closing(JointKind kind,
                                           const LayeredPair& pair,
                                           double limit) {
  const Gap gap = Gap::coarse(pair);
  // More unknowns than for narrow contacts.
  const Contact contact(pair, InnerLoading::centre(),
                        std::max(24, detail::gap_unknowns(pair)));
  const auto solver = [&](double opening) {
    return pi - opening < from_gap ? contact.signed_contact(pi - opening)
                                   : gap.solve(opening);
  };
  return std::make_unique<ClosingTable>(
      solver, pi - limit, pair.relative_thickness(), gap.mean_compliance(),
      gap.first_compliance(), closing_nodes(kind, pair));
}

void add_closing(ExactRelation& relation, JointKind kind,
                 const LayeredPair& pair, const InnerLoading& loading) {
  if (loading.is_back() || !detail::can_have_interference(kind, pair)) return;
  relation.make_closing = [kind, pair](double limit) {
    return kind == JointKind::pin
               ? make_closing<PinContact, detail::PinGap>(kind, pair, limit)
               : make_closing<BallContact, detail::BallGap>(kind, pair, limit);
  };
}

template <class Contact>
ExactRelation relation_of(JointKind kind, const Contact& contact,
                          const ExactHalfAngle& limit,
                          double thickness = infinity) {
  return {{kind,
           [&contact](double theta) { return contact.reciprocal_load(theta); },
           limit.half_angle, limit.status == Status::ok, thickness},
          [contact](double theta) { return contact.force_point(theta); }};
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
  auto relation = std::make_unique<ExactRelation>(
      kind == JointKind::pin ? pin_relation(pair, loading)
                             : ball_relation(pair, loading));
  add_closing(*relation, kind, detail::without_layers(pair), loading);
  relation_ = std::move(relation);
  // Build the table now, so that half_angle() never allocates.
  if (!relation_->load.reaches_limit()) closing();
}

ExactLaw::ExactLaw(JointKind kind, const LayeredPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind, MadeFor(pair.surfaces(), {loading, pair})),
      walls_(pair) {
  auto relation = std::make_unique<ExactRelation>(
      kind == JointKind::pin
          ? walled_pin_relation(pair, loading)
          : ball_relation(pair, loading, pair.relative_thickness()));
  add_closing(*relation, kind, pair, loading);
  relation_ = std::move(relation);
  // Build the table now, so that half_angle() never allocates.
  if (!relation_->load.reaches_limit()) closing();
}

ExactLaw::~ExactLaw() = default;

const ClosingTable* ExactLaw::closing() const {
  std::call_once(closing_asked_, [this] {
    if (!relation_ || !relation_->make_closing) return;
    closing_ = relation_->make_closing(relation_->load.largest());
  });
  return closing_.get();
}

namespace {

// x by 1/mu or 1/lambda.
double inverse_unit(JointKind kind) {
  return kind == JointKind::pin ? 0.5 : pi / 2;
}

// theta0 at x, from the limit half-angle to 180 deg.
HalfAngleResult closing_half_angle(const ClosingTable& table, double inverse) {
  const double beyond = inverse + table.mean_compliance();
  if (beyond <= 0) return {pi, Status::ok, 0};
  const ClosingTable::Root root = table.opening(inverse);
  const double half_angle = pi - root.opening;
  return {half_angle, Status::ok, inverse / beyond * root.slope / half_angle};
}

}  // namespace

double ExactLaw::load_of_inverse(double inverse) const {
  return inverse_unit(joint_kind()) / inverse;
}

HalfAngleResult ExactLaw::half_angle(double load_parameter) const noexcept {
  const auto by_gap = [&] {
    return closing_half_angle(*closing(),
                              inverse_unit(joint_kind()) / load_parameter);
  };
  if (std::signbit(load_parameter)) {
    using detail::nan;
    if (std::isnan(load_parameter) || !closing()) {
      return {nan, Status::out_of_range};
    }
    return by_gap();
  }
  if (!relation_) return closed_form_->half_angle(load_parameter);
  const HalfAngleResult result = relation_->load.half_angle(load_parameter);
  // The solution by the gap goes on where that by the pressure ends.
  return result.status == Status::not_converged && closing() ? by_gap()
                                                             : result;
}

LoadParameterResult ExactLaw::load_parameter(double half_angle) const noexcept {
  if (relation_ && half_angle > relation_->load.largest() && half_angle <= pi &&
      closing()) {
    return {load_of_inverse(closing()->at(pi - half_angle).inverse),
            Status::ok};
  }
  return relation_ ? relation_->load.load_parameter(half_angle)
                   : closed_form_->load_parameter(half_angle);
}

double ExactLaw::closing_load() const {
  return closing() ? load_of_inverse(-closing()->mean_compliance())
                   : HalfAngleLaw::closing_load();
}

ContactApproach ExactLaw::shift(double half_angle) const {
  if (!(half_angle >= limit_half_angle() && half_angle <= pi) || !closing()) {
    return HalfAngleLaw::shift(half_angle);
  }
  const detail::SignedContact c = closing()->at(pi - half_angle);
  const double first = closing()->first_compliance();
  // P = pi E K_1/4, R_n = pi rho E K_1/3.
  const double unit = joint_kind() == JointKind::pin ? pi / 4 : pi / 3;
  return {first + c.gap_shift, unit / (first + c.gap_compliance)};
}

double ExactLaw::limit_half_angle() const noexcept {
  if (!relation_) return closed_form_->limit_half_angle();
  if (relation_->load.reaches_limit() || !closing()) {
    return relation_->load.largest();
  }
  return pi - closing()->opening(0).opening;
}

ContactApproach ExactLaw::approach(double half_angle) const {
  std::call_once(approach_asked_, [this] {
    if (!relation_ || !relation_->approach) return;
    const HalfAngleTable& load = relation_->load;
    const ApproachTable::Solver& solver = relation_->approach;
    // A contact has an approach at all half-angles or at none.
    if (std::isnan(solver(load.largest() / 2).approach.approach)) return;
    approach_ =
        std::make_unique<const ApproachTable>(joint_kind(), load, solver);
  });
  return approach_ ? (*approach_)(half_angle)
                   : HalfAngleLaw::approach(half_angle);
}

std::vector<std::string> ExactLaw::validity_notes(const ElasticPair&) const {
  std::vector<std::string> notes;
  if (relation_ && !relation_->load.reaches_limit() && !closing()) {
    notes.push_back(
        detail::message("the exact solution ends at {:.4g} deg, before the "
                        "limit half-angle of this pair",
                        relation_->load.largest() / degree));
  }
  std::string thin = walls_ ? detail::unresolved_note(*walls_) : "";
  if (!thin.empty()) notes.push_back(std::move(thin));
  return notes;
}

namespace detail {

extern constexpr HalfAngleEntry exact_law = {
    .about = {.name = "exact",
              .meaning = "the theory of elasticity itself",
              .accuracy = "1e-6 deg",
              .needs = LawEntry::Needs::conditions,
              .allows_back = true,
              .allows_walls = true,
              .least_clearance = Clearance::interference,
              .is_slow_to_make = true},
    .ball_cost = 24,
    .pin_cost = 14,
    .make = [](const HalfAngleRequest& asked) -> std::unique_ptr<HalfAngleLaw> {
      const auto& [loading, walls, clearance] = asked.conditions;
      return walls
                 ? std::make_unique<ExactLaw>(asked.kind, *walls, loading)
                 : std::make_unique<ExactLaw>(asked.kind, asked.pair, loading);
    }};

}  // namespace detail
}  // namespace contact
