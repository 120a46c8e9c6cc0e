#include "libcontact/files/joint_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/material_table.hpp"
#include "libcontact/files/wall_tables.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pair/stress_registry.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

// 180/pi is 57.2958; the paper rounds it to 57.3.
constexpr Interval degrees_per_radian_range{57, 58};

ElasticPair pair_from_table(const TomlTable& table) {
  const Material inner = material_from_table(table.table("inner"));
  const TomlTable outer_table = table.table("outer");
  const Material outer = material_from_table(outer_table);
  if (std::isinf(inner.youngs_modulus) && std::isinf(outer.youngs_modulus)) {
    outer_table.must_be("youngs_modulus", "finite: the inner body is rigid");
  }
  return ElasticPair(inner, outer);
}

FrictionStress curve_from_table(const TomlTable& friction,
                                const detail::StressEntry& entry) {
  const ArrayShape two_or_more{.rows = 2, .or_more = true};
  FrictionStress::Table table;
  table.points =
      friction.numbers(entry.points, two_or_more, Interval::positive());
  table.coefficients =
      friction.numbers("coefficients", two_or_more, Interval::non_negative());
  if (friction.optional_choice("curve", {"spline", "linear"}).value_or(0)) {
    table.curve = FrictionStress::Table::Curve::linear;
  }
  try {
    return entry.make({}, table);
  } catch (const Error& error) {
    friction.fail("coefficients", error.what());
  }
}

// A stress of pressure and speed, by the name of its law.
FrictionStress stress_from_table(const TomlTable& friction) {
  std::vector<std::string> names;
  for (const detail::StressEntry* entry : detail::stress_entries()) {
    names.emplace_back(entry->name);
  }
  const detail::StressEntry& entry =
      *detail::stress_entries()[friction.choice("law", names)];
  if (entry.is_table()) return curve_from_table(friction, entry);
  std::vector<double> numbers;
  for (const auto& [key, unit, is_above_zero, largest] : entry.numbers) {
    numbers.push_back(friction.number(
        key, {0, std::min(largest, Interval::largest), is_above_zero}));
  }
  return entry.make(numbers, {});
}

// Viscous friction has either of its two numbers, dry friction a coefficient.
std::optional<FrictionModel> friction_from_table(const TomlTable& table) {
  const auto friction = table.optional_table("friction");
  if (!friction) return {};
  if (friction->has("law")) return stress_from_table(*friction);
  const Interval range = Interval::non_negative();
  const auto constant = friction->optional_number("viscous_constant", range);
  const auto slope = friction->optional_number("viscous_pressure_slope", range);
  const auto adhesion = friction->optional_number("adhesion", range);
  if (!constant && !slope) {
    return FrictionLaw(friction->number("coefficient", range),
                       adhesion.value_or(0));
  }
  const char* const viscous =
      constant ? "viscous_constant" : "viscous_pressure_slope";
  friction->refuse_both(viscous, "coefficient");
  friction->refuse_both(viscous, "adhesion");
  return ViscousLaw(constant.value_or(0), slope.value_or(0));
}

// What a key measures by its SI unit.
Dimension dimension_of(std::string_view unit) {
  for (int i = 0; i <= static_cast<int>(Dimension::hersey); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    if (units_of(dimension)[0].ending == unit) return dimension;
  }
  throw std::logic_error("no key is in this unit");
}

KnownKeys friction_keys() {
  KnownKeys keys = {{"coefficient"},
                    {"adhesion", Dimension::stress},
                    {"viscous_constant", Dimension::viscous_constant},
                    {"viscous_pressure_slope", Dimension::inverse_velocity},
                    {"law"}};
  const auto add = [&](std::string_view key, std::string_view unit) {
    if (std::ranges::find(keys, key, &KnownKey::key) != keys.end()) return;
    keys.push_back({key, dimension_of(unit)});
  };
  for (const detail::StressEntry* entry : detail::stress_entries()) {
    for (const detail::StressNumber& number : entry->numbers) {
      add(number.key, number.unit);
    }
    if (entry->is_table()) add(entry->points, entry->points_unit);
  }
  add("coefficients", "");
  add("curve", "");
  return keys;
}

