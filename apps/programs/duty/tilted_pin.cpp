#include "programs/duty/tilted_pin.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "cli/refuse.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/along_pin.hpp"
#include "programs/duty/tables.hpp"

namespace hinge_duty {
namespace {

using contact::AlongPin;
using contact::JointBody;

bool is_asked(const Options& options, const CycleFile& file) {
  return options.tilt.given() || !file.lie_column.empty();
}

double length_of(const JointDuty& duty) {
  return duty.joint.spec.geometry.length();
}

// The i-th of `count` places from end to end.
double place_of(double length, int i, int count) {
  return length * (static_cast<double>(i) / (count - 1) - 0.5);
}

}  // namespace

void check_lies(const Options& options, const CycleFile& file,
                const std::vector<cli::Joint>& joints) {
  const bool asked = options.tilt.given();
  const std::string flag =
      asked ? options.tilt.flag() : "the column " + file.lie_column;
  if (asked && !file.lie_column.empty()) {
    cli::refuse_beside(flag, "the column " + file.lie_column);
  }
  bool all_end = true;
  for (const cli::Joint& joint : joints) {
    if (is_asked(options, file) && !joint.is_pin()) {
      cli::refuse_without(flag, "kind = pin");
    }
    all_end = all_end && is_sliced(options, file, joint);
  }
  for (const auto& [option, name] : {std::pair("--along", &options.along),
                                     {"--along-map", &options.along_map}}) {
    if (name->empty() || all_end) continue;
    cli::refuse_without(option,
                        "--tilt, --load-at, columns of the cycle of a pin, "
                        "tilt_x_deg, tilt_y_deg or load_at_m, or a [relief]");
  }
}

contact::Lies lies_of(const Options& options, const CycleFile& file,
                      const cli::Joint& joint) {
  if (!is_asked(options, file)) return {};
  const contact::DutyCycle& cycle = file.cycle;
  if (!file.tilts.empty()) {
    return contact::tilted_at(cycle.times(), cycle.period(), file.tilts);
  }
  if (!file.places.empty()) {
    const double half = joint.spec.geometry.length() / 2;
    for (const double place : file.places) {
      if (std::abs(place) <= half) continue;
      cli::refuse("load_at_m =", fmt::format("{}", place),
                  fmt::format("{} to {} m, on the pin", -half, half));
    }
    return contact::loaded_at(cycle.times(), cycle.period(), file.places);
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
             ? contact::loaded_at(lies.place)
             : contact::tilted_with_load(lies.tilt.head<2>());
}

bool is_sliced(const Options& options, const CycleFile& file,
               const cli::Joint& joint) {
  if (is_asked(options, file)) return true;
  const auto is_exact = [](const std::vector<std::string>& laws) {
    return laws.empty() || (laws.size() == 1 && laws[0] == "exact");
  };
  const bool is_left_out =
      joint.spec.relief.kind() != contact::Relief::Kind::none &&
      !contact::FinitePin::refusal(joint.spec).empty();
  return !joint.spec.without_seat().is_endless() && !is_left_out &&
         is_exact(options.joint.laws) && is_exact(options.joint.pressures);
}

void write_along(const std::vector<JointDuty>& duties, cli::Output& output,
                 const cli::TableStyle& style) {
  constexpr int count = 101;
  write_rows(duties,
             {"z_m", "pv_max_W_per_m2", "at_time_s", "pv_mean_W_per_m2",
              "pv_integral_J_per_m"},
             output, style,
             [&](const JointDuty& duty, cli::RowWriter& to, const auto& begin) {
               const AlongPin pin(duty.cycle, duty.spec);
               for (int i = 0; i < count; ++i) {
                 const double z = place_of(length_of(duty), i, count);
                 const AlongPin::Place along = pin.at(z);
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
        const AlongPin pin(duty.cycle, duty.spec);
        for (const JointBody body : {JointBody::carrier, JointBody::body}) {
          const double k = duty.wear_coefficient(body).value_or(
              std::numeric_limits<double>::quiet_NaN());
          for (int i = 0; i < places; ++i) {
            const double z = place_of(length_of(duty), i, places);
            const auto pv = pin.pv_integrals(body, z, angles);
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
