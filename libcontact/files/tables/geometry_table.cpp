#include "libcontact/files/tables/geometry_table.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

// Factor from a key's value to the radial clearance; 0 stands for the radius.
// Interference is given as positive numbers.
struct ClearanceKey {
  std::string_view key;
  double scale;
};
constexpr ClearanceKey clearance_keys[] = {{"radial_clearance", 1},
                                           {"diametral_clearance", 0.5},
                                           {"relative_clearance", 0},
                                           {"radial_interference", -1},
                                           {"diametral_interference", -0.5}};

double radius_from_table(const TomlTable& table) {
  table.refuse_both("diameter", "radius");
  const auto diameter = table.optional_number("diameter");
  if (diameter) return *diameter / 2;
  if (!table.has("radius")) table.needs("radius or diameter");
  return table.number("radius");
}

// The radial clearance by the only one of clearance_keys that is there.
double clearance_from_table(const TomlTable& table, double radius) {
  for (const auto& [key, factor] : clearance_keys) {
    const double scale = factor == 0 ? radius : factor;
    const double largest = radius / std::abs(scale);
    const auto value = table.optional_number(
        key, {scale > 0 ? -largest : 0, largest, true, true});
    if (!value) continue;
    for (const auto& [other, of_other] : clearance_keys) {
      if (other != key) table.refuse_both(other, key);
    }
    const double clearance = *value * scale;
    if (!(std::abs(clearance) < radius)) {
      table.fail(key, "the clearance rounds to the radius");
    }
    return clearance;
  }
  table.needs(
      "radial_clearance, diametral_clearance, relative_clearance, "
      "radial_interference, diametral_interference, or hole and shaft");
}

std::optional<Temperatures> temperatures_from_table(const TomlTable& joint) {
  const auto both = joint.optional_number("temperature");
  const auto inner = joint.optional_number("inner_temperature");
  const auto outer = joint.optional_number("outer_temperature");
  const auto reference = joint.optional_number("reference_temperature");
  const auto axial = joint.optional_choice("axial_growth");
  for (const char* key : {"inner_temperature", "outer_temperature"}) {
    joint.refuse_both("temperature", key);
  }
  if (!both && !inner && !outer) {
    for (const char* key : {"reference_temperature", "axial_growth"}) {
      if (joint.has(key)) joint.needs(key, "a temperature");
    }
    return {};
  }
  if (!both && !outer) joint.needs("inner_temperature", "outer_temperature");
  if (!both && !inner) joint.needs("outer_temperature", "inner_temperature");
  Temperatures result{both ? *both : *inner, both ? *both : *outer};
  result.reference = reference.value_or(result.reference);
  result.axial = static_cast<AxialGrowth>(axial.value_or(0));
  return result;
}

// By a ring's width, a cup's opening, or polar angles.
SeatZone angles_from_table(const TomlTable& seat, double radius) {
  for (const auto& [key, other] : {std::pair{"ring_width", "cup"},
                                   {"ring_width", "lower_rim"},
                                   {"ring_width", "upper_rim"},
                                   {"cup", "lower_rim"},
                                   {"cup", "upper_rim"}}) {
    seat.refuse_both(key, other);
  }
  const auto made = [&](const char* key, const auto& make) {
    try {
      return make();
    } catch (const Error& error) {
      seat.fail(key, error.what());
    }
  };
  using detail::pi;
  if (seat.has("ring_width")) {
    const double width = seat.number("ring_width", {0, 2 * radius, true, true});
    return made("ring_width", [&] { return SeatZone::ring(width, radius); });
  }
  if (seat.has("cup")) {
    const double half_angle = seat.number("cup");
    return made("cup", [&] { return SeatZone::cup(half_angle); });
  }
  if (!seat.has("lower_rim") && !seat.has("upper_rim")) {
    seat.needs("ring_width, cup, or lower_rim and upper_rim");
  }
  const double from = seat.number("lower_rim");
  const double to = seat.number("upper_rim", {from, pi, true});
  return made("upper_rim", [&] { return SeatZone(from, to); });
}