KnownKeys material_pair_keys() {
  return {{"name"},
          table_key("inner", material_keys()),
          table_key("outer", material_keys()),
          table_key("friction", friction_keys())};
}

MaterialPair material_pair_from_table(const TomlTable& table) {
  MaterialPair pair{table.text("name"), pair_from_table(table),
                    friction_from_table(table)};
  table.refuse_idle();
  return pair;
}

// What their values are to be multiplied by for a radial clearance; 0 for the
// radius. Interference is said by positive numbers.
struct ClearanceKey {
  std::string_view key;
  double scale;
};
constexpr ClearanceKey clearance_keys[] = {{"radial_clearance", 1},
                                           {"diametral_clearance", 0.5},
                                           {"relative_clearance", 0},
                                           {"radial_interference", -1},
                                           {"diametral_interference", -0.5}};

// hole and shaft, with a diameter.
std::optional<Fit> fit_from_table(const TomlTable& table) {
  for (const auto& [key, other] : {std::pair{"hole", "shaft"},
                                   {"shaft", "hole"},
                                   {"clearance", "hole"},
                                   {"hole", "diameter"}}) {
    if (table.has(key) && !table.has(other)) table.needs(key, other);
  }
  if (!table.has("hole")) return {};
  for (const auto& [key, scale] : clearance_keys) {
    table.refuse_both("hole", key);
  }
  const std::string hole = table.text("hole");
  if (!Fit::holes.contains(hole)) table.must_be("hole", Fit::holes.rule);
  const std::string shaft = table.text("shaft");
  if (!Fit::shafts.contains(shaft)) table.must_be("shaft", Fit::shafts.rule);
  const double diameter = table.number("diameter", Interval::positive());
  if (!Fit::has_size(shaft, diameter)) {
    table.must_be("diameter",
                  detail::message("3 to {:g} mm with shaft {}",
                                  Fit::largest_size(shaft) * 1e3, shaft));
  }
  const auto taken =
      table.optional_choice("clearance", {"minimum", "mean", "maximum"});
  return Fit(
      hole, shaft, diameter,
      taken ? static_cast<Fit::Clearance>(*taken) : Fit::Clearance::mean);
}

