#include "libcontact/files/tables/material_table.hpp"

#include <cmath>
#include <string>

namespace contact {
namespace {

// From foams to above diamond (1.1e12 Pa): outside it a unit was mistaken.
constexpr Interval modulus_range{1e3, 1e13};

}  // namespace

Material material_from_table(const TomlTable& table, Rigid rigid) {
  const std::string name = table.optional_text("name").value_or("");
  const double modulus = rigid == Rigid::allowed
                             ? table.number("youngs_modulus")
                             : table.number("youngs_modulus", modulus_range);
  // A rigid body's Poisson's ratio has no influence.
  const double ratio = std::isinf(modulus)
                           ? table.optional_number("poissons_ratio").value_or(0)
                           : table.number("poissons_ratio");
  Material material{modulus, ratio, name};
  const auto limit = table.optional_number("limit_pressure");
  if (limit) material.limit_pressure = *limit;
  material.thermal_expansion = table.optional_number("thermal_expansion");
  material.liner = table.flag("liner");
  return material;
}

KnownKeys material_keys() {
  Interval or_rigid = modulus_range;
  or_rigid.or_infinity = true;
  // Polymers have 1e-4 to 3e-4: beyond this the power of ten was mistaken.
  constexpr Interval expansion{-1e-3, 1e-3};
  return {{"name"},
          number_key("youngs_modulus", Dimension::stress, or_rigid),
          number_key("poissons_ratio", {0, 0.5}),
          number_key("limit_pressure", Dimension::stress, Interval::positive()),
          number_key("thermal_expansion", Dimension::inverse_temperature,
                     expansion),
          {"liner"}};
}

}  // namespace contact
