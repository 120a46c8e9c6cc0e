#include "programs/duty/tilted_pin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "cli/joint/joint_reports.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "programs/duty/tables.hpp"

namespace hinge_duty {
namespace {

using contact::JointBody;
using contact::PinCycle;

// The lies of a joint's pin, by the options or the columns.
PinCycle::Lies lies_of(const Options& options, const CycleFile& file,
                       const cli::Joint& joint) {
  const contact::DutyCycle& cycle = file.cycle;
  if (!file.tilts.empty()) {
    return PinCycle::tilted(cycle.times(), cycle.period(), file.tilts);
  }
  if (!file.places.empty()) {
    const double half = joint.spec.geometry.length() / 2;
    for (const double place : file.places) {
      if (std::abs(place) <= half) continue;
      cli::refuse("load_at_m =", fmt::format("{}", place),
                  fmt::format("{} to {} m, on the pin", -half, half));
    }
    return PinCycle::loaded(cycle.times(), cycle.period(), file.places);
  }
  const cli::Placements placements(options.tilt, joint);
  if (placements.size() != 1) {
    cli::refuse(
        options.tilt.flag(),
        options.tilt.is_placed() ? options.tilt.load_at : options.tilt.tilt,
        "one value");
  }
  const contact::Placement lies = placements[0];
  return options.tilt.is_placed()
             ? PinCycle::loaded_at(lies.place)
             : PinCycle::tilted_with_load(lies.tilt.head<2>());
}

void check_pin_files(const Options& options) {
  for (const auto& [option, file] :
       {std::pair("--pin-states", &options.pin_states),
        {"--along", &options.along},
        {"--along-map", &options.along_map}}) {
    if (file->empty()) continue;
    cli::refuse_without(option,
                        "--tilt, --load-at, or columns of the cycle of a pin: "
                        "tilt_x_deg, tilt_y_deg or load_at_m");
  }
}

double length_of(const JointDuty& duty) {
  return duty.joint.spec.geometry.length();
}

// The i-th of `count` places from end to end.
double place_of(double length, int i, int count) {
  return length * (static_cast<double>(i) / (count - 1) - 0.5);
}

}  // namespace

void add_pins(const Options& options, const CycleFile& file,
              std::vector<JointDuty>& duties) {
  const bool asked = options.tilt.given();
  if (!asked && file.lie_column.empty()) {
    check_pin_files(options);
    return;
  }
  const std::string flag =
      asked ? options.tilt.flag() : "the column " + file.lie_column;
  if (asked && !file.lie_column.empty()) {
    cli::refuse_beside(flag, "the column " + file.lie_column);
  }
  for (JointDuty& duty : duties) {
    if (!duty.joint.is_pin()) cli::refuse_without(flag, "kind = pin");
    cli::Joint joint = duty.joint;
    joint.spec.friction = duty.cycle.contact().friction();
    const PinCycle::Lies lies = lies_of(options, file, joint);
    duty.pin.emplace(
        made_of(joint, [&] { return PinCycle(file.cycle, joint.spec, lies); }));
  }
}

void add_pin(const PinCycle& pin, cli::Report& to) {
  using Instant = PinCycle::Instant;
  using contact::FinitePinState;
  const struct {
    std::string_view key;
    Instant at;
    double FinitePinState::*place;
  } largest[] = {{"largest_pv", pin.largest_pv(), &FinitePinState::peak_place},
                 {"largest_peak_pressure", pin.largest_peak(),
                  &FinitePinState::peak_place},
                 {"largest_half_angle", pin.largest_half_angle(),
                  &FinitePinState::half_angle_place}};
  for (const auto& column : columns_of(contact::pin_cycle_quantities())) {
    const auto* const found = std::ranges::find(
        largest, column.quantity->key, [](const auto& l) { return l.key; });
    if (found == std::end(largest)) {
      to.add(column.name, column(pin), column.meaning);
    } else {
      const Instant& at = found->at;
      to.add(column.name, column(pin),
             std::string(column.meaning) + "; z in m from its middle",
             {at.time, {}, {}, at.solution.contact.*found->place});
    }
  }
}

void write_pin_states(const std::vector<JointDuty>& duties, cli::Output& output,
                      const cli::TableStyle& style) {
  const auto columns = columns_of(contact::finite_pin_quantities());
  std::vector<std::string> names = {"time_s", "R_x_N", "R_y_N"};
  for (const auto& column : columns) names.push_back(column.name);
  names.emplace_back("pv_max_W_per_m2");
  write_rows(duties, names, output, style,
             [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
               for (const PinCycle::Instant& i : duty.pin->rows()) {
                 begin();
                 to.number(i.time);
                 to.number(i.state.reaction.x());
                 to.number(i.state.reaction.y());
                 for (const auto& column : columns) {
                   to.number(column(i.solution) + 0.0);  // no -0
                 }
                 to.number(i.largest_pv());
                 to.end();
               }
             });
}

void write_along(const std::vector<JointDuty>& duties, cli::Output& output,
                 const cli::TableStyle& style) {
  constexpr int count = 101;
  write_rows(duties,
             {"z_m", "pv_max_W_per_m2", "at_time_s", "pv_mean_W_per_m2",
              "pv_integral_J_per_m"},
             output, style,
             [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
               for (int i = 0; i < count; ++i) {
                 const double z = place_of(length_of(duty), i, count);
                 const PinCycle::Along along = duty.pin->along(z);
                 begin();
                 to.number(z);
                 to.number(along.largest_pv);
                 to.number(along.time);
                 to.number(along.mean_pv);
                 to.number(along.pv_per_length);
                 to.end();
               }
             });
}

void write_along_map(const std::vector<JointDuty>& duties, cli::Output& output,
                     const cli::TableStyle& style) {
  constexpr int places = 41;
  constexpr int angles = 180;
  write_rows(
      duties, {"body", "z_m", "beta_deg", "pv_integral_Pa_m", "depth_mm"},
      output, style,
      [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
        for (const JointBody body : {JointBody::carrier, JointBody::body}) {
          const double k = duty.wear_coefficient(body).value_or(
              std::numeric_limits<double>::quiet_NaN());
          for (int i = 0; i < places; ++i) {
            const double z = place_of(length_of(duty), i, places);
            const auto pv = duty.pin->pv_integrals(body, z, angles);
            for (int j = 0; j < angles; ++j) {
              if (pv[j] == 0) continue;
              begin();
              to.text(body == JointBody::carrier ? "carrier" : "body");
              to.number(z);
              to.number(360.0 * j / angles - 180);
              to.number(pv[j]);
              to.number(k * 1e-6 * pv[j]);
              to.end();
            }
          }
        }
      });
}

}  // namespace hinge_duty