double radius_from_table(const TomlTable& table) {
  table.refuse_both("diameter", "radius");
  const auto diameter = table.optional_number("diameter", Interval::positive());
  if (diameter) return *diameter / 2;
  if (!table.has("radius")) table.needs("radius or diameter");
  return table.number("radius", Interval::positive());
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
  const auto kelvin = [&](std::string_view key) {
    return joint.optional_number(
        key, {Temperatures::coldest, Temperatures::hottest});
  };
  const auto both = kelvin("temperature");
  const auto inner = kelvin("inner_temperature");
  const auto outer = kelvin("outer_temperature");
  const auto reference = kelvin("reference_temperature");
  const auto axial = joint.optional_choice("axial_growth", {"free", "held"});
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

// The joint at the temperatures of its file.
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

JointGeometry geometry_from_table(const TomlTable& joint,
                                  const TomlTable& table,
                                  const std::optional<Fit>& fit) {
  const bool ball = joint.choice("kind", {"ball", "pin"}) == 0;
  const JointBody inner_body =
      joint.optional_choice("inner_body", {"carrier", "body"}).value_or(0) == 0
          ? JointBody::carrier
          : JointBody::body;
  const double radius = radius_from_table(table);
  const double clearance =
      fit ? fit->radial_clearance() : clearance_from_table(table, radius);
  if (ball) return JointGeometry::ball(radius, clearance, inner_body);
  const double length = table.number("length", Interval::positive());
  return JointGeometry::pin(radius, clearance, length, inner_body);
}

// [materials]: pair = "FILE", or [materials.inner] and [materials.outer].
MaterialPair materials_from_table(const TomlTable& joint) {
  const TomlTable table = joint.table("materials");
  if (!table.has("pair")) return {"", pair_from_table(table), {}};
  table.refuse_both("pair", "inner");
  table.refuse_both("pair", "outer");
  try {
    return material_pair_from_table(table.file("pair", material_pair_keys));
  } catch (const Error& error) {
    table.fail("pair", error.what());
  }
}

// "A, B and C".
std::string listed(const std::vector<std::string>& words) {
  const std::string last = words.back();
  if (words.size() == 1) return last;
  return detail::message(
      "{} and {}",
      detail::joined(std::span(words).first(words.size() - 1), ", "), last);
}

// A law that takes long to make is for all joints.
template <class Entry>
bool is_slow(const Entry* law) {
  return law && law->about.is_slow_to_make;
}

// [relief] of a pin.
Relief relief_from_table(const TomlTable& file, const JointSpec& joint) {
  const auto table = file.optional_table("relief");
  if (!table) return Relief::none();
  if (joint.geometry.kind() != JointKind::pin) {
    file.needs("relief", "kind = \"pin\"");
  }
  const bool barrel = table->choice("kind", {"barrel", "ends"}) == 0;
  const double depth = table->number("depth", Interval::positive());
  if (!barrel) {
    const double half = joint.geometry.length() / 2;
    return Relief::ends(depth, table->number("length", {0, half, true}));
  }
  if (table->has("length")) table->needs("length", "kind = \"ends\"");
  return Relief::barrel(depth);
}

// [loading], which fits the laws and walls that have been read.
InnerLoading loading_from_table(const TomlTable& file, const JointSpec& joint) {
  const auto table = file.optional_table("loading");
  if (!table) return InnerLoading::centre();
  if (table->choice("kind", {"centre", "back"}) == 0) {
    if (table->has("patch_half_angle")) {
      table->needs("patch_half_angle", "kind = \"back\"");
    }
    return InnerLoading::centre();
  }
  const InnerLoading loading = InnerLoading::back(
      table->number("patch_half_angle", {0, std::numbers::pi / 2}));
  if (!joint.inner.layers.empty()) {
    table->needs("kind",
                 "an inner body without [[coating]]: a coated ball or pin can "
                 "be loaded at its centre only");
  }
  const ContactConditions conditions{loading, joint.conditions().walls};
  const auto allows_back = [](const auto& law) {
    return law.about.allows_back;
  };
  if (!half_angle_law_allows(joint.half_angle_law, conditions)) {
    table->needs(
        "kind", detail::message("the half-angle law {}; this joint has {}",
                                listed(detail::names_of(
                                    detail::half_angle_entries(), allows_back)),
                                joint.half_angle_law));
  }
  if (!pressure_law_allows(joint.pressure_law, conditions)) {
    table->needs(
        "kind",
        detail::message(
            "one of the pressure laws {}; this joint has {}",
            listed(detail::names_of(detail::pressure_entries(), allows_back)),
            joint.pressure_law));
  }
  return loading;
}

}  // namespace

MaterialPair read_material_pair(const std::filesystem::path& path) {
  return material_pair_from_table(
      TomlTable::from_file(path, material_pair_keys()));
}

MaterialPair parse_material_pair(std::string_view text,
                                 const std::string& source) {
  return material_pair_from_table(
      TomlTable::from_text(text, source, material_pair_keys()));
}

Material read_material(const std::filesystem::path& path) {
  return material_from_table(TomlTable::from_file(path, material_keys()));
}

