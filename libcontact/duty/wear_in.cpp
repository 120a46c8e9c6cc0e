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
#include "libcontact/duty/steps/stepped_wear_in.hpp"
#include "libcontact/duty/wear_check.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact {
namespace {

// Round a pin whose hole has lost this volume.
double mean_clearance(const JointGeometry& geometry, double volume) {
  if (geometry.kind() == JointKind::ball) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return geometry.radial_clearance() +
         volume /
             (2 * std::numbers::pi * geometry.radius() * geometry.length());
}

// Pressure of a cycle in means with the weight of p v.
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

// Penetration of overlapping shapes: eps (1/cos theta0 - 1).
double depth_of_overlap(const JointGeometry& geometry, double overlap) {
  const double theta0 =
      WornHalfAngle::half_angle_of_overlap(geometry.kind(), overlap);
  return geometry.radial_clearance() * (1 / std::cos(theta0) - 1);
}

// The state after the next block, without what a cycle does then.
WearIn::State next_state(const WearIn::State& now, const Wearing& wearing,
                         double wear_per_pv, double cycles, double unit) {
  constexpr double largest_growth = 0.1;
  const double growth = wear_per_pv * wearing.pv / unit;  // v's, per cycle
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

// Whether the load moves so far in the seat that the volume of the wear does
// not tell the contact. Of swinging loads the error is like the square of this
// share, and 0.1 deg here; the hip of docs/how-to/duty.md, with 0.07, is 0.7
// deg off.
bool moves(const JointCycle& cycle) {
  constexpr double share = 0.05;
  return cycle.contact_spread() > share * wearing_of(cycle).half_angle;
}

// Note on the laws that steps do not use, or "".
std::string laws_note(const JointContact& contact) {
  const std::string half_angle = contact.half_angle_law().name();
  const std::string pressure = contact.pressure_law().name();
  if (half_angle == "exact" && pressure == "exact") return {};
  return detail::message(
      "the contact is worn step by step and solved by elasticity alone: the "
      "laws {} and {} are used for the unworn joint only",
      half_angle, pressure);
}

// Note on a loading that steps do not have, or "".
std::string loading_note(const JointContact& contact) {
  const auto& made_for = contact.half_angle_law().made_for();
  if (!made_for || !made_for->loading().is_back()) return {};
  return detail::message(
      "the contact is worn step by step under a force at the centre: loading "
      "{} is used for the unworn joint only",
      to_string(made_for->loading()));
}

// By the volume alone, of loads that stand still.
WearIn overlap_wear_in(const JointCycle& fresh, double coefficient,
                       double cycles,
                       const std::function<void(double)>& progress) {
  detail::check_wear(fresh);
  const JointContact& contact = fresh.contact();
  const JointGeometry& geometry = contact.geometry();
  WearIn result;
  WearIn::State next;
  for (;;) {
    detail::check_depth(depth_of_overlap(geometry, next.wear_number),
                        next.cycles, geometry);
    WearIn::State& now = result.states.emplace_back(next);
    progress(now.cycles);
    const JointCycle worn(fresh.cycle(), Joint(contact.worn(now.wear_number)));
    const Wearing wearing = wearing_of(worn);
    add_cycle(worn, now);
    now.worn_share = RunningInPressure::worn_share(
        now.wear_number, wearing.overlap - now.wear_number);
    now.penetration = depth_of_overlap(geometry, wearing.overlap);
    now.clearance = mean_clearance(geometry, now.volume);
    if (now.cycles >= cycles) return result;
    next = next_state(now, wearing, coefficient, cycles,
                      WornHalfAngle::unit_volume(geometry));
  }
}

}  // namespace

WearIn wear_in(const DutyCycle& cycle, const JointContact& contact,
               const WearCoefficients& k, double cycles, const WornSeat* before,
               const std::function<void(double)>& progress) {
  for (const double each : {k.seat, k.inner}) {
    detail::require(detail::is_not_negative(each), "wear", "coefficient", each,
                    "0 m^2/N or above and finite");
  }
  detail::require(detail::is_not_negative(cycles), "wear", "cycles", cycles,
                  "0 or above and finite");
  const JointGeometry& geometry = contact.geometry();
  const JointCycle fresh(cycle, Joint(contact));
  const bool is_pressed = geometry.radial_clearance() <= 0;
  const bool has_steps = is_pressed || before != nullptr || moves(fresh);
  std::vector<std::string> notes;
  const auto note = [&](std::string text) {
    if (!text.empty()) notes.push_back(std::move(text));
  };
  note(WearMap::coefficient_note(k.seat));
  note(WearMap::coefficient_note(k.inner));
  if (k.inner > 0 && !is_pressed) {
    note("wear of the ball or pin does not change the contact");
  }
  if (has_steps) {
    note(laws_note(contact));
    note(loading_note(contact));
  }
  const auto tell = [&](double done) {
    if (progress) progress(done);
  };
  WearIn result = has_steps
                      ? detail::stepped_wear_in(
                            fresh, {k.seat, is_pressed ? k.inner : 0}, cycles,
                            before != nullptr ? *before : WornSeat(), tell)
                      : overlap_wear_in(fresh, k.seat, cycles, tell);
  note(WearMap::depth_note(result.states.back().penetration, geometry));
  if (is_pressed && result.states.front().half_angle == std::numbers::pi) {
    note("the contact is closed all round at first: debris cannot leave");
  }
  result.notes = std::move(notes);
  return result;
}

}  // namespace contact
