// hinge-identify: forms of data, warnings, files of residuals and pictures.
// Numbers as in tests/identify/identify_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "support/program.hpp"

namespace contact::test::hinge_identify_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string rig = "hinge-identify --joint data/duty/torque_rig.toml ";
const std::string wide = rig + "--data data/duty/torque_rig.csv ";

double cell(const ProgramResult& result, const std::string& quantity,
            const std::string& column = "value") {
  EXPECT_EQ(result.status, 0) << result.err;
  const CsvTable table(result.out);
  return table.at(table.row_of(quantity), column);
}

TEST(HingeIdentify, PrintsTheFit) {
  const ProgramResult result = ProgramFolder().run(wide + "--profile");
  EXPECT_THAT(result.err, Not(HasSubstr("cannot tell")));
  EXPECT_NEAR(cell(result, "f0"), 0.1204223949, 1e-8);
  EXPECT_NEAR(cell(result, "A_Pa", "standard_error"), 6339.644267, 0.01);
  EXPECT_NEAR(cell(result, "A_Pa", "profile_low"), 980714.2344, 10);
  EXPECT_NEAR(cell(result, "correlation_f0_A"), -0.9243180636, 1e-6);
  EXPECT_GT(cell(result, "f0_effective"), 0.14);
}

// A row for each joint, with its own fit.
TEST(HingeIdentify, SeveralJoints) {
  const ProgramFolder folder;
  const std::string key = "geometry.radial_clearance_um";
  const CsvTable all =
      folder.table(wide + "--set " + key + "=20,60 --residuals r.csv");
  ASSERT_EQ(all.size(), 2u);
  const std::size_t residuals = CsvTable(folder.read("r.csv")).size();
  for (const std::size_t row : {1u, 2u}) {
    const std::string value = row == 1 ? "20" : "60";
    const ProgramResult one = folder.run_well(wide + "--set " + key + '=' +
                                              value + " --residuals one.csv");
    EXPECT_EQ(all.text(row, key), value);
    for (const std::string column : {"value", "standard_error", "high"}) {
      const std::string name = column == "value" ? "A_Pa" : "A_Pa_" + column;
      EXPECT_EQ(all.at(row, name), cell(one, "A_Pa", column));
    }
    EXPECT_EQ(2 * CsvTable(folder.read("one.csv")).size(), residuals);
  }
}

// Moments that hinge-joint prints, with its columns, give its friction back.
TEST(HingeIdentify, ReadsWhatHingeJointPrints) {
  const ProgramFolder folder;
  for (const std::string joint : {"pin_joint", "paper_example_1"}) {
    const std::string name = "--joint data/joints/" + joint + ".toml ";
    const bool pin = joint == "pin_joint";
    const ProgramResult result =
        folder.run("hinge-joint " + name +
                   "--friction 0.2 --adhesion 3e6 --reaction "
                   "1e4:1e5:log8 " +
                   (pin ? "" : "--beta 50,80 ") + "| hinge-identify " + name +
                   "--data - --sigma-rel 0.01");
    EXPECT_NEAR(cell(result, "f0"), 0.2, 1e-8) << joint;
    EXPECT_NEAR(cell(result, "A_Pa"), 3e6, 0.1) << joint;
  }
}

// Fits use the joint without its seat: a note reports how far a load reaches
// beyond a rim if its direction in the seat is known.
TEST(HingeIdentify, SaysWhereALoadReachesARim) {
  const ProgramFolder folder;
  const std::string vectors =
      "R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s,torque_N_m";
  const std::string angles = "R_N,b_deg,torque_N_m";
  // In the middle of the cup, and square to the ring, it reaches none.
  const std::tuple<std::string, std::string, std::string, bool> runs[] = {
      {"hip_cup", vectors, "0,700,-700,0,1,1,0.8\\n0,0,-2000,0,1,1,1.2\\n",
       true},
      {"hip_cup", vectors, "0,-700,700,1,0,0,0.8\\n0,-70,70,1,0,0,0.08\\n",
       false},
      {"hip_cup", angles, "1000,90,0.8\\n2000,60,1.2\\n", false},
      {"spherical_plain_bearing_ge50", angles, "1000,90,3\\n2000,60,6\\n",
       true}};
  for (const auto& [joint, columns, rows, says] : runs) {
    const ProgramResult result =
        folder.run("printf '" + columns + "\\n" + rows +
                   "' | hinge-identify --joint data/joints/" + joint +
                   ".toml --data - --sigma-rel 0.01 --fit f0");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err.find("deg beyond a rim of its seat in the direction "
                              "of the load") != result.err.npos,
              says)
        << joint << ' ' << rows << result.err;
  }
}

TEST(HingeIdentify, ErrorsOfTheData) {
  const ProgramFolder folder;
  const std::string data =
      "printf 'R_N,b_deg,rate_rad_per_s,torque_N_m\\n1e3,90,1,3\\n"
      "4e3,90,2,12\\n1e4,90,3,31\\n' | " +
      rig + "--data - --fit f0 ";
  EXPECT_EQ(cell(folder.run(data + "--sigma-abs 1"), "dof"), 2);
  folder.run(data + "--sigma-abs 3 --sigma-rel 0.1 --residuals r.csv");
  const CsvTable residuals(folder.read("r.csv"));
  EXPECT_EQ(residuals.text(2, "rate_rad_per_s"), "2");
  EXPECT_NEAR(residuals.at(3, "sigma_N_m"), std::hypot(3, 3.1), 1e-14);
}

