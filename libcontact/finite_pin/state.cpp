// Numbers of a state beside its sums: ends of contact, largest values.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

#include "libcontact/base/constants.hpp"
#include "libcontact/finite_pin/sums.hpp"

namespace contact {
namespace {

using Eigen::Vector4d;

using detail::nan;

// For a table within 1e-8, and 3e-6 where under thin layers the largest
// pressure begins to leave the middle.
constexpr int table_size = 512;

// The largest pressure without its pole.
double tamed(double half_angle) { return std::sin(half_angle / 2); }

using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

// Over roots of the half-angle.
Spline tabulated(const PressureLaw& pressure, double from, double to) {
  const double step = (to - from) / (table_size - 1);
  std::vector<double> values;
  for (int i = 0; i < table_size; ++i) {
    const double root = std::min(from + i * step, to);
    // The root's square may lie beyond the end by rounding.
    const double half_angle = std::min(root * root, to * to * (1 - 1e-15));
    values.push_back(pressure.peak(half_angle) * tamed(half_angle));
  }
  // Slopes at the ends to the fourth power of the step: Boost's are to a lower
  // one.
  const auto slope = [&](int end, int inwards) {
    const auto at = [&](int i) { return values[end + i * inwards]; };
    return (-25 * at(0) + 48 * at(1) - 36 * at(2) + 16 * at(3) - 3 * at(4)) /
           (12 * inwards * step);
  };
  return {values.data(), values.size(), from,
          step,          slope(0, 1),   slope(table_size - 1, -1)};
}

}  // namespace

FinitePin::Peaks::Peaks(const PressureLaw& pressure, const ForceLaw& law)
    : from_(std::sqrt(law.half_angle(law.smallest_penetration()))),
      to_(std::sqrt(law.half_angle(law.largest_penetration()))),
      spline_(tabulated(pressure, from_, to_)) {}

double FinitePin::Peaks::operator()(double half_angle) const noexcept {
  const double root = std::clamp(std::sqrt(half_angle), from_, to_);
  return spline_(root) / tamed(half_angle);
}

double FinitePin::peak(const Slice& slice) const noexcept {
  // 0 or NaN.
  if (!(slice.force > 0)) return slice.force;
  return pressure_->peak(slice.half_angle) *
         joint_.geometry.pressure_unit(slice.force);
}

// The table says between which places it is: exact ones are then 20. It may lie
// in the next piece of the relief, whose slope goes on.
void FinitePin::find_peak(const Vector4d& place,
                          const std::vector<Interval>& contacts,
                          FinitePinState& state) const noexcept {
  constexpr int steps = 32;
  std::vector<double> nodes;
  std::size_t best = 0;
  double most = 0;
  for (const auto& [from, to, piece] : contacts) {
    for (int i = 0; i <= steps; ++i) {
      const double z = i == steps ? to : from + i * (to - from) / steps;
      nodes.push_back(z);
      const Slice at = slice(place, z, *piece);
      if (!(at.force > 0)) continue;
      const double about = (*peaks_)(at.half_angle) * at.force;
      if (!(about > most)) continue;
      best = nodes.size() - 1;
      most = about;
    }
  }
  if (most == 0) return;
  const auto exact = [&](double z) {
    return peak(slice(place, z, piece_at(z)));
  };
  constexpr int bits = 26;
  std::uintmax_t evaluations = 60;
  state.peak_place = nodes[best];
  state.peak_pressure = exact(state.peak_place);
  // Two nodes lie where pieces meet.
  const auto beside = [&](std::size_t away, int step) {
    std::size_t i = best;
    while (i != away && nodes[i] == nodes[best]) i += step;
    return nodes[i];
  };
  const auto [z, least] = boost::math::tools::brent_find_minima(
      [&](double at) { return -exact(at); }, beside(0, -1),
      beside(nodes.size() - 1, 1), bits, evaluations);
  if (-least > state.peak_pressure) {
    state.peak_place = z;
    state.peak_pressure = -least;
  }
}

FinitePinState FinitePin::state(const Vector4d& place,
                                const Sums& all) const noexcept {
  const bool has_value = all.load.allFinite();
  FinitePinState s{.status = has_value ? Status::ok : Status::out_of_range,
                   .shift = place.head<2>(),
                   .tilt = place.tail<2>(),
                   .force = all.load.head<2>(),
                   .force_moment = all.load.tail<2>(),
                   .energy = all.energy,
                   .stiffness = all.stiffness,
                   .low = nan,
                   .high = nan,
                   .peak_pressure = has_value ? 0 : nan,
                   .peak_place = nan,
                   .largest_half_angle = has_value ? 0 : nan,
                   .half_angle_place = nan,
                   .end_pressure = {},
                   .end_half_angle = {},
                   .pressure_moment = all.pressure_moment,
                   .area_tangent = all.area.head<2>(),
                   .area_tangent_moment = all.area.tail<2>(),
                   .area_moment = all.area_moment};
  const std::vector<Interval> contacts = intervals(place);
  if (has_value) find_peak(place, contacts, s);
  for (const Interval& interval : contacts) {
    // Intervals of adjacent relief pieces that meet are one.
    if (s.pieces == 0) s.low = interval.from;
    if (s.pieces == 0 || interval.from > s.high) ++s.pieces;
    s.high = interval.to;
    for (const double z : summits(place, interval)) {
      const double half_angle = slice(place, z, *interval.piece).half_angle;
      if (half_angle > s.largest_half_angle) {
        s.largest_half_angle = half_angle;
        s.half_angle_place = z;
      }
    }
  }
  for (const int end : {0, 1}) {
    const double z = end == 0 ? -half_length_ : half_length_;
    const Slice at =
        slice(place, z, end == 0 ? pieces_.front() : pieces_.back());
    s.end_pressure[end] = peak(at);
    s.end_half_angle[end] = at.half_angle;
  }
  return s;
}

}  // namespace contact
