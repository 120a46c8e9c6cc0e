// Questions of designers to the programs: peaks that name their pressure,
// forces of pins, catalogues' pressures, warnings.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/program.hpp"
#include "support/toml_text.hpp"

namespace contact::test::designer_test {
namespace {

class Designer : public testing::Test {
 protected:
  ProgramResult run(const std::string& command) const {
    return folder_.run_well(command);
  }
  double value(const std::string& command, const std::string& column) const {
    return folder_.table(command).at(column);
  }
  bool warns(const std::string& command, const std::string& of) const {
    return run(command).err.find(of) != std::string::npos;
  }

  ProgramFolder folder_;
  const std::string ball_ =
      " --joint ball --pair data/materials/steel_bronze.toml --radius 50mm "
      "--clearance 50um ";
  const std::string pin_ =
      " --joint pin --pair data/materials/steel_bronze.toml --radius 20mm "
      "--clearance 40um ";
};

// 1.5 F/(pi a^2), a^3 = 3 F/(4 E* (1/50 mm - 1/50.05 mm)).
TEST_F(Designer, HertzPeaksAreHertzOwn) {
  const std::string hertz = "hinge-angle --law hertz --load 1e4" + ball_;
  const std::string column = "p_peak_hertz_by_hertz_Pa";
  EXPECT_NEAR(value(hertz, column), 17.191e6, 1e3);
  EXPECT_NEAR(value(hertz + "--pressure cosine", "p_peak_hertz_by_cosine_Pa"),
              22.699e6, 1e3);
  const double theta0 =
      value(hertz, "theta0_hertz_deg") * std::numbers::pi / 180;
  // Without a size over the nominal pressure.
  EXPECT_NEAR(value("hinge-angle --law hertz --joint ball --modulus-ratio 1 "
                    "--x " +
                        std::to_string(std::sin(theta0)),
                    "p_peak_hertz_by_hertz_over_nominal") *
                  1e4 / (std::numbers::pi * 0.05 * 0.05),
              17.191e6, 2e3);
}

// A pin of 4 mm in a hole of 5 mm: b^2 = 4 P/(pi E* (1/4 mm - 1/5 mm)), and
// 2 P/(pi b).
TEST_F(Designer, HertzIsOfBothRadiiAtAnyClearance) {
  const std::string pin =
      " --joint pin --pair data/materials/steel_steel.toml --radius 4mm "
      "--clearance 1mm --length 8mm --law hertz ";
  const auto angle = folder_.table("hinge-angle --load 800" + pin);
  EXPECT_NEAR(angle.at("p_peak_hertz_by_hertz_Pa"), 424.36e6, 0.02e6);
  EXPECT_NEAR(angle.at("theta0_hertz_deg"), 2.149, 1e-3);
  const double theta0 = angle.at("theta0_hertz_deg");
  // The load that a half-ellipse of this peak and width carries.
  EXPECT_NEAR(std::numbers::pi / 2 * angle.at("p_peak_hertz_by_hertz_Pa") *
                  0.004 * std::sin(theta0 * std::numbers::pi / 180) * 0.008,
              800, 1e-9);
  // The other way round, and by the joint.
  EXPECT_NEAR(
      value("hinge-angle --inverse --theta0 " + std::to_string(theta0) + pin,
            "load_hertz_N"),
      800, 1e-3);
  for (const std::string program : {"hinge-joint --friction 0 --reaction 800",
                                    "hinge-pressure --summary --load 800"}) {
    EXPECT_NEAR(value(program + pin, "theta0_deg") / theta0, 1, 1e-14)
        << program;
  }
}

// A pin without a length, or without any size, is not short.
TEST_F(Designer, PinsAreShortIfTheyHaveALength) {
  const std::string wide = "wider than the pin is long";
  for (const std::string program : {"hinge-angle ", "hinge-pressure "}) {
    EXPECT_FALSE(warns(program + "--joint pin --modulus-ratio 1 --x 1", wide));
    EXPECT_FALSE(warns(program + "--load 1e9" + pin_, wide));
    EXPECT_TRUE(warns(program + "--length 10mm --load 1e6" + pin_, wide));
  }
}

// One name, one number: of GE50ES 100 kN over the ball's 66 mm times the ring's
// 28 mm at every door that has the bearing.
TEST_F(Designer, NominalPressureOfABearingIsThatOfItsCatalogue) {
  const std::string of =
      " --joint ball --pair data/materials/steel_steel.toml --bearing GE50ES ";
  const double expected = 1e5 / (0.066 * 0.028);
  for (const std::string program :
       {"hinge-angle --load 1e5", "hinge-pressure --summary --load 1e5",
        "hinge-pressure --direction 90 --load 1e5",
        "hinge-joint --friction 0 --beta 90 --reaction 1e5",
        "hinge-joint --friction 0 --beta 90 --reaction 1e5 --without-seat"}) {
    EXPECT_NEAR(value(program + of, "p_nominal_Pa") / expected, 1, 1e-12)
        << program;
  }
}

// README's bush: 0.08 times 10 kN times 10 mm.
TEST_F(Designer, TextbookMomentIsCoefficientTimesLoadTimesRadius) {
  EXPECT_NEAR(value("hinge-joint --joint data/joints/lined_bush_pressed.toml "
                    "--reaction 10kN",
                    "M_textbook_N_m"),
              8, 1e-14);
}

// The load of a pin with a known length is a force in all programs.
TEST_F(Designer, LoadsOfPinsSayWhatTheyAre) {
  const std::string angle = "hinge-angle --pressure exact" + pin_;
  const std::string peak = "p_peak_fitted_by_exact_Pa";
  const double with_length = value(angle + "--length 50mm --load 20000", peak);
  EXPECT_EQ(value(angle + "--length 50mm --load 20kN", peak), with_length);
  EXPECT_EQ(value(angle + "--length 50mm --load 20kN", "load_N"), 20000);
  EXPECT_EQ(value(angle + "--load 400kN_per_m", "load_N_per_m"), 4e5);
  // 20 kN on 50 mm; a rounding or two of the load.
  for (const std::string load :
       {"--load 4e5", "--load 400kN/m", "--length 50mm --load 400N_per_mm"}) {
    EXPECT_NEAR(value(angle + load, peak) / with_length, 1, 1e-14) << load;
  }
  // The same force, the same joint, another program. It is normal to the
  // contact if there is no friction.
  EXPECT_NEAR(value("hinge-joint --friction 0 --pressure exact --reaction 20kN "
                    "--length 50mm" +
                        pin_,
                    "p_peak_Pa") /
                  with_length,
              1, 1e-13);
  EXPECT_EQ(value("hinge-pressure --summary --pressure exact --load 20kN "
                  "--length 50mm" +
                      pin_,
                  "p_peak_Pa"),
            with_length);
}

TEST_F(Designer, NominalPressuresAreOfTheProjectedArea) {
  const double ball = 1e4 / (std::numbers::pi * 0.05 * 0.05);
  const double pin = 2e4 / (0.04 * 0.05);
  const std::string of_pin = pin_ + "--length 50mm ";
  for (const std::string program :
       {"hinge-angle --load ", "hinge-pressure --summary --load ",
        "hinge-joint --friction 0.1 --reaction "}) {
    const bool joint = program.starts_with("hinge-joint");
    EXPECT_NEAR(value(program + "1e4" + ball_ + (joint ? "--beta 90" : ""),
                      "p_nominal_Pa") /
                    ball,
                1, 1e-15)
        << program;
    EXPECT_NEAR(value(program + "2e4" + of_pin, "p_nominal_Pa") / pin, 1, 1e-15)
        << program;
  }
  // Peak, mean and nominal pressure of one contact are in one row.
  const std::string row =
      "hinge-joint --friction 0 --reaction 1e4 --beta 90" + ball_;
  EXPECT_GT(value(row, "p_peak_Pa"), value(row, "p_mean_Pa"));
  EXPECT_GT(value(row, "p_mean_Pa"), value(row, "p_nominal_Pa"));
}

TEST_F(Designer, WarningsOfWhatMaterialsDoNotBear) {
  folder_.write("pair.toml",
                "name = \"steel in polymer\"\n"
                "[inner]\nyoungs_modulus_GPa = 200\npoissons_ratio = 0.3\n"
                "[outer]\nname = \"polymer\"\nyoungs_modulus_GPa = 1\n"
                "poissons_ratio = 0.4\nlimit_pressure_MPa = 20\n");
  const std::string joint =
      " --joint ball --pair pair.toml --radius 10mm --clearance 100um ";
  const std::string limit =
      "MPa is above 20 MPa, the limit pressure of the "
      "outer body, polymer";
  const std::string linear = "5 % of the smaller Young's modulus";
  for (const std::string program :
       {"hinge-angle --load ", "hinge-pressure --summary --load ",
        "hinge-joint --friction 0.1 --beta 90 --reaction "}) {
    EXPECT_EQ(run(program + "100" + joint).err, "") << program;
    EXPECT_TRUE(warns(program + "100,2e4" + joint, limit)) << program;
    EXPECT_FALSE(warns(program + "2e3" + joint, linear)) << program;
    EXPECT_TRUE(warns(program + "1e5" + joint, linear)) << program;
  }
  EXPECT_TRUE(
      warns("hinge-angle --load 1 --joint ball --pair pair.toml "
            "--radius 10mm --clearance 0.01um",
            "relative clearance 1e-06 is below 1e-05"));
}

// The paper's limit of 92.5 deg for a rigid seat is beyond the limit of a ball
// with nu = 0.4 in it.
TEST_F(Designer, WarningsOfHalfAnglesBeyondTheLimit) {
  const std::string angle =
      "hinge-angle --joint ball --modulus-ratio 0 --poisson1 0.4 "
      "--limit-angle 130 --law tanh --x ";
  EXPECT_FALSE(warns(angle + "1", "limit half-angle of this joint"));
  EXPECT_TRUE(warns(angle + "1,100", "limit half-angle of this joint"));
}

// Walls carry wider contacts than infinite bodies do.
TEST_F(Designer, HalfAnglesOfWallsAreComparedWithTheirOwnLimit) {
  const std::string hip =
      "--joint data/joints/hip_cocr_uhmwpe.toml "
      "--set geometry.radial_clearance_um=0.2 ";
  for (const std::string program :
       {"hinge-angle --load 2000 ", "hinge-pressure --summary --load 2000 ",
        "hinge-joint --beta 90 --reaction 2000 "}) {
    EXPECT_FALSE(has_text(run(program + hip).err, "half-angle")) << program;
  }
  const auto beyond = folder_.run("hinge-angle --inverse --theta0 88 " + hip);
  EXPECT_EQ(beyond.status, 1);  // a row without a value
  EXPECT_TRUE(has_text(beyond.err, "half-angle 88 deg is beyond 87.3"));
}

// Independent solutions to three digits from all programs; a pin's stiffness
// refers to its length.
TEST_F(Designer, ApproachAndStiffness) {
  folder_.write("bush.toml",
                "name = \"bush\"\nkind = \"pin\"\n[geometry]\n"
                "radius_mm = 25\nradial_clearance_um = 25\nlength_mm = 30\n"
                "[materials.inner]\nyoungs_modulus_GPa = 210\n"
                "poissons_ratio = 0.3\n[materials.outer]\n"
                "youngs_modulus_GPa = 110\npoissons_ratio = 0.34\n"
                "[friction]\ncoefficient = 0.1\n"
                "[wall]\nbacking = \"held\"\n"
                "[[wall.layer]]\nthickness_mm = 5\n"
                "[[wall.layer]]\nthickness_mm = 25\n"
                "youngs_modulus_GPa = 210\npoissons_ratio = 0.3\n");
  const std::string hip = "data/joints/hip_cocr_uhmwpe";
  for (const auto& [program, ball] :
       {std::pair("hinge-angle --load ", ""),
        {"hinge-pressure --summary --pressure exact --load ", ""},
        {"hinge-joint --normal-force ", " --alpha 30"}}) {
    SCOPED_TRACE(program);
    const auto of = [&, program = program](const std::string& load,
                                           const std::string& joint) {
      return folder_.table(program + load + " --joint " + joint);
    };
    const auto expect = [](const CsvTable& table, double approach,
                           double stiffness, double digit) {
      EXPECT_NEAR(table.at("approach_m"), approach, 5e-8);
      EXPECT_NEAR(table.at("stiffness_N_per_m"), stiffness, digit);
    };
    expect(of("2000", hip + ".toml" + ball), 45.7e-6, 7.03e7, 5e4);
    expect(of("2000", hip + "_infinite.toml --law exact" + ball), 89.6e-6,
           3.00e7, 5e4);
    expect(of("60kN", "bush.toml"), 20.5e-6, 0.03 * 1.39e11, 1.5e7);
    // Without load, and of a pin in an infinite hole.
    EXPECT_EQ(of("0", hip + ".toml" + ball).text("approach_m"), "");
    const CsvTable hole = of("50kN", "data/joints/pin_joint.toml --law exact");
    EXPECT_EQ(hole.text("approach_m"), "");
    EXPECT_EQ(hole.text("stiffness_N_per_m"), "");
  }
}

// The same of whole motions: a wheel of 20 kg on a pin of 1 mm by 1 mm.
TEST_F(Designer, WarningsOfJointsOfMotions) {
  folder_.write("case.toml", R"(
name = "wheel"; gravity_m_per_s2 = [0, 0, -10]
run = { end_time_s = 0.1, output_step_s = 0.1 }
[carrier]; name = "ground"; fixed = true
[[body]]; name = "wheel"; mass_kg = 20; principal_inertia_kg_m2 = [2, 3, 3]
start = { rate_deg_per_s = 200 }
[body.hinge]; kind = "axis"; axis = [0, 1, 0]
[[body.hinge.joint]]; name = "tiny"; kind = "pin"
geometry = { radius_mm = 1, radial_clearance_um = 1, length_mm = 1 }
friction = { coefficient = 0.1 }
materials = { inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }, outer = { youngs_modulus_GPa = 1, poissons_ratio = 0.4, limit_pressure_MPa = 40 } }
)"_toml);
  const ProgramResult result =
      run("hinge-separation case.toml --output out.json");
  EXPECT_TRUE(has_text(result.err, "joint tiny: peak pressure"));
  EXPECT_TRUE(has_text(result.err,
                       "MPa is above 40 MPa, the limit pressure of the "
                       "outer body"));
  const std::string summary = folder_.read("out.json");
  EXPECT_TRUE(has_text(summary, "\"pressure_law\": \"exact\""));
  EXPECT_TRUE(has_text(summary, "\"half_angle_law\": \"fitted\""));
}

}  // namespace
}  // namespace contact::test::designer_test
