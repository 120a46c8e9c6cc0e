// Changes at one instant: hinges that begin to slide, motors that end with
// their hinge, and the peaks of hinges that change together.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "support/toml_text.hpp"

namespace contact::test::instant_test {
namespace {

using separation::BodyRecord;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::run_case;

std::string steel_joint(const std::string& kind, const std::string& keys) {
  const bool is_ball = kind == "ball";
  return "[[body.hinge.joint]]\nname = \"j\"\nkind = \"" + kind + "\"\n" +
         (is_ball ? "half_angle = { law = \"tanh\", limit_half_angle_deg = 88 }"
                  : "half_angle = { law = \"arctan\", limit_half_angle_deg = "
                    "85 }") +
         "\npressure.law = \"cosine\"\n"
         "materials.inner = { youngs_modulus_GPa = 207, poissons_ratio = 0.3 "
         "}\n"
         "materials.outer = { youngs_modulus_GPa = 210, poissons_ratio = 0.35 "
         "}\n" +
         keys;
}

// Two bodies on dry hinges of a free carrier; a spring moves one of them. At
// 0.27 s the other begins to slide too, with a moment that exceeds the limit of
// friction by 1e-10 of it.
std::string two_hinges(double friction) {
  const std::string dry =
      "friction = { coefficient = " + std::to_string(friction) +
      ", adhesion_Pa = 0 }\n";
  const std::string size =
      "geometry = { radius_m = 0.031, radial_clearance_m = 0.00022";
  return R"(
name = "two hinges"; run = { end_time_s = 4, output_step_s = 0.5 }
[carrier]; name = "car"; mass_kg = 230; com_m = [0.15, 0.2, -0.33]
inertia_kg_m2 = [[430, 170, 60], [170, 290, -75], [60, -75, 390]]
[[body]]; name = "b1"; mass_kg = 39; com_m = [-0.61, 0.18, 0.32]
inertia_kg_m2 = [[32, -0.69, 0.73], [-0.69, 20, 0.9], [0.73, 0.9, 23]]
[body.hinge]; kind = "axis"; body_point_m = [-0.28, 0.2, 0.1]
carrier_point_m = [1.1, 0.09, -0.54]; zero_rotation_rad = [-0.91, -0.54, -0.36]
axis = [1.4, 2.8, 1.1]
)"_toml + steel_joint("ball", dry + size + " }\nposition_m = 0.2\n") +
         steel_joint("pin",
                     dry + size + ", length_m = 0.062 }\nposition_m = -0.3\n") +
         R"([[body]]; name = "b3"; mass_kg = 4.4; com_m = [0.048, 0.11, -0.51]
inertia_kg_m2 = [[1.2, -0.036, 0.44], [-0.036, 1.4, 0.02], [0.44, 0.02, 1.8]]
[body.hinge]; kind = "axis"; body_point_m = [-0.073, -0.19, 0.26]
carrier_point_m = [-0.35, 0.22, -1.8]; zero_rotation_rad = [0.8, -1, -1.1]
axis = [-3, 0.18, 0.89]
[[body.hinge.joint]]; kind = "pin"; name = "j"
materials.inner = { youngs_modulus_GPa = 207, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 1, poissons_ratio = 0.35 }
friction = { coefficient = 0.22, adhesion_Pa = 0 }
half_angle = { law = "arctan", limit_half_angle_deg = 85 }
pressure.law = "cosine"
geometry = { radius_m = 0.046, radial_clearance_m = 0.00041, length_m = 0.092 }
[[force]]; name = "spring b3"; body = "b3"; kind = "spring"
point_m = [2.1, 0.87, -0.34]; carrier_point_m = [-1.1, 0.96, 4.8]
stiffness_N_per_m = 2100; free_length_m = 0.96
)"_toml;
}

// Whatever the friction. No hinge goes for less than 1e-9 s.
TEST(Instant, AHingeBeginsToSlideBesideOneThatSlides) {
  std::vector<double> coefficients = {0.41};
  for (int k = 1; k <= 15; ++k) coefficients.push_back(0.05 * k);
  for (const double friction : coefficients) {
    const Outcome outcome =
        run_case(parse_case(two_hinges(friction), "c.toml"), {});
    EXPECT_EQ(outcome.failure, "") << friction;
    EXPECT_EQ(outcome.end_time, 4) << friction;
    const auto& notes = outcome.memory.notes;
    EXPECT_GT(notes.size(), 10U);
    for (auto a = notes.begin(); a != notes.end(); ++a) {
      const auto b = std::find_if(a + 1, notes.end(), [&](const auto& note) {
        return note.body == a->body;
      });
      if (a->what == "begins to slide" && b != notes.end()) {
        EXPECT_GT(b->time, a->time + 1e-9) << friction << ' ' << a->time;
      }
    }
  }
}

