#include "libcontact/files/tables/material_table.hpp"

#include <cmath>
#include <string>

namespace contact {

Material material_from_table(const TomlTable& table, Rigid rigid) {
  // From foams to above diamond (1.1e12 Pa): outside it a unit was mistaken.
  const Interval youngs_modulus_range{
      .low = 1e3, .high = 1e13, .or_infinity = rigid == Rigid::allowed};
  constexpr Interval poissons_ratio_range{0, 0.5};
  const std::string name = table.optional_text("name").value_or("");
  const double modulus = table.number("youngs_modulus", youngs_modulus_range);
  // A rigid body's Poisson's ratio has no influence.
  const double ratio =
      std::isinf(modulus)
          ? table.optional_number("poissons_ratio", poissons_ratio_range)
                .value_or(0)
          : table.number("poissons_ratio", poissons_ratio_range);
  Material material{modulus, ratio, name};
  const auto limit =
      table.optional_number("limit_pressure", Interval::positive());
  if (limit) material.limit_pressure = *limit;
  // Polymers have 1e-4 to 3e-4: beyond this the power of ten was mistaken.
  material.thermal_expansion =
      table.optional_number("thermal_expansion", {-1e-3, 1e-3});
  material.liner = table.flag("liner");
  return material;
}

KnownKeys material_keys() {
  return {{"name"},
          {"youngs_modulus", Dimension::stress},
          {"poissons_ratio"},
          {"limit_pressure", Dimension::stress},
          {"thermal_expansion", Dimension::inverse_temperature},
          {"liner"}};
}

}  // namespace contact
