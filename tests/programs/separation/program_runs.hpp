#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/number.hpp"
#include "support/program.hpp"
#include "support/toml_text.hpp"

/// Runs of hinge-separation, and cases shared by several tests.
namespace contact::test {

using Eigen::Vector3d;
using nlohmann::json;

/// A time history, whose vectors have rows from 0.
class History : public CsvTable {
 public:
  using CsvTable::CsvTable;

  Vector3d vector(const std::string& body, const char* x, const char* y,
                  const char* z, std::size_t row) const {
    return {(*this)[body + x][row], (*this)[body + y][row],
            (*this)[body + z][row]};
  }
  Vector3d position(const std::string& body, std::size_t row) const {
    return vector(body, ".x_m", ".y_m", ".z_m", row);
  }
  Vector3d velocity(const std::string& body, std::size_t row) const {
    return vector(body, ".vx_m_per_s", ".vy_m_per_s", ".vz_m_per_s", row);
  }
  /// I w about the centre of mass, inertial axes.
  Vector3d spin(const std::string& body, const Vector3d& inertia,
                std::size_t row) const {
    const Eigen::Quaterniond q(
        (*this)[body + ".qw"][row], (*this)[body + ".qx"][row],
        (*this)[body + ".qy"][row], (*this)[body + ".qz"][row]);
    const Vector3d w =
        vector(body, ".wx_rad_per_s", ".wy_rad_per_s", ".wz_rad_per_s", row);
    return q * inertia.cwiseProduct(w);
  }
};

/// Output of a run that must succeed.
inline json run_json(const ProgramFolder& folder,
                     const std::string& arguments) {
  return json::parse(folder.run_well("hinge-separation " + arguments).out);
}

/// Replaces the first occurrence of a text.
inline std::string exchanged(std::string text, const std::string& from,
                             const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

/// A case of data/cases with its files named from the project's root.
inline std::string sample_case(const std::string& name) {
  std::string text = ProgramFolder().read("data/cases/" + name + ".toml");
  for (std::size_t at; (at = text.find("\"../")) != text.npos;) {
    text.replace(at, 4, "\"data/");
  }
  return text;
}

/// Table of a fixed carrier.
inline std::string carrier_at_rest(const std::string& name) {
  return "[carrier]\nname = \"" + name + R"("
mass_kg = 1000; principal_inertia_kg_m2 = [1, 1, 1]
drive = { acceleration_m_per_s2 = [0, 0, 0] })"_toml;
}

/// Two bodies that push each other, without external forces.
inline const std::string alone = R"(
name = "alone"
[run]; end_time_s = 3; output_step_s = 0.05
[carrier]; name = "core"; mass_kg = 100; principal_inertia_kg_m2 = [10, 12, 14]
start = { velocity_m_per_s = [1, 2, -0.5], angular_velocity_rad_per_s = [0.1, -0.2, 0.3] }
[[body]]; name = "tip"; mass_kg = 20; com_m = [0.2, 0.1, 0]
principal_inertia_kg_m2 = [1, 2, 2.5]
[body.hinge]; kind = "ball"; carrier_point_m = [1, 0, 0]
[[body.hinge.joint]]; name = "ball"; kind = "ball"
geometry = { radius_mm = 30, radial_clearance_um = 60 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.2, adhesion_MPa = 1 }
[body.lock]; body_point_m = [0.5, 0, 0]
[[event]]; name = "lock opens"; time_s = 0.4; breaks = "lock"
[[event]]; name = "hinge breaks"; after = "lock opens"; delay_s = 0.7
breaks = "hinge"
[[force]]; name = "pusher"; kind = "pusher"; body = "tip"
point_m = [0.1, 0.3, 0]; carrier_point_m = [1.1, 0.3, 0]
direction = [-0.5, 1, 0.2]; first_force_N = 200; last_force_N = 50
stroke_mm = 60
[[force]]; name = "spring"; kind = "spring"; body = "tip"
point_m = [0, 0, 0.4]; carrier_point_m = [0.5, 0.1, 0.5]
stiffness_N_per_m = 300; free_length_m = 0.9; damping_N_s_per_m = 5
)"_toml;

/// A pusher of 100 to 40 N over 0.1 m between bodies of 10 and 5 kg, with the
/// used part of its stroke at the start, and further keys.
inline std::string pushed_case(double used, double speed,
                               const std::string& more) {
  return R"(
name = "pushed"
[run]; end_time_s = 2
[carrier]; name = "c"; mass_kg = 10; principal_inertia_kg_m2 = [1, 1, 1]
[[body]]; name = "s"; mass_kg = 5; principal_inertia_kg_m2 = [1, 1, 1]
[body.start]
position_m = [)"_toml +
         cli::number_text(1 + used) + ", 0, 0]\nvelocity_m_per_s = [" +
         cli::number_text(speed) + R"(, 0, 0]
[[force]]; name = "push"; body = "s"; kind = "pusher"; point_m = [-0.2, 0, 0]
carrier_point_m = [0.8, 0, 0]; direction = [1, 0, 0]; first_force_N = 100
last_force_N = 40; stroke_m = 0.1
)"_toml + more;
}

}  // namespace contact::test