// A seal's 0.65 N m in addition to the torques of the rig: a note reports it,
// and a fit of the drag finds it to two standard errors.
TEST(HingeIdentify, FindsADrag) {
  const ProgramFolder folder;
  const std::string seal =
      "sed '/^[0-9]/!d' data/duty/torque_rig.csv | awk -F, -v OFS=, "
      "'BEGIN {print \"R_N,b_deg,torque_N_m,sigma_N_m\"} {$3 += 0.65; print}' "
      "| " +
      rig + "--data - ";
  EXPECT_THAT(folder.run_well(seal).err,
              HasSubstr("residuals are 1.58 times as large as sigma suggests, "
                        "chi2/dof 2.51: "));
  const ProgramResult found = folder.run_well(seal + "--fit f0,A,drag");
  EXPECT_THAT(found.err, Not(HasSubstr("residuals")));
  EXPECT_NEAR(cell(found, "drag_N_m"), 0.65, 2 * 0.07);
  EXPECT_NEAR(cell(found, "f0"), 0.12, 2 * 6e-4);
}

TEST(HingeIdentify, WarnsOfWhatDataCannotTell) {
  const ProgramFolder folder;
  const auto says = [&](const std::string& command) {
    return folder.run_well(command).err;
  };
  const auto set = [](const std::string& name) {
    return "grep '^set,\\|^" + name + ",' data/reference/duty/identify.csv | " +
           rig + "--data - ";
  };
  EXPECT_THAT(
      says(set("narrow")),
      HasSubstr(
          "hinge-identify: warning: the data do not determine the parameters: "
          "condition 116, largest over smallest load 1.15, correlation "
          "-0.9999; vary the load more, or use f0_effective\n"));
  EXPECT_THAT(says(set("wide_outliers")),
              HasSubstr("4 of 40 residuals are beyond 5 standard errors by "
                        "their median; --huber reduces their weight\n"));
  EXPECT_THAT(says(set("wide_outliers") + "--huber"),
              Not(HasSubstr("residuals")));
  EXPECT_THAT(
      says(wide + "--fit f0,A,clearance"),
      HasSubstr("its interval is skewed: use the interval of --profile, "
                "or measure the clearance\n"));
  EXPECT_THAT(says("printf 'R_N,b_deg,torque_N_m\\n1e3,90,2\\n4e3,90,9\\n"
                   "1e4,90,26\\n2e4,90,55\\n' | " +
                   rig + "--data - --sigma-rel 0.01"),
              HasSubstr("A is held at 0: the data would give a negative value; "
                        "intervals of the other parameters treat it as known "
                        "and are too short, intervals of --profile are not\n"));
}

// Moments of a pin with f0 = 0.12 and A = 1 MPa, with errors of 1 %.
constexpr const char* pin_moments =
    "R_N,torque_N_m\n"
    "2000,9.48363\n2341.6,10.6911\n2741.5,12.2876\n3209.6,13.4786\n"
    "3757.8,15.5913\n4399.5,17.2986\n5150.9,20.3108\n6030.5,22.8842\n"
    "7060.4,26.3524\n8266.2,29.4929\n9677.9,33.9788\n11331,38.5862\n"
    "13266,43.9816\n15531,50.8805\n18184,57.6067\n21289,66.8478\n"
    "24925,77.7897\n29182,89.1356\n34165,102.454\n40000,121.578\n";

// The refits of a profile that fail on the way to A's end have no clearance any
// more: f0 has both ends, A has one.
TEST(HingeIdentify, WarnsOfProfilesWithoutAnEnd) {
  const ProgramFolder folder;
  folder.write("d.csv", pin_moments);
  const ProgramResult result = folder.run_well(
      "hinge-identify --joint data/joints/pin_joint.toml --data d.csv "
      "--sigma-rel 0.01 --fit f0,A,clearance --profile");
  const CsvTable table(result.out);
  EXPECT_LT(table.at("profile_high"), 0.13);
  EXPECT_GT(table.at("profile_low"), 0.11);
  EXPECT_EQ(table.text(2, "profile_high"), "");
  EXPECT_THAT(result.err,
              HasSubstr("hinge-identify: warning: --profile: the high end of "
                        "A not found: fits of the other parameters leave their "
                        "range or do not converge\n"));
}

// The contacts belong to the data's states, with the fitted joint.
TEST(HingeIdentify, WarnsOfContactsThatLeaveTheTheory) {
  const ProgramFolder folder;
  folder.write("d.csv", pin_moments);
  const std::string pin =
      "hinge-identify --joint data/joints/pin_joint.toml --data d.csv "
      "--sigma-rel 0.01 ";
  EXPECT_THAT(folder.run(pin).err, Not(HasSubstr("peak pressure")));
  EXPECT_THAT(
      folder.run(pin + "--set materials.outer.limit_pressure_MPa=40").err,
      HasSubstr("hinge-identify: warning: peak pressure 50.35 MPa is above 40 "
                "MPa, the limit pressure of the outer body"));
}

TEST(HingeIdentify, Pictures) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP();
  folder.run_well(wide + "--plot p.svg");
  const std::string picture = folder.read("p.svg");
  for (const char* text :
       {"fit, β = 60°", "fit, β = 90°", "measured", "residual, σ", "β, deg"}) {
    EXPECT_TRUE(has_text(picture, text)) << text;
  }
  // All data have one rate: no panel.
  EXPECT_FALSE(has_text(picture, "|Δω|, rad/s"));
}

}  // namespace
}  // namespace contact::test::hinge_identify_test
