#include "separation/case/stop_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "libcontact/base/units.hpp"
#include "libcontact/play/hunt_crossley.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"
#include "separation/case/system_of.hpp"

namespace separation {
namespace {

using contact::degree;

// Requires an angle between named directions, or about an axis.
void check_hinge(const TomlTable& table, const TomlTable& of,
                 const Hinge& hinge, const HingeStop& stop) {
  if (hinge.kind == multibody::HingeKind::axis) return;
  if (!of.has("body_direction")) {
    table.needs("directions of the ball hinge: body_direction and " +
                parent_key(of, "direction"));
  }
  check_angles(table, hinge, stop.angle, stop.angle, "a ball hinge");
  // There the directions lie on one line, which a rigid stop turns about no
  // axis in particular.
  const bool has_axis = 0 < stop.angle && stop.angle < std::numbers::pi;
  if (stop.is_rigid() && !has_axis) {
    table.must_be("angle",
                  "between 0 deg and 180 deg where a ball hinge has a rigid "
                  "stop: at these angles the directions have no common normal");
  }
}

// @param near  within which the body starts at its stop, rad
void read_side(const TomlTable& table, double start, double near,
               HingeStop& stop) {
  const auto from = table.optional_choice("from");
  if (!from && std::abs(start - stop.angle) <= near) {
    table.needs("angle", "from: the body starts there");
  }
  const bool below = from ? *from == 0 : start < stop.angle;
  stop.side = below ? -1 : 1;
  if (stop.gap(start) < -near) {
    table.must_be("angle",
                  fmt::format("{:.6g} deg or {}, so that the body "
                              "does not start beyond it",
                              start / degree, below ? "more" : "less"));
  }
}

HingeStop read_stop(const TomlTable& table) {
  HingeStop stop;
  stop.angle = table.number("angle");
  stop.stiffness = table.optional_number("stiffness_N_m_per_rad").value_or(0);
  stop.restitution =
      table.number("restitution", {0, 1, !stop.is_rigid(), false});
  if (!stop.is_rigid()) {
    stop.damping =
        contact::HuntCrossley::from_restitution(stop.restitution, 1).damping();
  }
  return stop;
}

// Uncertainty factors of standards. "Others (Harness)" of the first stands for
// all resisting moments but friction, since it is the largest: a resisting
// spring has 1.2 there. Friction and harness are variable moments of the
// second.
// - ECSS-E-ST-33-01C (2009), table 4-2 and 4.7.5.3.2e.
// - NASA-STD-5017B (2022), table 1; its margin is the ratio minus 1.
struct MarginStandard {
  const char* name;
  double friction, other, spring, required;
  std::string_view title;
};
constexpr std::string_view ecss = "ECSS-E-ST-33-01C", nasa = "NASA-STD-5017B";
constexpr MarginStandard standards[] = {
    {"ecss_theoretical", 3, 3, 0.8, 2, ecss},
    {"ecss_measured", 1.5, 1.5, 0.8, 2, ecss},
    {"nasa_analysis", 3, 3, 1, 1, nasa},
    {"nasa_development", 2.5, 2.5, 1, 1, nasa},
    {"nasa_acceptance", 2, 2, 1, 1, nasa},
};

std::vector<std::string> standard_names() {
  std::vector<std::string> names;
  for (const MarginStandard& standard : standards) {
    names.emplace_back(standard.name);
  }
  return names;
}

}  // namespace

contact::KnownKeys stop_keys() {
  return {contact::number_key("angle", contact::Dimension::angle, most_turns),
          contact::word_key("from", {"below", "above"}),
          contact::number_key("restitution", {0, 1}),
          contact::number_key("stiffness_N_m_per_rad", Interval::positive())};
}

std::vector<HingeStop> read_stops(const TomlTable& table, const Hinge& hinge,
                                  const multibody::BodyStart& start) {
  const bool is_axis = hinge.kind == multibody::HingeKind::axis;
  const double begin =
      is_axis ? start.angle : hinge_angle(hinge, start.rotation);
  std::vector<HingeStop> stops;
  for (const TomlTable& of : table.tables("stop")) {
    HingeStop stop = read_stop(of);
    check_hinge(of, table, hinge, stop);
    read_side(of, begin, is_axis ? 0 : multibody::cone_rounding, stop);
    for (const HingeStop& other : stops) {
      if (other.side == stop.side) {
        of.must_be("angle",
                   fmt::format("on the other side of the start, {:.6g} "
                               "deg, than the other stop",
                               begin / degree));
      }
      if (!(other.gap(stop.angle) > 0)) {
        of.must_be("angle", fmt::format("{} that of the other stop, {:.6g} deg",
                                        stop.side < 0 ? "above" : "below",
                                        other.angle / degree));
      }
    }
    stops.push_back(stop);
  }
  return stops;
}

contact::KnownKeys margin_keys() {
  return {{"from", contact::Dimension::angle},
          {"to", contact::Dimension::angle},
          contact::word_key("standard", standard_names()),
          contact::number_key("friction_factor", {1, 100}),
          contact::number_key("other_factor", {1, 100}),
          contact::number_key("spring_factor", {0, 1, true, false})};
}

std::optional<MarginPath> read_margin(const TomlTable& table,
                                      const Hinge& hinge,
                                      const multibody::BodyStart& start) {
  const auto of = table.optional_table("torque_margin");
  if (!of) return {};
  if (hinge.kind != multibody::HingeKind::axis) {
    table.needs("torque_margin", "kind = \"axis\"");
  }
  MarginPath path{of->optional_number("from").value_or(start.angle),
                  of->number("to")};
  if (path.to == path.from) of->must_be("to", "another angle than from");
  const auto standard = of->optional_choice("standard");
  const MarginStandard by =
      standard ? standards[*standard] : MarginStandard{"", 1, 1, 1, 0, ""};
  const auto factor = [&of](std::string_view key, double otherwise) {
    return of->optional_number(key).value_or(otherwise);
  };
  path.friction_factor = factor("friction_factor", by.friction);
  path.other_factor = factor("other_factor", by.other);
  path.spring_factor = factor("spring_factor", by.spring);
  path.required = by.required;
  path.standard = by.title;
  return path;
}

}  // namespace separation
