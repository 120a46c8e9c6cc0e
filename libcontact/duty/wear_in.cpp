#include "libcontact/duty/wear_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/friction/special.hpp"
#include "libcontact/half_angle/worn.hpp"

namespace contact {
namespace {

double unit_volume(const JointGeometry& geometry) {
  const double size = geometry.radius() * geometry.radial_clearance();
  return geometry.kind() == JointKind::ball
             ? std::numbers::pi * geometry.radius() * size
             : 2 * geometry.length() * size;
}

// One cycle of a joint that is worn so far.
struct WornCycle {
  double pv = 0;             // integral over contact and time, J
  double overlap = 0;        // mean g(theta0)
  double fresh_overlap = 0;  // the same without wear
};

WornCycle run_cycle(const JointCycle& cycle, WornState& state) {
  WornCycle sums;
  const JointKind kind = cycle.contact().geometry().kind();
  for (const CycleInstant& i : cycle.rows()) {
    state.half_angle = std::max(state.half_angle, i.solution.half_angle);
    state.peak_pressure =
        std::max(state.peak_pressure, i.solution.peak_pressure);
    state.pv = std::max(state.pv, cycle.sliding(i).largest_pv().value);
  }
  for (const CycleInstant& i : cycle.nodes()) {
    const double pv = i.weight * cycle.sliding(i).pv_total();
    const double g = WornHalfAngle::overlap(kind, i.solution.half_angle);
    sums.pv += pv;
    sums.overlap += pv * g;
    sums.fresh_overlap += pv * (g - state.wear_number);
    state.energy -= i.weight * i.solution.power;
    state.mean_moment +=
        i.weight * i.solution.friction_moment.norm() / cycle.cycle().period();
  }
  if (sums.pv > 0) {
    sums.overlap /= sums.pv;
    sums.fresh_overlap /= sums.pv;
  }
  return sums;
}

}  // namespace

std::vector<WornState> wear_in(const DutyCycle& cycle,
                               const JointContact& contact, double coefficient,
                               double cycles) {
  constexpr double largest_growth = 0.1;
  detail::require(coefficient >= 0 && std::isfinite(coefficient), "wear",
                  "coefficient", coefficient, "0 m^2/N or above and finite");
  detail::require(cycles >= 0 && std::isfinite(cycles), "wear", "cycles",
                  cycles, "0 or above and finite");
  const JointGeometry& geometry = contact.geometry();
  const double unit = unit_volume(geometry);
  const Joint unworn(contact);
  check_wear(JointCycle(cycle, unworn));
  std::vector<WornState> states;
  WornState next;
  for (;;) {
    WornState& now = states.emplace_back(next);
    now.wear_number = now.volume / unit;
    const Joint joint(contact.worn(now.wear_number, now.worn_in));
    const WornCycle sums = run_cycle(JointCycle(cycle, joint), now);
    now.penetration = geometry.radial_clearance() *
                      (1 / std::cos(WornHalfAngle::half_angle_of_overlap(
                               geometry.kind(), sums.overlap)) -
                       1);
    if (now.cycles >= cycles) return states;
    const double growth = coefficient * sums.pv / unit;  // of v in a cycle
    // At least a cycle: what wears so fast is no bearing.
    const double block =
        std::min(cycles - now.cycles,
                 std::max(largest_growth * sums.overlap / growth, 1.0));
    next = {};
    next.cycles = now.cycles + block;
    next.volume = now.volume + block * coefficient * sums.pv;
    next.worn_in = next.volume / unit > sums.fresh_overlap;
  }
}

double worn_in_sliding_coefficient(double half_angle) {
  if (half_angle == 0) return 1;
  if (half_angle > std::numbers::pi / 2) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const FrictionTriple area = sliding_friction_integrals(half_angle).area;
  const double s = std::sin(half_angle);
  return 2 * std::numbers::pi * s * s /
         (area.sliding + std::cos(half_angle) * area.force);
}

}  // namespace contact