SeatEdge edge_from_table(const TomlTable& seat, double radius) {
  SeatEdge edge;
  edge.radius = seat.optional_number("edge_radius", {0, radius, false, true})
                    .value_or(edge.radius);
  if (seat.has("edge_angle")) edge.angle = seat.number("edge_angle");
  edge.report_distance =
      seat.optional_number("report_distance").value_or(edge.report_distance);
  const auto face = [&](const char* key) {
    return static_cast<SideFace>(seat.optional_choice(key).value_or(0));
  };
  edge.side_face = face("side_face");
  edge.housing = face("housing");
  if (edge.side_face == SideFace::free) {
    seat.refuse_both("side_face", "rim_setback");
    seat.refuse_both("side_face", "edge_radius");
  }
  return edge;
}

// [seat]
SeatZone zone_from_table(const TomlTable& seat, double radius) {
  SeatZone zone =
      angles_from_table(seat, radius).with_edge(edge_from_table(seat, radius));
  if (seat.has("rim_setback")) {
    try {
      zone = zone.moved_in(seat.number("rim_setback"));
    } catch (const Error& error) {
      seat.fail("rim_setback", error.what());
    }
  }
  if (!seat.has("axis")) return zone;
  const auto axis = seat.numbers("axis", {3});
  if (std::hypot(axis[0], axis[1], axis[2]) == 0) {
    seat.must_be("axis", "a vector that is not 0");
  }
  return zone.about({axis[0], axis[1], axis[2]});
}

// The one of a range of clearances that the joint has.
Fit::Clearance taken_from_table(const TomlTable& table) {
  const auto taken = table.optional_choice("clearance");
  return taken ? static_cast<Fit::Clearance>(*taken) : Fit::Clearance::mean;
}

}  // namespace

std::optional<Fit> fit_from_table(const TomlTable& table) {
  for (const auto& [key, other] : {std::pair{"hole", "shaft"},
                                   {"shaft", "hole"},
                                   {"clearance", "hole"},
                                   {"hole", "diameter"}}) {
    if (table.has(key) && !table.has(other) && !table.has("designation")) {
      table.needs(key, key == std::string_view("clearance")
                           ? "hole, of a fit; its size is radial_clearance or "
                             "diametral_clearance"
                           : other);
    }
  }
  if (!table.has("hole")) return {};
  for (const auto& [key, scale] : clearance_keys) {
    table.refuse_both("hole", key);
  }
  const std::string hole = table.text("hole");
  if (!Fit::holes.contains(hole)) table.must_be("hole", Fit::holes.rule);
  const std::string shaft = table.text("shaft");
  if (!Fit::shafts.contains(shaft)) table.must_be("shaft", Fit::shafts.rule);
  const double diameter = table.number("diameter");
  if (!Fit::has_size(shaft, diameter)) {
    table.must_be("diameter",
                  detail::message("3 to {:g} mm with shaft {}",
                                  Fit::largest_size(shaft) * 1e3, shaft));
  }
  return Fit(hole, shaft, diameter, taken_from_table(table));
}

JointSpec at_temperatures(const TomlTable& table, const JointSpec& joint) {
  const auto temperatures = temperatures_from_table(table);
  if (!temperatures) return joint;
  if (table.has("axial_growth") && joint.geometry.kind() == JointKind::ball) {
    table.needs("axial_growth", "kind = \"pin\"");
  }
  const char* const key =
      table.has("temperature") ? "temperature" : "inner_temperature";
  try {
    return joint.at(*temperatures);
  } catch (const Error& error) {
    table.fail(key, error.what());
  }
}

std::optional<SphericalBearing> bearing_from_table(const TomlTable& table) {
  if (!table.has("designation")) {
    if (table.has("clearance_group")) {
      table.needs("clearance_group", "designation");
    }
    return {};
  }
  for (const auto& [key, scale] : clearance_keys) {
    table.refuse_both("designation", key);
  }
  for (const char* key : {"radius", "diameter", "hole"}) {
    table.refuse_both("designation", key);
  }
  const std::string designation = table.text("designation");
  const auto group = table.optional_choice("clearance_group").value_or(1);
  const Fit::Clearance taken = taken_from_table(table);
  try {
    return SphericalBearing(designation, static_cast<ClearanceGroup>(group),
                            taken);
  } catch (const Error& error) {
    table.fail("designation", error.what());
  }
}

