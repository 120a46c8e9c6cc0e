#include "libcontact/half_angle/exact.hpp"

#include <cmath>
#include <limits>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/table.hpp"

namespace contact {
namespace {

using detail::HalfAngleTable;

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
HalfAngleTable table_of(JointKind kind, const Contact& contact,
                        const ExactHalfAngle& limit,
                        double thickness = infinity) {
  return {kind,
          [&contact](double theta) { return contact.reciprocal_load(theta); },
          limit.half_angle, limit.status == Status::ok, thickness};
}

template <class Pair>
HalfAngleTable ball_table(const Pair& pair, InnerLoading loading,
                          double thickness = infinity) {
  const BallContact ball(pair, loading);
  return table_of(JointKind::ball, ball, ball.limit_half_angle(), thickness);
}

HalfAngleTable pin_table(const ElasticPair& pair, InnerLoading loading) {
  constexpr JointKind kind = JointKind::pin;
  if (!loading.is_back() && std::abs(pair.dundurs_beta()) <= negligible) {
    const PinClosedForm pin(pair.outer_compliance_share());
    return {kind, [&pin](double theta) { return pin.reciprocal_load(theta); },
            pin.limit_half_angle(), true};
  }
  const PinContact pin(pair, loading);
  const ExactHalfAngle limit = pin.limit_half_angle();
  if (limit.status == Status::ok) return table_of(kind, pin, limit);
  const PinContact fine(pair, loading, PinContact::max_unknowns);
  return table_of(kind, fine, fine.limit_half_angle());
}

HalfAngleTable walled_pin_table(const LayeredPair& pair, InnerLoading loading) {
  constexpr JointKind kind = JointKind::pin;
  const double thickness = pair.relative_thickness();
  const PinContact pin(pair, loading);
  const ExactHalfAngle limit = pin.limit_half_angle();
  if (limit.status != Status::ok) {
    // Thin walls have as many unknowns, or more.
    const PinContact fine(pair, loading, PinContact::max_unknowns);
    if (fine.largest() > pin.largest()) {
      return table_of(kind, fine, fine.limit_half_angle(), thickness);
    }
  }
  return table_of(kind, pin, limit, thickness);
}

}  // namespace

ExactLaw::ExactLaw(JointKind kind, const ElasticPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind) {
  if (closes_up(kind, pair, loading)) {
    closed_form_ = std::make_unique<const FittedLaw>(kind, pair);
    return;
  }
  table_ = std::make_unique<const HalfAngleTable>(
      kind == JointKind::pin ? pin_table(pair, loading)
                             : ball_table(pair, loading));
}

ExactLaw::ExactLaw(JointKind kind, const LayeredPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind),
      table_(std::make_unique<const HalfAngleTable>(
          kind == JointKind::pin
              ? walled_pin_table(pair, loading)
              : ball_table(pair, loading, pair.relative_thickness()))) {}

ExactLaw::~ExactLaw() = default;

HalfAngleResult ExactLaw::half_angle(double load_parameter) const noexcept {
  return table_ ? table_->half_angle(load_parameter)
                : closed_form_->half_angle(load_parameter);
}

LoadParameterResult ExactLaw::load_parameter(double half_angle) const noexcept {
  return table_ ? table_->load_parameter(half_angle)
                : closed_form_->load_parameter(half_angle);
}

double ExactLaw::limit_half_angle() const noexcept {
  return table_ ? table_->largest() : closed_form_->limit_half_angle();
}

std::vector<std::string> ExactLaw::validity_notes(const ElasticPair&) const {
  if (!table_ || table_->reaches_limit()) return {};
  return {
      detail::message("the exact solution ends at {:.4g} deg, before the limit "
                      "half-angle of this pair",
                      table_->largest() / degree)};
}

}  // namespace contact
