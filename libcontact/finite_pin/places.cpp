// The contact at places along a pin, and the motion there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/finite_pin/sums.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {

using Eigen::Vector2d;
using Eigen::Vector4d;

FinitePin::Slice FinitePin::slice(const FinitePinState& state,
                                  double z) const noexcept {
  Slice at = slice_without_peak(state, z);
  at.peak = peak(at);
  return at;
}

const Relief::Piece& FinitePin::piece_at(double z) const noexcept {
  const Relief::Piece* piece = &pieces_.front();
  for (const Relief::Piece& next : pieces_) {
    if (z >= next.from) piece = &next;
  }
  return *piece;
}

FinitePin::Slice FinitePin::slice_without_peak(const FinitePinState& state,
                                               double z) const noexcept {
  const Vector4d place = (Vector4d() << state.shift, state.tilt).finished();
  Slice at = slice(place, z, piece_at(z));
  if (std::abs(z) > half_length_) {
    at.force = at.slope = at.energy = at.half_angle = 0;
  }
  return at;
}

double FinitePin::pressure(const FinitePinState& state, double z,
                           double theta) const noexcept {
  double p = 0;
  pressures(state, z, {&theta, 1}, {&p, 1});
  return p;
}

void FinitePin::pressures(const FinitePinState& state, double z,
                          std::span<const double> theta,
                          std::span<double> out) const noexcept {
  const Slice at = slice_without_peak(state, z);
  if (!(at.force > 0)) {  // 0 or NaN
    std::fill(out.begin(), out.end(), at.force);
    return;
  }
  const double middle = std::atan2(at.direction.y(), at.direction.x());
  const double unit = joint_.geometry.pressure_unit(at.force);
  const detail::PressureProfile profile(*pressure_, at.half_angle);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = unit * profile.pressure(std::remainder(theta[i] - middle,
                                                    2 * std::numbers::pi));
  }
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
