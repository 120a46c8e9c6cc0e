#include "study/model/joint_ends.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/seat_cycle.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"

namespace study {
namespace {

using Eigen::Vector2d;

template <class T>
void add(std::span<const contact::Quantity<T>> quantities, const T& of,
         Result& to) {
  static const auto columns = columns_of(quantities);
  for (const auto& column : columns) {
    const double value = column(of);
    // The distance from a rim that is not there.
    if (!std::isinf(value)) to.numbers.emplace(column.name, value);
  }
}

// Numbers and warnings that every joint has.
void add(contact::JointSpec joint, const contact::LargestContact& largest,
         const Effort& effort, Result& to) {
  joint.relief = contact::Relief::none();  // not left out here
  const contact::JointContact contact = joint.without_seat().contact();
  const contact::ContactLimits limits = contact.limits();
  to.numbers.emplace(over_limit,
                     largest.peak_pressure / limits.peak_pressure());
  if (!effort.remarks) return;
  for (auto& notes : {contact.validity_notes(), limits.notes(largest)}) {
    std::ranges::copy(notes, std::back_inserter(to.warnings));
  }
}

// The load in the axes of the seat, which it swings in.
contact::DutyCycle swinging(const contact::JointSpec& joint, double swing,
                            const Turning& turning) {
  constexpr int count = 48;
  contact::DutyCycle::Rows rows;
  for (int i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / count;
    rows.times.push_back(time);
    rows.forces.push_back(turning.force_at(
        turning.beta + swing * std::sin(2 * std::numbers::pi * time)));
    rows.motion.push_back(turning.angular_velocity());
  }
  rows.period = 1;
  const bool body_has_seat =
      joint.geometry.inner_body() == contact::JointBody::carrier;
  return {rows,
          {.axes = body_has_seat ? contact::JointBody::body
                                 : contact::JointBody::carrier}};
}

}  // namespace

EndedLoad read_ended_load(const contact::TomlTable& load,
                          const contact::JointGeometry& geometry) {
  const bool is_pin = geometry.kind() == contact::JointKind::pin;
  EndedLoad ended;
  ended.in_seat = load.flag("in_seat");
  if (ended.in_seat && !geometry.seat()) {
    load.needs("in_seat", "a joint with a [seat]");
  }
  if (ended.in_seat && !is_about_z(*geometry.seat())) {
    load.needs("in_seat", "a seat about z, which beta is counted from");
  }
  if (load.has("swing") && !ended.in_seat) load.needs("swing", "in_seat");
  ended.swing =
      load.optional_number("swing", {0, std::numbers::pi / 2}).value_or(0);
  for (const char* key : {"tilt", "load_at"}) {
    if (load.has(key) && !is_pin) load.needs(key, "a pin");
  }
  if (load.has("tilt") && load.has("load_at")) {
    load.must_be("tilt", "left out beside load_at, which finds it");
  }
  if (load.has("twist") && !load.has("tilt")) load.needs("twist", "tilt");
  if (!load.has("tilt") && !load.has("load_at")) return ended;
  if (load.has("beta")) {
    load.must_be("beta",
                 "left out beside tilt and load_at: the reaction is "
                 "across the axis");
  }
  // A pin that bends or jams is another joint long before.
  const contact::Interval slope{-10 * contact::degree, 10 * contact::degree};
  ended.is_tilted = load.has("tilt");
  ended.tilt = load.optional_number("tilt", slope).value_or(0);
  ended.twist = load.optional_number("twist", slope).value_or(0);
  const double half = geometry.length() / 2;
  ended.load_at = load.optional_number("load_at", {-half, half});
  return ended;
}

Result run_in_seat(const contact::JointSpec& joint,
                   const contact::SeatJoint& seat, const EndedLoad& load,
                   const Turning& turning, const Effort& effort) {
  const contact::SeatJointSolution s =
      seat.solve({.reaction = turning.force(),
                  .angular_velocity = turning.angular_velocity()});
  if (s.contact.status != contact::SeatStatus::ok) {
    return {seat.notes(s).front(), {}};
  }
  Result result;
  if (effort.remarks) result.warnings = seat.notes(s);
  add(contact::seat_joint_quantities(), s, result);
  double peak = s.contact.peak_pressure;
  if (load.swing > 0) {
    const contact::SeatCycle cycle(swinging(joint, load.swing, turning), joint);
    for (const auto& row : cycle.rows()) {
      if (row.solution.contact.status == contact::SeatStatus::ok) continue;
      return {seat.notes(row.solution).front(), {}};
    }
    add(contact::seat_cycle_quantities(), cycle, result);
    const auto* highest = cycle.largest_peak();
    peak = highest ? highest->solution.contact.peak_pressure
                   : std::numeric_limits<double>::quiet_NaN();
    if (effort.remarks) result.warnings = cycle.notes();
  }
  add(joint, {0, peak}, effort, result);
  return result;
}

Result run_pin_that_ends(const contact::JointSpec& joint, const EndedLoad& load,
                         const Turning& turning, const Effort& effort) {
  const contact::FinitePin pin(joint);
  const Vector2d force(turning.reaction, 0);
  const contact::FinitePinSolution s =
      load.load_at ? pin.solve_at(force, *load.load_at, turning.rate)
                   : pin.solve(force, {load.tilt, load.twist}, turning.rate);
  if (s.contact.status != contact::Status::ok) {
    return {failure_of(s.contact.status), {}};
  }
  Result result;
  add(contact::finite_pin_quantities(), s, result);
  add(joint, s.contact.largest(), effort, result);
  return result;
}

}  // namespace study