// A wheel of 2 kg m^2 whose motor gives it 3 N m against a carrier of 8 kg m^2,
// until its hinge breaks.
std::string motor_case(const std::string& moment) {
  return R"(
name = "motor"; run = { end_time_s = 2, output_step_s = 0.25 }
[carrier]; name = "c"; mass_kg = 100; principal_inertia_kg_m2 = [8, 8, 8]
[[body]]; name = "wheel"; mass_kg = 5; principal_inertia_kg_m2 = [1, 1, 2]
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [0, 0, 0] }
[[event]]; name = "off"; time_s = 1; breaks = "hinge"
[[force]]; name = "motor"; kind = "motor"; body = "wheel"
)"_toml + moment;
}

TEST(Instant, MotorsEndWithTheirHinge) {
  for (const std::string moment :
       {"moment_N_m = 3\n", "angle_deg = [-3600, 3600]\nmoment_N_m = [3, 3]\n",
        "time_s = [0, 5]\nmoment_N_m = [3, 3]\nends_at_s = 1.5\n"}) {
    SCOPED_TRACE(moment);
    const Outcome outcome =
        run_case(parse_case(motor_case(moment), "c.toml"), {});
    ASSERT_EQ(outcome.failure, "");
    const Rows& rows = outcome.memory.rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double time = std::min(rows.at(i, 0), 1.0);
      const auto spin = [&](const char* name) {
        return rows.at(i, rows.column(name));
      };
      EXPECT_NEAR(spin("wheel.wz_rad_per_s"), 3 * time / 2, 1e-9);
      EXPECT_NEAR(spin("c.wz_rad_per_s"), -3 * time / 8, 1e-9);
    }
    EXPECT_NEAR(outcome.memory.bodies[0].release.rate, 3.0 / 2 + 3.0 / 8, 1e-9);
  }
}

// Two mirror-image halves on hinges that begin to slide when their lock opens:
// all peaks occur in rows, and are equal for both halves.
TEST(Instant, PeaksAreNotOfStatesOnTheWay) {
  const std::string size = "geometry = { radial_clearance_um = 60, ";
  const std::string dry = "friction = { coefficient = 1, adhesion_MPa = 1 }\n";
  const Outcome outcome = run_case(
      parse_case(
          R"(
name = "halves"; gravity_m_per_s2 = [-2, 0, 0]
run = { end_time_s = 0.3, output_step_s = 0.02 }
[carrier]; name = "stage"; mass_t = 12; com_m = [-3, 0, 0]
principal_inertia_kg_m2 = [2e4, 9e4, 9e4]
[[force]]; name = "engine"; body = "stage"; kind = "thrust"
point_m = [-6, 0, 0]; direction = [1, 0, 0]; thrust_kN = 80
[[event]]; name = "opens"; time_s = 0.2; breaks = "lock"
[[force]]; name = "gas spring"; body = "half"; kind = "pusher"
point_m = [5, 1.4, 0]; carrier_point_m = [4.5, 1.3, 0]; direction = [0, 1, 0]
first_force_kN = 6; last_force_kN = 2; stroke_mm = 450
starts_at_event = "opens"
[[body]]; name = "half"; mass_kg = 420; com_m = [3.1, 1.15, 0]
principal_inertia_kg_m2 = [480, 1850, 1650]
pattern = { count = 2, axis = [1, 0, 0] }
[body.lock]; name = "band"; body_point_m = [6, 0.3, 0]
[body.hinge]; name = "base hinge"; kind = "axis"; body_point_m = [0, 1.9, 0]
carrier_point_m = [0, 1.9, 0]; axis = [0, 0, 1]
)"_toml +
              steel_joint("ball", dry + size +
                                      "radius_mm = 100 }\nposition_m = 0.5\n") +
              steel_joint("pin", dry + size +
                                     "radius_mm = 100, length_mm = 40 "
                                     "}\nposition_m = -0.5\n"),
          "c.toml"),
      {});
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  const BodyRecord& one = outcome.memory.bodies[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyRecord& body = outcome.memory.bodies[i];
    double largest = 0;
    const std::size_t column =
        rows.column("half_" + std::to_string(i + 1) + ".reaction_N");
    for (std::size_t row = 0; row < rows.size(); ++row) {
      largest = std::max(largest, rows.at(row, column));
    }
    EXPECT_NEAR(body.peak_reaction, largest, 1e-9 * largest);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR(body.joints[j].moment, one.joints[j].moment,
                  1e-9 * one.joints[j].moment);
      EXPECT_NEAR(body.joints[j].half_angle / degree,
                  one.joints[j].half_angle / degree, 1e-7);
    }
  }
}

}  // namespace
}  // namespace contact::test::instant_test
