#include "libcontact/files/tables/wall_tables.hpp"

#include <cmath>
#include <utility>

#include "libcontact/base/text.hpp"
#include "libcontact/files/tables/material_table.hpp"

namespace contact {
namespace {

double thickness_from_table(const TomlTable& layer, double radius) {
  const double thickness = layer.number("thickness");
  // Thicker ones are as good as infinite; powers of 1e300 would overflow.
  constexpr double largest_ratio = 1e6;
  constexpr double smallest_ratio = LayeredPair::smallest_relative_thickness;
  if (thickness < smallest_ratio * radius ||
      thickness > largest_ratio * radius) {
    layer.must_be("thickness",
                  detail::message("{:g} to {:g} of the radius of {:g} m",
                                  smallest_ratio, largest_ratio, radius));
  }
  return thickness;
}

Layer layer_from_table(const TomlTable& table, double radius) {
  return {thickness_from_table(table, radius),
          material_from_table(table, Rigid::refused)};
}

// The layer at the contact, which may be of the pair's outer material.
Layer first_layer(const TomlTable& table, double radius,
                  const Material& outer) {
  for (const KnownKey& key : material_keys()) {
    if (table.has(key.key)) {
      return layer_from_table(table, radius);
    }
  }
  if (std::isinf(outer.youngs_modulus)) {
    table.needs(
        "an elastic outer body, or a youngs_modulus of its own: that of the "
        "materials is rigid");
  }
  return {thickness_from_table(table, radius), outer};
}

Backing backing_from_table(const TomlTable& wall) {
  constexpr const char* material =
      "a material { youngs_modulus, poissons_ratio }";
  if (!wall.has("backing")) {
    wall.needs(
        detail::message("backing: \"rigid\", \"held\" or {}, behind the "
                        "layers",
                        material));
  }
  if (wall.is_table("backing")) {
    return Backing::medium(material_from_table(wall.table("backing")));
  }
  return wall.choice("backing", material) == 0 ? Backing::rigid()
                                               : Backing::held();
}

Material in_plane_stress(Material material) {
  const double nu = material.poissons_ratio;
  material.youngs_modulus *= (1 + 2 * nu) / ((1 + nu) * (1 + nu));
  material.poissons_ratio = nu / (1 + nu);
  return material;
}

void put_in_plane_stress(LayeredBody& body) {
  for (Layer& layer : body.layers) {
    layer.material = in_plane_stress(layer.material);
  }
  if (body.backing.kind() == Backing::Kind::medium) {
    body.backing = Backing::medium(in_plane_stress(body.backing.material()));
  }
}

}  // namespace

LayeredBody wall_from_table(const TomlTable& joint, double radius,
                            const Material& outer) {
  const auto wall = joint.optional_table("wall");
  if (!wall) return {{}, Backing::medium(outer)};
  if (!wall->has("layer")) {
    wall->needs(
        "at least one [[wall.layer]]; an outer body that is rigid as a "
        "whole has youngs_modulus = inf");
  }
  std::vector<Layer> layers;
  for (const TomlTable& table : wall->tables("layer")) {
    layers.push_back(layers.empty() ? first_layer(table, radius, outer)
                                    : layer_from_table(table, radius));
  }
  return {std::move(layers), backing_from_table(*wall)};
}

LayeredBody coated_body(const TomlTable& joint, double radius,
                        const Material& core) {
  std::vector<Layer> coatings;
  double thickness = 0;
  for (const TomlTable& table : joint.tables("coating")) {
    coatings.push_back(layer_from_table(table, radius));
    thickness += coatings.back().thickness;
    if (thickness >= radius) {
      table.must_be("thickness",
                    detail::message("a thickness with which all coatings "
                                    "together are below the radius of {:g} m",
                                    radius));
    }
  }
  return {std::move(coatings), Backing::medium(core)};
}

void take_plane_state(const TomlTable& joint, JointKind kind,
                      LayeredBody& inner, LayeredBody& outer) {
  const auto state = joint.optional_choice("plane_state");
  if (!state) return;
  if (kind == JointKind::ball) joint.needs("plane_state", "kind = \"pin\"");
  if (*state == 0) return;
  // Growth along the axis is another one in plane stress.
  for (const char* key : {"temperature", "inner_temperature"}) {
    joint.refuse_both("plane_state", key);
  }
  put_in_plane_stress(inner);
  put_in_plane_stress(outer);
}

KnownKeys wall_keys() {
  KnownKeys layer = material_keys();
  layer.push_back(
      number_key("thickness", Dimension::length, Interval::positive()));
  KnownKey backing = word_key("backing", {"rigid", "held"});
  backing.inside = material_keys();
  return {table_key("wall", {backing, table_key("layer", layer)}),
          table_key("coating", layer)};
}

}  // namespace contact
