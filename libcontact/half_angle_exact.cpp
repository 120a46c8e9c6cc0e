#include "libcontact/half_angle_exact.hpp"

#include <fmt/format.h>

#include <cmath>

#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/detail/half_angle_table.hpp"
#include "libcontact/units.hpp"

namespace contact {
namespace {

using detail::HalfAngleTable;

template <class Contact>
HalfAngleTable table_of(JointKind kind, const Contact& contact) {
  const ExactHalfAngle limit = contact.limit_half_angle();
  return {kind,
          [&contact](double theta) { return contact.reciprocal_load(theta); },
          limit.half_angle, limit.status == Status::ok};
}

HalfAngleTable pin_table(const ElasticPair& pair, InnerLoading loading) {
  constexpr JointKind kind = JointKind::cylindrical;
  // beta is known to 4e-16; what so little of it does is below rounding.
  if (!loading.is_back() && std::abs(pair.dundurs_beta()) <= 1e-15) {
    const PinClosedForm pin(pair.outer_compliance_share());
    return {kind, [&pin](double theta) { return pin.reciprocal_load(theta); },
            pin.limit_half_angle(), true};
  }
  const HalfAngleTable table = table_of(kind, PinContact(pair, loading));
  if (table.reaches_limit()) return table;
  return table_of(kind, PinContact(pair, loading, PinContact::max_unknowns));
}

}  // namespace

ExactLaw::ExactLaw(JointKind kind, const ElasticPair& pair,
                   InnerLoading loading)
    : HalfAngleLaw(kind),
      table_(std::make_unique<const HalfAngleTable>(
          kind == JointKind::cylindrical
              ? pin_table(pair, loading)
              : table_of(kind, BallContact(pair, loading)))) {}

ExactLaw::~ExactLaw() = default;

HalfAngleResult ExactLaw::half_angle(double load_parameter) const noexcept {
  return table_->half_angle(load_parameter);
}

LoadParameterResult ExactLaw::load_parameter(double half_angle) const noexcept {
  return table_->load_parameter(half_angle);
}

double ExactLaw::limit_half_angle() const noexcept { return table_->largest(); }

std::vector<std::string> ExactLaw::validity_notes(const ElasticPair&) const {
  if (table_->reaches_limit()) return {};
  return {
      fmt::format("the exact solution ends at {:.4g} deg, before the limit "
                  "half-angle of this pair",
                  table_->largest() / degree)};
}

}  // namespace contact
