#include "libcontact/duty/wear_in.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/pressed_wear_in.hpp"
#include "libcontact/duty/wear_check.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact {
namespace {

double unit_volume(const JointGeometry& geometry) {
  const double size = geometry.radius() * geometry.radial_clearance();
  return geometry.kind() == JointKind::ball
             ? std::numbers::pi * geometry.radius() * size
             : 2 * geometry.length() * size;
}

// Round a pin whose hole has lost this volume.
double mean_clearance(const JointGeometry& geometry, double volume) {
  if (geometry.kind() == JointKind::ball) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return geometry.radial_clearance() +
         volume /
             (2 * std::numbers::pi * geometry.radius() * geometry.length());
}

// What the pressure of a cycle does, with the weight of p v.
struct Wearing {
  double pv = 0;          // integral over contact and time, J
  double overlap = 0;     // mean g(theta0)
  double half_angle = 0;  // mean theta0
};

Wearing wearing_of(const JointCycle& cycle) {
  Wearing sums;
  const JointKind kind = cycle.contact().geometry().kind();
  for (const JointCycle::Instant& i : cycle.gauss_points()) {
    const double pv = i.weight * cycle.sliding(i).pv_total();
    const double theta0 = i.solution.half_angle;
    sums.pv += pv;
    sums.overlap += pv * WornHalfAngle::overlap(kind, theta0);
    sums.half_angle += pv * theta0;
  }
  if (sums.pv > 0) {
    sums.overlap /= sums.pv;
    sums.half_angle /= sums.pv;
  }
  return sums;
}

void add_cycle(const JointCycle& cycle, WearIn::State& state) {
  for (const JointCycle::Instant& i : cycle.rows()) {
    state.half_angle = std::max(state.half_angle, i.solution.half_angle);
    state.peak_pressure =
        std::max(state.peak_pressure, i.solution.peak_pressure);
    state.pv = std::max(state.pv, cycle.sliding(i).largest_pv().value);
  }
  for (const JointCycle::Instant& i : cycle.gauss_points()) {
    state.energy -= i.weight * i.solution.power;
    state.mean_moment +=
        i.weight * i.solution.friction_moment.norm() / cycle.cycle().period();
  }
}

// Of overlapping shapes: eps (1/cos theta0 - 1).
double depth_of_overlap(const JointGeometry& geometry, double overlap) {
  const double theta0 =
      WornHalfAngle::half_angle_of_overlap(geometry.kind(), overlap);
  return geometry.radial_clearance() * (1 / std::cos(theta0) - 1);
}

// The note on a load that moves, or "".
std::string check_spread(const JointCycle& cycle) {
  constexpr double noted = 0.3;
  const double spread = cycle.contact_spread();
  const double half_angle = wearing_of(cycle).half_angle;
  const std::string what = detail::message(
      "the spread of the contact over the seat, {:.4g} deg,", spread / degree);
  if (spread > half_angle) {
    throw Error(detail::must_be(
        what, detail::message("at most {:.4g} deg, the half-angle: cycles of "
                              "wear take the load to stand still in the seat",
                              half_angle / degree)));
  }
  if (spread <= noted * half_angle) return {};
  return detail::message(
      "{} is {:.2g} of its half-angle: taken as standing still, the worn "
      "contact is too wide and its peak pressure too low",
      what, spread / half_angle);
}

void check_depth(const WearIn::State& state, const JointGeometry& geometry) {
  const double largest = geometry.radius();
  // False of NaN too, for wear beyond all numbers.
  if (depth_of_overlap(geometry, state.wear_number) <= largest) return;
  throw Error(detail::must_be(
      detail::message("the depth of the wear after {:.4g} cycles",
                      state.cycles),
      detail::message("at most {:.4g} mm, the radius", 1e3 * largest)));
}

// The state after the next block, without what a cycle does then.
WearIn::State next_state(const WearIn::State& now, const Wearing& wearing,
                         double wear_per_pv, double cycles, double unit) {
  constexpr double largest_growth = 0.1;
  const double growth = wear_per_pv * wearing.pv / unit;  // of v in a cycle
  // At least a cycle: what wears so fast is no bearing.
  const double block =
      std::min(cycles - now.cycles,
               std::max(largest_growth * wearing.overlap / growth, 1.0));
  WearIn::State next;
  next.cycles = now.cycles + block;
  next.volume = now.volume + block * wear_per_pv * wearing.pv;
  next.wear_number = next.volume / unit;
  return next;
}

}  // namespace

WearIn wear_in(const DutyCycle& cycle, const JointContact& contact,
               const WearCoefficients& k, double cycles) {
  const double coefficient = k.seat;
  for (const double each : {k.seat, k.inner}) {
    detail::require(each >= 0 && std::isfinite(each), "wear", "coefficient",
                    each, "0 m^2/N or above and finite");
  }
  detail::require(cycles >= 0 && std::isfinite(cycles), "wear", "cycles",
                  cycles, "0 or above and finite");
  const JointGeometry& geometry = contact.geometry();
  const Joint unworn(contact);
  const JointCycle fresh(cycle, unworn);
  const bool is_pressed = geometry.radial_clearance() <= 0;
  if (!is_pressed) detail::check_wear(fresh);
  WearIn result;
  const auto note = [&](std::string text) {
    if (!text.empty()) result.notes.push_back(std::move(text));
  };
  note(WearMap::coefficient_note(coefficient));
  note(WearMap::coefficient_note(k.inner));
  note(check_spread(fresh));
  if (is_pressed) {
    result.states = detail::pressed_wear_in(fresh, k, cycles);
    note(WearMap::depth_note(result.states.back().penetration, geometry));
    if (result.states.front().half_angle == std::numbers::pi) {
      result.notes.emplace_back(
          "the contact is closed all round at first: debris cannot leave");
    }
    return result;
  }
  if (k.inner > 0) {
    result.notes.emplace_back(
        "wear of the ball or pin does not change the contact");
  }
  WearIn::State next;
  for (;;) {
    check_depth(next, geometry);
    WearIn::State& now = result.states.emplace_back(next);
    const Joint joint(contact.worn(now.wear_number));
    const JointCycle worn(cycle, joint);
    const Wearing wearing = wearing_of(worn);
    add_cycle(worn, now);
    now.worn_share = RunningInPressure::worn_share(
        now.wear_number, wearing.overlap - now.wear_number);
    now.penetration = depth_of_overlap(geometry, wearing.overlap);
    now.clearance = mean_clearance(geometry, now.volume);
    if (now.cycles >= cycles) break;
    next = next_state(now, wearing, coefficient, cycles, unit_volume(geometry));
  }
  note(WearMap::depth_note(result.states.back().penetration, geometry));
  return result;
}

}  // namespace contact
