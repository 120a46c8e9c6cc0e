// The contact at places along a pin, and what moves there.
#include <cmath>
#include <numbers>

#include "libcontact/finite_pin/sums.hpp"

namespace contact {

using Eigen::Vector2d;
using Eigen::Vector4d;

FinitePin::Slice FinitePin::slice(const FinitePinState& state,
                                  double z) const noexcept {
  const Vector4d place = (Vector4d() << state.shift, state.tilt).finished();
  const Relief::Piece* piece = &pieces_.front();
  for (const Relief::Piece& next : pieces_) {
    if (z >= next.from) piece = &next;
  }
  Slice at = slice(place, z, *piece);
  if (std::abs(z) > half_length_) {
    at.force = at.slope = at.energy = at.half_angle = at.peak = 0;
  }
  return at;
}

double FinitePin::pressure(const FinitePinState& state, double z,
                           double theta) const noexcept {
  const Slice at = slice(state, z);
  // 0 or NaN.
  if (!(at.force > 0)) return at.force;
  const double from_middle =
      std::remainder(theta - std::atan2(at.direction.y(), at.direction.x()),
                     2 * std::numbers::pi);
  return pressure_->pressure(from_middle, at.half_angle) *
         joint_.geometry.pressure_unit(at.force);
}

double FinitePin::slip_speed(const Motion& motion) const noexcept {
  return std::hypot(joint_.geometry.radius() * motion.rate,
                    motion.axial_velocity);
}

double FinitePin::largest_pv(const FinitePinState& state,
                             const Motion& motion) const noexcept {
  return state.peak_pressure * slip_speed(motion);
}

}  // namespace contact