namespace {

// Of these materials, or of those that the table has.
JointSpec joint_of(const TomlTable& table, const MaterialPair* known) {
  std::string name = table.text("name");
  const TomlTable size = table.table("geometry");
  const auto fit = fit_from_table(size);
  const JointGeometry geometry = geometry_from_table(table, size, fit);
  const MaterialPair materials =
      known != nullptr ? *known : materials_from_table(table);
  JointSpec joint{
      .name = std::move(name),
      .geometry = geometry,
      .fit = fit,
      .inner = coated_body(table, geometry.radius(), materials.elastic.inner()),
      .outer =
          wall_from_table(table, geometry.radius(), materials.elastic.outer()),
      .friction = friction_from_table(table)};
  joint.conditions();  // refuses walls that do not fit the radius
  joint = at_temperatures(table, joint);
  joint.half_angle_law = joint.half_angle_law_name();
  joint.pressure_law = joint.pressure_law_name();
  if (!joint.friction) joint.friction = materials.friction;

  if (const auto half_angle = table.optional_table("half_angle")) {
    HalfAngleOptions& options = joint.half_angle_options;
    joint.half_angle_law =
        half_angle->optional_text("law").value_or(joint.half_angle_law);
    options.limit_half_angle = half_angle->optional_number(
        "limit_half_angle", {0, std::numbers::pi, true, true});
    options.linear_limit =
        half_angle->optional_choice("limit_formula", {"arctan", "linear"})
            .value_or(0) == 1;
    const auto degrees = half_angle->optional_number("degrees_per_radian",
                                                     degrees_per_radian_range);
    if (degrees) options.initial_slope = *degrees * degree;
    try {
      if (!is_slow(detail::find_half_angle_entry(joint.half_angle_law))) {
        joint.make_half_angle_law();
      }
    } catch (const Error& error) {
      half_angle->fail("law", error.what());
    }
    if (!takes_half_angle_options(joint.half_angle_law)) {
      for (const char* key :
           {"limit_half_angle", "limit_formula", "degrees_per_radian"}) {
        if (!half_angle->has(key)) continue;
        half_angle->needs(
            key, detail::message(
                     "one of the laws {}; this joint has {}",
                     listed(detail::names_of(
                         detail::half_angle_entries(),
                         [](const auto& law) { return law.takes_options; })),
                     joint.half_angle_law));
      }
    }
  }
  if (const auto pressure = table.optional_table("pressure")) {
    joint.pressure_law = pressure->text("law");
    try {
      if (!is_slow(detail::find_pressure_entry(joint.pressure_law))) {
        joint.make_pressure_law();
      }
    } catch (const Error& error) {
      pressure->fail("law", error.what());
    }
  }
  joint.loading = loading_from_table(table, joint);
  joint.relief = relief_from_table(table, joint);
  return joint;
}

}  // namespace

JointSpec joint_from_table(const TomlTable& table) {
  return joint_of(table, nullptr);
}

KnownKeys joint_keys() {
  KnownKeys keys = {
      {"name"},
      {"kind"},
      {"inner_body"},
      {"temperature", Dimension::temperature},
      {"inner_temperature", Dimension::temperature},
      {"outer_temperature", Dimension::temperature},
      {"reference_temperature", Dimension::temperature},
      {"axial_growth"},
      table_key("geometry", {{"radius", Dimension::length},
                             {"diameter", Dimension::length},
                             {"radial_clearance", Dimension::length},
                             {"diametral_clearance", Dimension::length},
                             {"relative_clearance"},
                             {"radial_interference", Dimension::length},
                             {"diametral_interference", Dimension::length},
                             {"hole"},
                             {"shaft"},
                             {"clearance"},
                             {"length", Dimension::length}}),
      table_key("materials", {{.key = "pair", .of_file = material_pair_keys()},
                              table_key("inner", material_keys()),
                              table_key("outer", material_keys())}),
      table_key("friction", friction_keys()),
      table_key("half_angle", {{"law"},
                               {"limit_half_angle", Dimension::angle},
                               {"limit_formula"},
                               {"degrees_per_radian"}}),
      table_key("pressure", {{"law"}}),
      table_key("loading", {{"kind"}, {"patch_half_angle", Dimension::angle}}),
      table_key("relief", {{"kind"},
                           {"depth", Dimension::length},
                           {"length", Dimension::length}})};
  std::ranges::copy(wall_keys(), std::back_inserter(keys));
  return keys;
}

JointSpec joint_of_file(const TomlTable& file, const MaterialPair* materials) {
  JointSpec joint = joint_of(file, materials);
  file.refuse_idle();
  return joint;
}

JointSpec read_joint(const std::filesystem::path& path,
                     const KeySettings& settings) {
  return joint_of_file(TomlTable::from_file(path, joint_keys(), settings));
}

JointSpec parse_joint(std::string_view text, const std::string& source,
                      const KeySettings& settings,
                      const std::filesystem::path& folder) {
  return joint_of_file(
      TomlTable::from_text(text, source, joint_keys(), folder, settings));
}

}  // namespace contact
