#pragma once

#include <string>
#include <vector>

/// Joint files with every kind of friction and every kind of wall, to test that
/// all interfaces accept them.
namespace contact::test {

struct JointText {
  std::string name;      ///< "pin, viscous, layer on a rigid backing"
  std::string friction;  ///< kind of friction
  std::string toml;
};

inline std::vector<JointText> every_joint() {
  struct Part {
    const char* name;
    const char* toml;
  };
  const Part frictions[] = {
      {"dry", "coefficient = 0.1"},
      {"adhesive", "coefficient = 0.1\nadhesion_kPa = 50"},
      {"viscous", "viscous_constant_Pa_s_per_m = 2e5"},
      {"viscous over pressure", "viscous_pressure_slope_s_per_m = 0.5"},
      {"stribeck",
       "law = \"stribeck\"\nstatic_coefficient = 0.15\ndynamic_coefficient = "
       "0.05\nstribeck_velocity_mm_per_s = 10"},
      {"power",
       "law = \"power\"\ncoefficient = 0.1\nreference_pressure_MPa = 10\n"
       "exponent = 0.2"},
      {"table of pressures",
       "law = \"pressure_table\"\npressures_MPa = [1, 10, 100]\n"
       "coefficients = [0.12, 0.1, 0.08]"},
      {"table of Hersey's number",
       "law = \"hersey_table\"\nspeeds_over_pressure_mm_per_s_MPa = [0.01, 1, "
       "100]\ncoefficients = [0.12, 0.1, 0.08]\ncurve = \"linear\""},
  };
  const Part walls[] = {
      {"no walls", ""},
      {"layer on a rigid backing",
       "[wall]\nbacking = \"rigid\"\n[[wall.layer]]\nthickness_mm = 4\n"},
      {"free ring of two layers",
       "[wall]\nbacking = \"held\"\n[[wall.layer]]\nthickness_mm = 4\n"
       "[[wall.layer]]\nthickness_mm = 10\nyoungs_modulus_GPa = 200\n"
       "poissons_ratio = 0.3\n"},
      {"layer in a medium",
       "[wall]\nbacking = { youngs_modulus_GPa = 70, poissons_ratio = 0.33 }\n"
       "[[wall.layer]]\nthickness_mm = 4\n"},
      {"coating",
       "[[coating]]\nthickness_mm = 1\nyoungs_modulus_GPa = 3\n"
       "poissons_ratio = 0.4\nname = \"a \\\"soft\\\" coat\"\n"},
  };
  std::vector<JointText> all;
  for (const char* kind : {"ball", "pin"}) {
    for (const Part& friction : frictions) {
      for (const Part& wall : walls) {
        const bool pin = *kind == 'p';
        all.push_back(
            {std::string(kind) + ", " + friction.name + ", " + wall.name,
             friction.name,
             "name = \"" + std::string(friction.name) + "\"\nkind = \"" + kind +
                 "\"\n[geometry]\nradius_mm = 20\nradial_clearance_um = 40\n" +
                 (pin ? "length_mm = 50\n" : "") +
                 "[materials.inner]\nyoungs_modulus_GPa = 210\n"
                 "poissons_ratio = 0.3\n[materials.outer]\nname = \"bronze\"\n"
                 "youngs_modulus_GPa = 110\npoissons_ratio = 0.34\n"
                 "limit_pressure_MPa = 300\n[friction]\n" +
                 friction.toml + '\n' + wall.toml});
      }
    }
  }
  return all;
}

}  // namespace contact::test