JointGeometry geometry_from_table(
    const TomlTable& joint, const TomlTable& table,
    const std::optional<Fit>& fit,
    const std::optional<SphericalBearing>& bearing) {
  const bool ball = joint.choice("kind") == 0;
  const JointBody inner_body =
      joint.optional_choice("inner_body").value_or(0) == 0 ? JointBody::carrier
                                                           : JointBody::body;
  if (bearing && !ball) table.needs("designation", "kind = \"ball\"");
  const double nominal = bearing ? bearing->radius() : radius_from_table(table);
  const double radius = fit ? fit->radius() : nominal;
  const double clearance = bearing ? bearing->radial_clearance()
                           : fit   ? fit->radial_clearance()
                                   : clearance_from_table(table, radius);
  const auto seat = joint.optional_table("seat");
  if (ball) {
    const auto whole = JointGeometry::ball(radius, clearance, inner_body);
    if (bearing && (!seat || seat->has("left_out"))) {
      return whole.with_seat(SeatZone::ring(bearing->ring_width(), radius));
    }
    return seat ? whole.with_seat(zone_from_table(*seat, radius)) : whole;
  }
  if (seat) joint.needs("seat", "kind = \"ball\"");
  const double length = table.number("length");
  return JointGeometry::pin(radius, clearance, length, inner_body);
}

Relief relief_from_table(const TomlTable& file, const JointGeometry& geometry) {
  const auto table = file.optional_table("relief");
  if (!table) return Relief::none();
  if (geometry.kind() != JointKind::pin) {
    file.needs("relief", "kind = \"pin\"");
  }
  const bool barrel = table->choice("kind") == 0;
  const double depth = table->number("depth");
  if (!barrel) {
    const double half = geometry.length() / 2;
    return Relief::ends(depth,
                        table->number("relieved_length", {0, half, true}));
  }
  if (table->has("relieved_length")) {
    table->needs("relieved_length", "kind = \"ends\"");
  }
  return Relief::barrel(depth);
}

KnownKeys geometry_keys() {
  using detail::pi;
  const auto length = [](std::string_view key) {
    return number_key(key, Dimension::length, Interval::positive());
  };
  const auto angle = [](std::string_view key, const Interval& range) {
    return number_key(key, Dimension::angle, range);
  };
  const auto temperature = [](std::string_view key) {
    return number_key(key, Dimension::temperature,
                      {Temperatures::coldest, Temperatures::hottest});
  };
  return {temperature("temperature"),
          temperature("inner_temperature"),
          temperature("outer_temperature"),
          temperature("reference_temperature"),
          word_key("axial_growth", {"free", "held"}),
          word_key("plane_state", {"strain", "stress"}),
          table_key("geometry",
                    {length("radius"),
                     length("diameter"),
                     {"radial_clearance", Dimension::length},
                     {"diametral_clearance", Dimension::length},
                     number_key("relative_clearance", {-1, 1, true, true}),
                     length("radial_interference"),
                     length("diametral_interference"),
                     {"hole"},
                     {"shaft"},
                     word_key("clearance", {"minimum", "mean", "maximum"}),
                     {"designation"},
                     word_key("clearance_group", {"C2", "CN", "C3"}),
                     length("length")}),
          table_key("seat", {{"left_out"},
                             length("ring_width"),
                             angle("cup", {0, pi, true}),
                             angle("lower_rim", {0, pi, false, true}),
                             angle("upper_rim", {0, pi, true}),
                             angle("rim_setback", {0, pi}),
                             number_key("edge_radius", Dimension::length,
                                        Interval::non_negative()),
                             angle("edge_angle", {0, pi, true, true}),
                             word_key("side_face", {"goes_on", "free"}),
                             word_key("housing", {"goes_on", "free"}),
                             angle("report_distance", {0, 1, true, true}),
                             {"axis"}}),
          table_key("relief", {word_key("kind", {"barrel", "ends"}),
                               length("depth"), length("relieved_length")})};
}

}  // namespace contact
