#include "libcontact/files/joint_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>

#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/tables/friction_table.hpp"
#include "libcontact/files/tables/geometry_table.hpp"
#include "libcontact/files/tables/law_tables.hpp"
#include "libcontact/files/tables/material_table.hpp"
#include "libcontact/files/tables/wall_tables.hpp"

namespace contact {
namespace {

// Default for a missing name: the file's name without its ending.
std::string stem_of(const TomlTable& table) {
  return std::filesystem::path(table.source()).stem().string();
}

ElasticPair pair_from_table(const TomlTable& table) {
  const Material inner = material_from_table(table.table("inner"));
  const TomlTable outer_table = table.table("outer");
  const Material outer = material_from_table(outer_table);
  if (std::isinf(inner.youngs_modulus) && std::isinf(outer.youngs_modulus)) {
    outer_table.must_be("youngs_modulus", "finite: the inner body is rigid");
  }
  return ElasticPair(inner, outer);
}

KnownKeys material_pair_keys() {
  return {{"name"},
          table_key("inner", material_keys()),
          table_key("outer", material_keys()),
          table_key("friction", friction_keys())};
}

MaterialPair material_pair_from_table(const TomlTable& table) {
  MaterialPair pair{table.optional_text("name").value_or(stem_of(table)),
                    pair_from_table(table), friction_from_table(table)};
  table.refuse_idle();
  return pair;
}

// [materials]: pair = "FILE", or [materials.inner] and [materials.outer].
MaterialPair given_materials(const TomlTable& table) {
  if (!table.has("pair")) return {"", pair_from_table(table), {}};
  table.refuse_both("pair", "inner");
  table.refuse_both("pair", "outer");
  try {
    return material_pair_from_table(table.file("pair", material_pair_keys));
  } catch (const Error& error) {
    table.fail("pair", error.what());
  }
}

// The same, and whether the outer body is a liner after all.
MaterialPair materials_from_table(const TomlTable& joint) {
  const TomlTable table = joint.table("materials");
  MaterialPair pair = given_materials(table);
  if (!table.has("liner")) return pair;
  Material outer = pair.elastic.outer();
  outer.liner = table.flag("liner");
  pair.elastic = ElasticPair(pair.elastic.inner(), outer);
  return pair;
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

// Joint with these materials, or with the materials of the table.
// @param name  if the table has none; "": it needs one
JointSpec joint_of(const TomlTable& table, const MaterialPair* known,
                   std::string name) {
  if (name.empty() || table.has("name")) name = table.text("name");
  const TomlTable size = table.table("geometry");
  const auto fit = fit_from_table(size);
  const auto bearing = bearing_from_table(size);
  const JointGeometry geometry = geometry_from_table(table, size, fit, bearing);
  const MaterialPair materials =
      known != nullptr ? *known : materials_from_table(table);
  JointSpec joint{
      .name = std::move(name),
      .geometry = geometry,
      .fit = fit,
      .bearing = bearing,
      .inner = coated_body(table, geometry.radius(), materials.elastic.inner()),
      .outer =
          wall_from_table(table, geometry.radius(), materials.elastic.outer()),
      .friction = friction_from_table(table)};
  const auto seat = table.optional_table("seat");
  if (seat && seat->flag("left_out")) joint = joint.without_seat();
  take_plane_state(table, geometry.kind(), joint.inner, joint.outer);
  joint.conditions();  // refuses walls that do not fit the radius
  joint = at_temperatures(table, joint);
  // The default of a seat that ends is another one without_seat().
  if (!joint.geometry.seat()) {
    joint.half_angle_law = joint.half_angle_law_name();
  }
  joint.pressure_law = joint.pressure_law_name();
  if (!joint.friction) joint.friction = materials.friction;

  read_laws(table, joint);
  joint.relief = relief_from_table(table, joint.geometry);
  return joint;
}

}  // namespace

JointSpec joint_from_table(const TomlTable& table) {
  return joint_of(table, nullptr, {});
}

KnownKeys joint_keys() {
  KnownKeys keys = {
      {"name"},
      word_key("kind", {"ball", "pin"}),
      word_key("inner_body", {"carrier", "body"}),
      table_key("materials", {{.key = "pair", .of_file = material_pair_keys()},
                              table_key("inner", material_keys()),
                              table_key("outer", material_keys()),
                              {"liner"}}),
      table_key("friction", friction_keys())};
  for (const auto& more : {geometry_keys(), law_keys(), wall_keys()}) {
    std::ranges::copy(more, std::back_inserter(keys));
  }
  return keys;
}

JointSpec joint_of_file(const TomlTable& file, const MaterialPair* materials) {
  JointSpec joint = joint_of(file, materials, stem_of(file));
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
