// The program hinge-joint, run as its users run it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace contact::test::hinge_joint_test {
namespace {

using Eigen::Vector3d;

const std::string example_1 =
    "hinge-joint --joint data/joints/paper_example_1.toml ";
const std::string example_2 =
    "hinge-joint --joint data/joints/paper_example_2.toml "
    "--reaction-xyz 1.122e6,3.23e5,0 --rate-xyz 0,0,1 ";
const std::string outer_loops = example_2 + "--outer 0,-0.026,0 --joints 2 ";
const std::string outer_loop = outer_loops + "--braking -6.5e-6 ";
const std::string beside = " --beside data/reference/paper_examples.csv";

Vector3d vector(const CsvTable& table, std::size_t row,
                const std::string& begin, const std::string& end) {
  return {table.at(row, begin + "_x_" + end),
          table.at(row, begin + "_y_" + end),
          table.at(row, begin + "_z_" + end)};
}

JointContact contact_of(const JointSpec& joint, const std::string& law) {
  return {joint.geometry,
          joint.pair(),
          *joint.friction,
          make_half_angle_law(law, joint.geometry.kind(), joint.pair(),
                              joint.half_angle_options),
          joint.make_pressure_law(),
          joint.conditions()};
}

JointSpec joint_file(const std::string& name) {
  return read_joint(std::filesystem::path(CONTACT_DATA_DIR) / "joints" /
                    (name + ".toml"));
}

// The numbers read back as the library's own doubles.
void expect_solution(const CsvTable& table, std::size_t row,
                     const JointSolution& s) {
  EXPECT_EQ(table.text(row, "status"), "ok");
  EXPECT_EQ(table.at(row, "evaluations"), s.evaluations);
  EXPECT_EQ(table.at(row, "residual"), s.residual);
  EXPECT_EQ(vector(table, row, "R", "N"), s.reaction);
  EXPECT_EQ(table.at(row, "R_n_N"), s.normal_force);
  EXPECT_EQ(Vector3d(table.at(row, "n_x"), table.at(row, "n_y"),
                     table.at(row, "n_z")),
            s.normal);
  EXPECT_EQ(vector(table, row, "R_t", "N"), s.friction_force);
  EXPECT_EQ(vector(table, row, "M_t", "N_m"), s.friction_moment);
  EXPECT_EQ(vector(table, row, "v", "m_per_s"), s.slip_velocity);
  EXPECT_EQ(table.at(row, "power_W"), s.power);
  EXPECT_EQ(table.at(row, "f"), s.force_coefficient);
  EXPECT_EQ(table.at(row, "f_R"), s.friction_direction.sin);
  EXPECT_EQ(table.at(row, "f_sliding"), s.sliding_coefficient);
  EXPECT_EQ(table.at(row, "f_spinning"), s.spinning_coefficient);
  EXPECT_EQ(table.at(row, "Abar"), s.adhesion_number);
  EXPECT_EQ(table.at(row, "load_parameter"), s.load_parameter);
  EXPECT_EQ(table.at(row, "theta0_deg"), s.half_angle / degree);
  EXPECT_EQ(table.at(row, "p_peak_Pa"), s.peak_pressure);
  EXPECT_EQ(table.at(row, "contact_area_m2"), s.contact_area);
  EXPECT_EQ(table.at(row, "b_deg"), s.reaction_angle() / degree);
  EXPECT_EQ(table.at(row, "g_deg"), s.friction_angle() / degree);
  EXPECT_EQ(table.at(row, "a_deg"), s.slip_axis_angle() / degree);
}

TEST(HingeJoint, BallRowsAreTheLibrarys) {
  const JointSpec file = joint_file("paper_example_1");
  const CsvTable table =
      ProgramFolder().table(example_1 +
                            "--law tanh,arctan --reaction-xyz 1e5,-2e4,3e4 "
                            "--rate-xyz 0.1,0.2,-3");
  ASSERT_EQ(table.size(), 2U);
  std::size_t row = 0;
  for (const std::string law : {"tanh", "arctan"}) {
    const Joint joint(contact_of(file, law));
    const Vector3d reaction(1e5, -2e4, 3e4);
    const Vector3d rate(0.1, 0.2, -3);
    const auto s = joint.solve({reaction, rate});
    ++row;
    EXPECT_EQ(table.text(row, "law"), law);
    EXPECT_EQ(table.text(row, "pressure"), "cosine");
    EXPECT_EQ(table.text(row, "state"), "sliding");
    EXPECT_EQ(vector(table, row, "w", "rad_per_s"), rate);
    expect_solution(table, row, s);
    EXPECT_DOUBLE_EQ(table.at(row, "M_t_N_m"), s.friction_moment.norm());
    EXPECT_DOUBLE_EQ(table.at(row, "f_M"),
                     s.friction_moment.norm() / (0.05 * reaction.norm()));
    EXPECT_DOUBLE_EQ(
        table.at(row, "M_traditional_N_m"),
        joint.solve_contact({reaction, rate}).friction_moment.norm());
  }
}

TEST(HingeJoint, AllLaws) {
  const CsvTable table = ProgramFolder().table(
      "hinge-joint --joint data/joints/pin_joint.toml --law all "
      "--pressure all --reaction 1e3");
  const std::size_t laws = half_angle_law_names().size() - 1;
  ASSERT_EQ(table.size(), laws * (pressure_law_names().size() - 1));
  EXPECT_EQ(table.text("law"), half_angle_law_names()[0]);
}

TEST(HingeJoint, PinRowsAreTheLibrarys) {
  const Joint joint(contact_of(joint_file("pin_joint"), "blend"));
  const std::string program =
      "hinge-joint --joint data/joints/pin_joint.toml --law blend ";
  const CsvTable xyz = ProgramFolder().table(
      program + "--reaction-xyz 1e3,2e3,3e3 --rate-xyz 0,4,0");
  expect_solution(xyz, 1, joint.solve({{1e3, 2e3, 3e3}, {0, 4, 0}}));
  const CsvTable sweep =
      ProgramFolder().table(program + "--reaction 0:2e4:5e3 --rate 2");
  ASSERT_EQ(sweep.size(), 5U);
  EXPECT_EQ(sweep.text("state"), "unloaded");
  EXPECT_EQ(sweep.text("a_deg"), "");
  for (std::size_t i = 2; i <= 5; ++i) {
    const double force = 5e3 * static_cast<double>(i - 1);
    expect_solution(sweep, i, joint.solve({{force, 0, 0}, {0, 0, 2}}));
  }
}

// R and b, R_n and a, and vectors describe the same states.
TEST(HingeJoint, WaysToGiveAStateAgree) {
  const ProgramFolder folder;
  const CsvTable contact =
      folder.table(example_1 + "--normal-force 1e4,2e5 --alpha -40,0,30,90");
  ASSERT_EQ(contact.size(), 8U);
  for (std::size_t row = 1; row <= 8; ++row) {
    EXPECT_EQ(contact.at(row, "R_n_N"), row <= 4 ? 1e4 : 2e5);
    const CsvTable reaction =
        folder.table(example_1 + "--reaction " + contact.text(row, "R_N") +
                     " --beta " + contact.text(row, "b_deg"));
    const CsvTable xyz = folder.table(
        example_1 + "--reaction-xyz " + contact.text(row, "R_x_N") + ',' +
        contact.text(row, "R_y_N") + ',' + contact.text(row, "R_z_N") +
        " --rate-xyz " + contact.text(row, "w_x_rad_per_s") + ',' +
        contact.text(row, "w_y_rad_per_s") + ',' +
        contact.text(row, "w_z_rad_per_s"));
    for (const char* column : {"R_n_N", "M_t_N_m", "theta0_deg", "f_M"}) {
      // b printed to a double loses a = 90 deg to sqrt(1e-16) at worst.
      EXPECT_NEAR(reaction.at(column) / contact.at(row, column), 1, 1e-7);
      EXPECT_NEAR(xyz.at(column) / contact.at(row, column), 1, 1e-12);
    }
    EXPECT_NEAR(xyz.at("a_deg"), contact.at(row, "a_deg"), 1e-5);
  }
}

// Swept values identify rows: they are printed with all digits.
// A joint's file without a flag before it; one that is an option's value is
// not a joint.
TEST(HingeJoint, TakesTheFileOfAJointAlone) {
  const std::string file = "data/joints/hip_cocr_uhmwpe.toml ";
  const std::string pair = "--pair data/materials/steel_bronze.toml";
  const ProgramFolder folder;
  const auto printed = [&](const std::string& command) {
    return folder.run_well(command).out;
  };
  for (const std::string program : {"hinge-joint ", "hinge-pressure "}) {
    const std::string load = program == "hinge-joint "
                                 ? "--reaction 1kN --beta 60 "
                                 : "--load 1kN --points 3 ";
    const std::string expected = printed(program + "--joint " + file + load);
    EXPECT_NE(expected, "");
    EXPECT_EQ(printed(program + file + load), expected);
    EXPECT_EQ(printed(program + load + file), expected);
  }
  EXPECT_EQ(
      printed("hinge-joint " + file +
              "data/joints/hip_cocr_uhmwpe_infinite.toml " +
              "--reaction 1kN --beta 90"),
      printed(
          "hinge-joint --joint " + file +
          "--joint data/joints/hip_cocr_uhmwpe_infinite.toml --reaction 1kN "
          "--beta 90"));
  const std::string sizes =
      " --radius 10mm --clearance 10um --reaction 1kN "
      "--beta 90 --law tanh";
  EXPECT_NE(printed("hinge-joint --joint ball --friction 0.1 " + pair + sizes),
            "");
}

TEST(HingeJoint, SweptInputsComeBackAsGiven) {
  const ProgramFolder folder;
  const auto check = [&](const std::string& force, const std::string& forces,
                         const std::string& angle, const std::string& angles,
                         const CsvTable& table) {
    const auto given_forces = csv_rows(forces);
    const auto given_angles = csv_rows(angles);
    std::size_t row = 0;
    for (const auto& f : given_forces[0]) {
      for (const auto& a : given_angles[0]) {
        ++row;
        ASSERT_LE(row, table.size());
        EXPECT_EQ(table.text(row, force), f);
        EXPECT_EQ(table.text(row, angle), a);
      }
    }
    EXPECT_EQ(table.size(), row);
  };
  std::string forces = "100";
  for (int f = 200; f <= 2000; f += 100) forces += ',' + std::to_string(f);
  check("R_N", forces, "b_deg", "30,50,60,80",
        folder.table(example_1 + "--reaction 100:2000:100 --beta 30,50,60,80"));
  const std::string tenths = "0.1,0.2,0.3,0.4,0.5,0.6,0.7";
  check("R_N", tenths, "b_deg", tenths,
        folder.table(example_1 + "--reaction 0.1:0.7:0.1 --beta 0.1:0.7:0.1"));
  check("R_n_N", tenths, "a_deg", "-50,-0.1,0,50,90",
        folder.table(example_1 + "--normal-force 0.1:0.7:0.1 "
                                 "--alpha=-50,-0.1,0,50,90"));
  check("R_N", tenths, "b_deg", "90",
        folder.table("hinge-joint --joint data/joints/pin_joint.toml "
                     "--law blend --reaction 0.1:0.7:0.1"));
  folder.write("points.csv", "R_N,b_deg\n100,50\n300,60\n");
  const CsvTable points = folder.table(example_1 + "--points points.csv");
  EXPECT_EQ(points.text("b_deg"), "50");
  EXPECT_EQ(points.text(2, "R_N"), "300");
  // Without load or slip there is no angle, given or not.
  const CsvTable rest =
      folder.table(example_1 + "--reaction 0,100 --beta 50 --rate 0");
  EXPECT_EQ(rest.text("b_deg"), "");
  EXPECT_EQ(rest.text(2, "b_deg"), "");
  EXPECT_EQ(rest.text(2, "R_N"), "100");
}

TEST(HingeJoint, OptionsDescribeTheJointOfAFile) {
  const ProgramFolder folder;
  const std::string state = " --law tanh --reaction 1e4 --beta 50";
  const std::string file =
      folder
          .run("hinge-joint --joint data/joints/hip_cocr_uhmwpe_infinite.toml" +
               state)
          .out;
  EXPECT_EQ(csv_rows(file).size(), 2U);
  EXPECT_EQ(folder
                .run("hinge-joint --joint ball --pair "
                     "data/materials/cocr_uhmwpe.toml --radius 14mm "
                     "--clearance 100um --inner-body body" +
                     state)
                .out,
            file);
  // Another friction: a coefficient alone has no adhesion.
  const CsvTable changed = folder.table(example_1 +
                                        "--friction 0.2 --reaction 1e4 "
                                        "--beta 50");
  EXPECT_EQ(changed.at("Abar"), 0);
  const CsvTable adhesive =
      folder.table(example_1 +
                   "--friction 0.2 --adhesion 1e6 --normal-force 1e4 "
                   "--alpha 50");
  EXPECT_NEAR(adhesive.at("Abar"), 1e6 * 0.0025 / (0.2 * 1e4), 1e-12);
}

// A ball pressed from behind: the library's joint with the exact laws.
TEST(HingeJoint, LoadedThroughTheBack) {
  const ProgramFolder folder;
  const std::string state = " --reaction-xyz 3e5,0,1e5 --rate-xyz 0,0,2 ";
  const CsvTable table = folder.table(
      example_1 + "--law exact --pressure exact,cosine --loading back:20" +
      state);
  JointSpec file = joint_file("paper_example_1");
  file.loading = InnerLoading::back(20 * degree);
  file.half_angle_law = file.pressure_law = "exact";
  const Joint joint(file);
  EXPECT_EQ(table.text("law"), "exact_back:20");
  EXPECT_EQ(table.text("pressure"), "exact_back:20");
  EXPECT_EQ(table.text(2, "pressure"), "cosine");
  expect_solution(table, 1, joint.solve({{3e5, 0, 1e5}, {0, 0, 2}}));
  const CsvTable centre =
      folder.table(example_1 + "--law exact --pressure exact" + state);
  EXPECT_GT(table.at("theta0_deg"), centre.at("theta0_deg"));
  const auto summary =
      folder.run(example_1 + "--law exact --loading back:20 --summary" + state);
  EXPECT_TRUE(has_text(summary.out, "law,exact_back:20,"));
}

// A ball in a liner: the library's joint with the laws of the walls, which are
// the joint's own.
TEST(HingeJoint, FiniteWalls) {
  const ProgramFolder folder;
  const std::string state = " --reaction-xyz 2e3,0,1e3 --rate-xyz 0,0,2 ";
  const std::string hip = "hinge-joint --joint data/joints/hip_cocr_uhmwpe";
  const CsvTable table = folder.table(hip + ".toml" + state);
  const JointSpec file = joint_file("hip_cocr_uhmwpe");
  const auto walls = file.conditions().walls.value();
  const auto ball = JointKind::ball;
  const Joint joint({file.geometry, file.pair(), *file.friction,
                     std::make_shared<ExactLaw>(ball, walls),
                     std::make_shared<ExactPressure>(ball, walls),
                     file.conditions()});
  EXPECT_EQ(table.text("law"), "exact");
  EXPECT_EQ(table.text("pressure"), "exact");
  expect_solution(table, 1, joint.solve({{2e3, 0, 1e3}, {0, 0, 2}}));
  const CsvTable infinite =
      folder.table(hip + "_infinite.toml --law exact --pressure exact" + state);
  EXPECT_LT(table.at("theta0_deg"), 0.95 * infinite.at("theta0_deg"));
  EXPECT_LT(table.at("M_t_N_m"), infinite.at("M_t_N_m"));
}

TEST(HingeJoint, ApproachAndStiffness) {
  const ProgramFolder folder;
  const std::string hip =
      "hinge-joint --joint data/joints/hip_cocr_uhmwpe_infinite.toml "
      "--normal-force 0,2000 --alpha 30 --law ";
  const CsvTable laws = folder.table(hip + "fitted,exact");
  EXPECT_EQ(laws.text(3, "law"), "fitted");
  EXPECT_EQ(laws.text(3, "approach_m"), "");
  EXPECT_NEAR(laws.at(4, "approach_m"), 89.6e-6, 5e-8);
  const CsvTable fitted = folder.table(hip + "fitted");
  EXPECT_EQ(fitted.names().back(), "q_mean_W_per_m2");
}

// Law, loading and pressure in front, as of the rows of solutions.
TEST(HingeJoint, LoopsNameTheirLaws) {
  const ProgramFolder folder;
  const std::string state = " --reaction 1e5 --beta 80 ";
  for (const char* loop :
       {"", "--trace", "--outer 0,0,0", "--outer 0,0,0 --trace"}) {
    const CsvTable file = folder.table(example_1 + state + loop);
    EXPECT_EQ(file.text("law"), "tanh") << loop;
    EXPECT_EQ(file.text("pressure"), "cosine") << loop;
    const CsvTable table = folder.table(example_1 + state + loop +
                                        " --law exact --pressure exact "
                                        "--loading back:20");
    EXPECT_EQ(table.names().at(0), "law") << loop;
    EXPECT_EQ(table.names().at(1), "pressure") << loop;
    for (std::size_t row = 1; row <= table.size(); ++row) {
      EXPECT_EQ(table.text(row, "law"), "exact_back:20") << loop;
      EXPECT_EQ(table.text(row, "pressure"), "exact_back:20") << loop;
    }
  }
}

TEST(HingeJoint, AxialForceOfAPinIsSaidToBeLeftOut) {
  const ProgramFolder folder;
  const std::string pin =
      "hinge-joint --joint data/joints/pin_joint.toml --rate-xyz 0,0,3 "
      "--reaction-xyz ";
  const ProgramResult oblique = folder.run_well(pin + "1e4,0,250");
  EXPECT_TRUE(has_text(oblique.err, "250 N of the reaction are ignored"));
  const ProgramResult normal = folder.run(pin + "1e4,0,0");
  EXPECT_FALSE(has_text(normal.err, "ignored"));
  EXPECT_EQ(oblique.out, normal.out);
}

// A viscous hinge: moments in proportion to the rate; no rest set.
TEST(HingeJoint, ViscousFriction) {
  const ProgramFolder folder;
  const std::string program =
      example_1 + "--viscous 1e5,1e-4 --normal-force 1e4 --alpha 20 --rate ";
  const CsvTable slow = folder.table(program + "1");
  const CsvTable fast = folder.table(program + "10");
  EXPECT_GT(slow.at("M_t_N_m"), 0);
  EXPECT_NEAR(fast.at("M_t_N_m") / slow.at("M_t_N_m"), 10, 1e-12);
  const CsvTable rest = folder.table(
      example_1 + "--viscous 1e5 --reaction-xyz 1e4,0,0 --moment-xyz 1,0,0");
  EXPECT_EQ(rest.text("utilisation"), "inf");
  EXPECT_EQ(rest.text("state"), "slips");

  // The same from a joint file; options take another friction instead.
  const std::string head =
      "name = \"bush\"\nkind = \"ball\"\n"
      "[geometry]\nradius_mm = 14\nradial_clearance_um = 100\n"
      "[materials.inner]\nyoungs_modulus_GPa = 210\npoissons_ratio = 0.3\n"
      "[materials.outer]\nyoungs_modulus_GPa = 0.8\npoissons_ratio = 0.4\n"
      "[friction]\n";
  folder.write("dry.toml", head + "coefficient = 0.1\n");
  folder.write("oil.toml", head +
                               "viscous_constant_kPa_s_per_m = 100\n"
                               "viscous_pressure_slope_s_per_m = 1e-4\n");
  const auto run = [&](const std::string& options) {
    return folder.run("hinge-joint " + options +
                      " --reaction 1e4 --beta 50 --rate 3");
  };
  const std::string oil = run("--joint oil.toml").out;
  EXPECT_EQ(csv_rows(oil).size(), 2U);
  EXPECT_EQ(run("--joint dry.toml --viscous 1e5,1e-4").out, oil);
  EXPECT_EQ(run("--joint oil.toml --friction 0.1").out,
            run("--joint dry.toml").out);
  EXPECT_TRUE(has_text(run("--joint oil.toml --adhesion 1e6").err,
                       "--adhesion requires --friction: the joint's "
                       "friction is not dry"));
}

TEST(HingeJoint, RestIsTheLibrarys) {
  const Joint joint(contact_of(joint_file("paper_example_1"), "tanh"));
  const Vector3d reaction(1e5, 2e4, 0);
  const Vector3d moment(300, 0, 500);
  const auto rest = joint.at_rest({reaction, moment});
  const ProgramFolder folder;
  const CsvTable table = folder.table(
      example_1 + "--reaction-xyz 1e5,2e4,0 --moment-xyz 300,0,500");
  EXPECT_EQ(table.text("state"), "holds");
  EXPECT_EQ(table.at("utilisation"), rest.utilisation);
  EXPECT_EQ(table.at("u_x"), rest.direction.x());
  EXPECT_EQ(table.at("w_x_rad_per_s"), rest.direction.x());
  EXPECT_EQ(table.at("R_n_N"), rest.slip.normal_force);
  EXPECT_FALSE(has_text(
      folder.run(example_1 + "--reaction-xyz 1e5,2e4,0 --moment-xyz 3e5,0,0")
          .out,
      "holds"));
  // A pin: |M| over the moment of sliding.
  const CsvTable pin = folder.table(
      "hinge-joint --joint data/joints/pin_joint.toml --law blend "
      "--reaction-xyz 1e4,0,0 --moment-xyz 0,0,5");
  EXPECT_NEAR(pin.at("utilisation"), 5 / pin.at("M_t_N_m"), 1e-14);
  EXPECT_NEAR(pin.at("M_t_z_N_m"), pin.at("M_t_N_m"), 1e-12);
  // No turning at all.
  const CsvTable still =
      folder.table(example_1 + "--reaction-xyz 1e5,2e4,0 --rate-xyz 0,0,0");
  EXPECT_EQ(still.text("state"), "resting");
  EXPECT_EQ(still.at("M_t_N_m"), 0);
}

TEST(HingeJoint, FormatsHoldTheSameNumbers) {
  const ProgramFolder folder;
  const std::string run = example_1 + "--reaction 1e4,2e5 --beta 20,90";
  const CsvTable csv = folder.table(run);
  const auto json =
      nlohmann::json::parse(folder.run(run + " --format json --jobs 3").out);
  ASSERT_EQ(json.size(), csv.size());
  for (std::size_t i = 0; i < csv.size(); ++i) {
    for (const std::string& name : csv.names()) {
      const auto& cell = json[i].at(name);
      if (cell.is_string()) {
        EXPECT_EQ(cell, csv.text(i + 1, name));
      } else {
        EXPECT_EQ(cell, csv.at(i + 1, name)) << name;
      }
    }
  }
  const CsvTable summary =
      folder.table(example_1 + "--reaction 1e4 --beta 20 --summary");
  ASSERT_EQ(summary.size(), csv.names().size());
  for (std::size_t i = 0; i < summary.size(); ++i) {
    EXPECT_EQ(summary.text(i + 1, "quantity"), csv.names()[i]);
    EXPECT_EQ(summary.text(i + 1, "value"), csv.text(csv.names()[i]));
  }
  // Turned: a line for each column, and the rule below the first.
  const std::string markdown = folder.run(run + " --format markdown").out;
  EXPECT_EQ(csv_rows(markdown).size(), 1 + csv.names().size());
}

// A line in, a line out; outputs of the program are inputs again.
TEST(HingeJoint, PointsAreAFilter) {
  const ProgramFolder folder;
  folder.write("points.csv",
               "note,R_N,b_deg\nfirst,1e5,67.6\n\"a, b\",2e5,200\n"
               "third,x,1\nlast,2e5,90\n");
  const ProgramResult result =
      folder.run(example_1 + "--points points.csv --jobs 2");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err,
            "ERROR: line 3: b_deg = 200 must be 0 to 180 deg\n"
            "ERROR: line 4: R_N = x must be a number, 0 to 1e+100 N\n");
  const CsvTable table(result.out);
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table.text("note"), "first");
  EXPECT_EQ(table.text(2, "law"), "ERROR");
  EXPECT_EQ(table.text(2, "M_t_N_m"), "");
  EXPECT_EQ(table.text(2, "note"), "\"a, b\"");
  EXPECT_EQ(table.text(4, "note"), "last");
  const CsvTable one = folder.table(example_1 + "--reaction 1e5 --beta 67.6");
  for (const std::string& name : one.names()) {
    EXPECT_EQ(table.text(name), one.text(name));
  }

  folder.write("again.csv",
               folder.run(example_1 + "--reaction 1e4,1e5 --beta 10,90").out);
  const CsvTable again = folder.table(example_1 + "--points again.csv");
  ASSERT_EQ(again.size(), 4U);
  for (std::size_t row = 1; row <= 4; ++row) {
    for (const char* name : {"R_n_N", "M_t_N_m", "theta0_deg"}) {
      EXPECT_EQ(again.text(row, name),
                again.text(row, std::string(name) + "_in"));
    }
  }

  folder.write("contact.csv", "a_deg,R_n_N\n30,2e5\n");
  EXPECT_EQ(
      folder.table(example_1 + "--points contact.csv").text("g_deg"),
      folder.table(example_1 + "--normal-force 2e5 --alpha 30").text("g_deg"));
  folder.write("rest.csv",
               "R_x_N,R_y_N,R_z_N,M_x_N_m,M_y_N_m,M_z_N_m\n"
               "1e5,2e4,0,300,0,500\n");
  EXPECT_EQ(
      folder.table(example_1 + "--points rest.csv").text("utilisation"),
      folder
          .table(example_1 + "--reaction-xyz 1e5,2e4,0 --moment-xyz 300,0,500")
          .text("utilisation"));
  folder.write("pin.csv", "R_N\n1e4\n");
  const std::string pin =
      "hinge-joint --joint data/joints/pin_joint.toml "
      "--law blend --rate 2 ";
  EXPECT_EQ(folder.run(pin + "--points pin.csv").out,
            folder.run(pin + "--reaction 1e4").out);
}

TEST(HingeJoint, DrawsTheMomentCurve) {
  const ProgramFolder folder;
  const ProgramResult result =
      folder.run(example_1 +
                 "--reaction 1e4:1e6:log20 --beta 30,90 --plot torque.svg "
                 "--output torque.csv");
  if (result.status == 0) {
    EXPECT_TRUE(has_text(folder.read("torque.svg"), "R as the normal force"));
  } else {
    EXPECT_TRUE(has_text(result.err, "gnuplot"));
  }
  EXPECT_EQ(csv_rows(folder.read("torque.csv")).size(), 41U);
}

// Every digit of the examples that was recomputed by another program in
// 30-digit arithmetic: half a unit of its last digit.
struct Digit {
  std::size_t row;
  const char* column;
  double value;
  double half_unit;
};

void expect_digits(const CsvTable& table, const std::vector<Digit>& digits) {
  for (const Digit& digit : digits) {
    EXPECT_NEAR(table.at(digit.row, digit.column), digit.value, digit.half_unit)
        << digit.column << ", row " << digit.row;
  }
}

TEST(PaperExamples, OneForward) {
  expect_digits(
      ProgramFolder().table(example_1 + "--normal-force 2e5 --alpha 30"),
      {{1, "load_parameter", 0.5460, 0.5e-4},
       {1, "theta0_deg", 42.593, 0.5e-3},
       {1, "Abar", 5, 1e-12},
       {1, "f", 0.85097, 0.5e-5},
       {1, "R_t_N", 1.7019e5, 0.5e1},
       {1, "g_deg", 40.397, 0.5e-3},
       {1, "R_N", 2.6261e5, 0.5e1},
       {1, "b_deg", 67.618, 0.5e-3}});
}

TEST(PaperExamples, OneInnerLoop) {
  const CsvTable table = ProgramFolder().table(
      example_1 + "--reaction 2.63e5 --beta 67.6 --trace");
  expect_digits(table, {{1, "g_deg", 0, 0},
                        {1, "a_deg", 22.40, 0.5e-2},
                        {1, "R_n_N", 2.63e5, 0.5e2},
                        {1, "Abar", 3.802, 0.5e-3},
                        {1, "load_parameter", 0.718, 0.5e-3},
                        {1, "theta0_deg", 45.85, 0.5e-2},
                        {2, "g_deg", 37.17, 0.5e-2},
                        {2, "a_deg", 28.57, 0.5e-2},
                        {2, "R_n_N", 2.096e5, 0.5e2},
                        {2, "Abar", 4.771, 0.5e-3},
                        {2, "load_parameter", 0.572, 0.5e-3},
                        {2, "theta0_deg", 43.14, 0.5e-2},
                        {3, "g_deg", 39.86, 0.5e-2},
                        {3, "a_deg", 29.77, 0.5e-2},
                        {3, "R_n_N", 2.019e5, 0.5e2},
                        {3, "Abar", 4.954, 0.5e-3},
                        {3, "load_parameter", 0.551, 0.5e-3},
                        {3, "theta0_deg", 42.70, 0.5e-2},
                        {table.size(), "g_deg", 40.37, 0.5e-2}});
  EXPECT_EQ(table.at(table.size(), "step"), table.size());
}

TEST(PaperExamples, TwoInnerLoops) {
  const CsvTable table =
      ProgramFolder().table(outer_loops + "--inner-steps 4,3 --trace");
  expect_digits(table, {{1, "g_deg", 0, 0},
                        {1, "R_n_N", 1.168e6, 0.5e3},
                        {1, "Abar", 2.141, 0.5e-3},
                        {1, "load_parameter", 3.187, 0.5e-3},
                        {1, "theta0_deg", 64.40, 0.5e-2},
                        {4, "step", 4, 0},
                        {4, "g_deg", 74.72, 0.5e-2},
                        {4, "R_n_N", 3.077e5, 0.5e2},
                        {4, "Abar", 8.126, 0.5e-3},
                        {4, "load_parameter", 0.840, 0.5e-3},
                        {4, "theta0_deg", 47.77, 0.5e-2},
                        {5, "round", 2, 0},
                        {5, "step", 1, 0}});
}

TEST(PaperExamples, TwoOuterLoop) {
  const ProgramFolder folder;
  const CsvTable cut = folder.table(outer_loop + "--inner-steps 4,3");
  expect_digits(cut, {{1, "M_N_m", 0, 0},
                      {1, "R_N", 1.1676e6, 0.5e2},
                      {2, "R_n_N", 2.783e5, 0.5e2},
                      {2, "M_N_m", 1.207e5, 0.5e2},
                      {2, "braking_deg_per_s2", -0.784, 0.5e-3},
                      {3, "R_n_N", 2.550e5, 0.5e2},
                      {3, "M_N_m", 1.156e5, 0.5e2},
                      {3, "braking_deg_per_s2", -0.751, 0.5e-3}});
  // Either way to the same end. M is 114915.01: at the tie between 1.1491
  // and 1.1492.
  const CsvTable full = folder.table(outer_loop);
  EXPECT_LT(full.size(), 10U);
  for (const CsvTable* table : {&cut, &full}) {
    const std::size_t last = table->size();
    expect_digits(*table, {{last, "R_n_N", 2.5214e5, 0.5e1},
                           {last, "g_deg", 77.52, 0.5e-2},
                           {last, "theta0_deg", 45.34, 0.5e-2},
                           {last, "M_N_m", 1.1491e5, 0.51e1},
                           {last, "braking_deg_per_s2", -0.747, 0.5e-3}});
  }
  // Friction taken from R: about twice too much.
  expect_digits(folder.table(example_2),
                {{1, "M_traditional_N_m", 2.26e5 / 2, 0.25e3}});
}

// The paper's printed numbers appear beside the computed ones, and agree within
// the tolerance that the file gives for each.
TEST(PaperExamples, BesidePrintedNumbers) {
  const ProgramFolder folder;
  const std::map<std::string, std::string> commands = {
      {"\"paper, example 1\" solution",
       example_1 + "--normal-force 2e5 --alpha 30"},
      {"\"paper, example 1\" trace",
       example_1 + "--reaction 2.63e5 --beta 67.6 --trace"},
      {"\"paper, example 2\" outer", outer_loop + "--inner-steps 4,3"},
      {"\"paper, example 2\" inner",
       outer_loops + "--inner-steps 4,3 --trace"}};
  std::map<std::string, CsvTable> tables;
  for (const auto& [name, command] : commands) {
    tables.emplace(name, folder.table(command + beside));
  }
  std::string text = folder.read("data/reference/paper_examples.csv");
  while (text.starts_with('#')) text.erase(0, text.find('\n') + 1);
  const CsvTable printed(text);
  EXPECT_EQ(printed.size(), 59U);
  for (std::size_t i = 1; i <= printed.size(); ++i) {
    const CsvTable& table =
        tables.at(printed.text(i, "joint") + ' ' + printed.text(i, "table"));
    const auto row = static_cast<std::size_t>(printed.at(i, "row"));
    const std::string column = printed.text(i, "column");
    const double value = printed.at(i, "value");
    EXPECT_EQ(table.at(row, column + "_printed"), value);
    EXPECT_NEAR(table.at(row, column), value, printed.at(i, "tolerance"))
        << printed.text(i, "joint") << ", " << printed.text(i, "table") << ' '
        << row << ", " << column;
  }
  // Cells are empty where the paper prints nothing.
  EXPECT_EQ(tables.at("\"paper, example 1\" trace").text(4, "g_deg_printed"),
            "");
}

TEST(HingeJoint, LoopsThatFailSaySo) {
  const ProgramFolder folder;
  const ProgramResult fails =
      folder.run(example_1 + "--friction 3 --reaction 1e5 --beta 50 --trace");
  EXPECT_EQ(fails.status, 1);
  EXPECT_TRUE(has_text(fails.err, "g is above b"));
  folder.run_well(example_1 + "--friction 3 --reaction 1e5 --beta 50");
  // The reaction grows with the moment without bound: there is no fixed point.
  const ProgramResult runs_away =
      folder.run(example_2 + "--outer 100,0,0 --joints 20");
  EXPECT_EQ(runs_away.status, 1);
  EXPECT_TRUE(has_text(runs_away.err, "outer loop"));
}

TEST(HingeJoint, RowsWithoutAValueSaySo) {
  const ProgramResult result = ProgramFolder().run(
      example_1 + "--law hertz --friction 0.1 --reaction 1e5,1e7 --beta 90");
  EXPECT_EQ(result.status, 1);
  const CsvTable table(result.out);
  EXPECT_EQ(table.text("status"), "ok");
  EXPECT_EQ(table.text(2, "status"), "out_of_range");
  EXPECT_EQ(table.text(2, "M_t_N_m"), "");
  EXPECT_TRUE(has_text(result.err, "rows without a value: 1"));
}

// The columns of --pv are the numbers of SlidingContact, and none without it.
TEST(HingeJoint, Pv) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-joint --joint data/joints/paper_example_1.toml --law exact "
      "--reaction-xyz 2e5,1e4,-3e4 --rate-xyz 0.1,1,-2 ";
  EXPECT_FALSE(has_text(folder.run(run).out, "pv_"));
  const CsvTable table = folder.table(run + "--pv");
  const Joint joint(contact_of(joint_file("paper_example_1"), "exact"));
  const Vector3d rate(0.1, 1, -2);
  const contact::SlidingContact sliding(
      joint.contact(), joint.solve({{2e5, 1e4, -3e4}, rate}), rate);
  const contact::SlidingContact::Peak& pv = sliding.largest_pv();
  EXPECT_EQ(table.at("pv_max_W_per_m2"), pv.value);
  EXPECT_EQ(table.at("pv_max_theta_deg"), pv.theta / degree);
  EXPECT_EQ(table.at("pv_max_x"), pv.place.x());
  EXPECT_EQ(table.at("pv_max_y"), pv.place.y());
  EXPECT_EQ(table.at("pv_max_z"), pv.place.z());
  EXPECT_EQ(table.at("pv_mean_W_per_m2"), sliding.pv_mean());
  EXPECT_EQ(table.at("pv_nominal_W_per_m2"), sliding.pv_nominal());
  EXPECT_EQ(table.at("q_max_W_per_m2"), sliding.largest_heat_flux().value);
  EXPECT_EQ(table.at("slip_coefficient"), sliding.slip_coefficient());
  const double rho = joint.contact().geometry().radius();
  // A division apart.
  EXPECT_NEAR(
      table.at("nominal_area_m2") * table.at("p_nominal_Pa") / table.at("R_N"),
      1, 1e-15);
  EXPECT_NEAR(table.at("pv_nominal_W_per_m2") /
                  (table.at("p_nominal_Pa") * rho * rate.norm()),
              1, 1e-15);
}

// The numbers equal Joint's, with their notes.
TEST(HingeJoint, ConfinesABallToItsSeat) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-joint --joint data/joints/hip_cup.toml --reaction-xyz ";
  const Joint joint(joint_file("hip_cup"));
  const ProgramResult steep =
      folder.run(run + "100,-1900,-700 --rate-xyz 0.2,0,1");
  const CsvTable table(steep.out);
  const JointSolution s = joint.solve(
      {.reaction = {100, -1900, -700}, .angular_velocity = {0.2, 0, 1}});
  const RimContact at = *joint.rims(s);
  ASSERT_FALSE(at.is_free);
  EXPECT_EQ(table.at("M_t_x_N_m"), s.friction_moment.x());
  EXPECT_EQ(table.at("F_z_N"), at.force.z());
  EXPECT_EQ(table.at("p_peak_Pa"), at.peak_pressure);
  EXPECT_EQ(table.at("upper_gap_m"), 0);
  // The head's projection is the cup's.
  EXPECT_NEAR(table.at("p_nominal_Pa") * pi * 0.014 * 0.014 /
                  Vector3d(100, -1900, -700).norm(),
              1, 1e-12);
  EXPECT_NE(steep.err.find("warning: the contact is at its upper rim. The "
                           "model neglects the free side face there, assumed "
                           "at 90 deg"),
            std::string::npos)
      << steep.err;
  const CsvTable rest =
      folder.table(run + "100,-1900,-700 --moment-xyz 0.1,0,0.3");
  const RestSolution held =
      joint.at_rest({.reaction = {100, -1900, -700}, .moment = {0.1, 0, 0.3}});
  EXPECT_EQ(rest.at("utilisation"), held.utilisation);
  EXPECT_EQ(rest.at("u_z"), held.direction.z());
  const ProgramResult out = folder.run(run + "0,1000,0 --rate-xyz 0,0,1");
  EXPECT_EQ(out.status, 1);
  EXPECT_NE(out.err.find("the ball leaves it"), std::string::npos) << out.err;
}

// A file has the rows of single states; without the seat, and under a normal
// force, the joint is the endless one.
TEST(HingeJoint, IsInItsSeatUnlessToldOtherwise) {
  const ProgramFolder folder;
  const std::string cup = "hinge-joint --joint data/joints/hip_cup.toml ";
  folder.write("v.csv",
               "R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s\n"
               "0,1000,3000,0,0,1\n0,2000,0,0,0,1\n");
  const ProgramResult points = folder.run(cup + "--points v.csv --pv");
  EXPECT_EQ(points.status, 1);
  const CsvTable rows(points.out);
  const CsvTable one =
      folder.table(cup + "--reaction-xyz 0,1000,3000 --rate-xyz 0,0,1 --pv");
  for (const char* column :
       {"M_t_N_m", "p_peak_Pa", "p_mean_Pa", "K_high", "pv_max_W_per_m2"}) {
    EXPECT_GT(one.at(column), 0) << column;
    EXPECT_EQ(rows.at(1, column), one.at(column)) << column;
    EXPECT_TRUE(std::isnan(rows.at(2, column))) << column;
  }
  EXPECT_TRUE(std::isnan(one.at("theta0_deg")));
  const Joint endless(joint_file("hip_cup").without_seat());
  const JointSolution s =
      endless.solve({.reaction = {0, 2000, 0}, .angular_velocity = {0, 0, 1}});
  const CsvTable without = folder.table(
      cup + "--reaction-xyz 0,2000,0 --rate-xyz 0,0,1 --without-seat");
  EXPECT_EQ(without.at("M_t_N_m"), s.friction_moment.norm());
  EXPECT_EQ(without.at("p_peak_Pa"), s.peak_pressure);
  EXPECT_EQ(std::ranges::count(without.names(), "K_high"), 0);
  const CsvTable pressed = folder.table(cup + "--normal-force 2kN --alpha 60");
  EXPECT_EQ(std::ranges::count(pressed.names(), "K_high"), 0);
  // A function of the load alone knows no rims.
  folder.run_ill(cup + "--kernel c", 2,
                 "hinge-joint: --kernel with a [seat] requires "
                 "--without-seat\n");
  EXPECT_NE(folder.run_well(cup + "--kernel c --without-seat")
                .out.find("friction_hold("),
            std::string::npos);
}

// The direction of a load is unknown of a normal force, and of an angle from
// the angular velocity in seats about another axis.
TEST(HingeJoint, SaysHowFarAContactGoesBeyondARimWhereItsLoadPoints) {
  const ProgramFolder folder;
  const std::string ring = "spherical_plain_bearing_ge50.toml ";
  const std::string cup = "hip_cup.toml ";
  const std::string xyz = "--reaction-xyz 0,2000,0 --rate-xyz 0,0,1 ";
  const std::pair<std::string, bool> runs[] = {
      {cup + xyz + "--without-seat", true},
      {cup + "--reaction 2000 --beta 90 --without-seat", false},
      {ring + "--reaction 2000 --beta 60 --without-seat", true},
      {cup + "--normal-force 2000 --alpha 10", false},
      {ring + "--normal-force 2000 --alpha 10", false}};
  for (const auto& [run, says] : runs) {
    const ProgramResult result =
        folder.run("hinge-joint --joint data/joints/" + run);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(
        result.err.find("in the direction of the load") != result.err.npos,
        says)
        << run << result.err;
  }
}

// Almost all of the contact lies nearer to the rim than pressures are told: of
// 100 N the mean is 2.6 MPa, and a largest pressure below that is none.
TEST(HingeJoint, SaysNoPressureBelowTheMeanOfARing) {
  const ProgramFolder folder;
  for (const char* beta : {"20", "60"}) {
    const CsvTable row = folder.table(
        std::string("hinge-joint --joint "
                    "data/joints/spherical_plain_bearing_ge50.toml "
                    "--reaction 100 --beta ") +
        beta);
    const double peak = row.at("p_peak_Pa");
    EXPECT_TRUE(std::isnan(peak) || peak >= row.at("p_mean_Pa")) << peak;
    EXPECT_GT(row.at("p_mean_Pa"), 1e6);
    EXPECT_GT(row.at("K_low"), 0);
  }
}

// The numbers equal FinitePin's, for a level pin with a relief too.
TEST(HingeJoint, TiltsAPinThatEnds) {
  const ProgramFolder folder;
  const std::string file = "data/joints/relieved_bush.toml";
  const std::string run = "hinge-joint --joint " + file + " --reaction 1e5 ";
  const CsvTable tilted =
      folder.table(run + "--tilt 0:0.1:0.05 --twist 0.02 --pv");
  const FinitePin pin(joint_file("relieved_bush"));
  ASSERT_EQ(tilted.size(), 3u);
  for (std::size_t row = 1; row <= 3; ++row) {
    const Eigen::Vector2d tilt(0.05 * (double(row) - 1), 0.02);
    const FinitePinSolution s = pin.solve({1e5, 0}, degree * tilt, 1);
    EXPECT_EQ(tilted.at(row, "p_peak_Pa"), s.contact.peak_pressure);
    EXPECT_EQ(tilted.at(row, "z_low_m"), s.contact.low);
    EXPECT_EQ(tilted.at(row, "M_t_z_N_m"), s.moment.z());
    EXPECT_NEAR(tilted.at(row, "tilt_x_deg"), tilt.x(), 1e-15);
    EXPECT_NEAR(tilted.at(row, "pv_max_W_per_m2"),
                s.contact.peak_pressure * 0.02, 1e-6);
  }
  const CsvTable placed = folder.table(run + "--load-at 10mm");
  EXPECT_NEAR(placed.at("M_middle_y_N_m"), 1000, 1e-9);
  EXPECT_EQ(placed.at("load_at_m"), 0.01);
  // Sliding along the axis alone there is no friction about it.
  const CsvTable slides =
      folder.table(run + "--tilt 0 --rate 0 --slide 0.1 --pv");
  const FinitePinSolution along = pin.solve({1e5, 0}, {0, 0}, {0, 0.1});
  EXPECT_EQ(slides.at("R_t_z_N"), along.axial_friction_force);
  EXPECT_LT(along.axial_friction_force, 0);
  EXPECT_EQ(slides.at("M_t_z_N_m"), 0);
  EXPECT_EQ(slides.at("pv_max_W_per_m2"), 0.1 * along.contact.peak_pressure);
  const std::string note = "warning: the relief of the ends is ignored";
  EXPECT_EQ(folder.run(run + "--tilt 0").err, "");
  EXPECT_EQ(folder.run(run).err, "");
  const CsvTable level = folder.table(run);
  const FinitePinState at = pin.solve({1e5, 0}, {0, 0}, 1).contact;
  EXPECT_EQ(level.at("p_peak_Pa"), at.peak_pressure);
  EXPECT_EQ(level.at("z_high_m"), at.high);
  // The sum of the pressures over their area.
  EXPECT_NEAR(level.at("p_mean_Pa"), at.pressure_moment / at.area_moment,
              1e-9 * at.peak_pressure);
  EXPECT_TRUE(std::isnan(level.at("theta0_deg")));
  for (const std::string& other :
       {run + "--equivalent", "hinge-angle --joint " + file + " --load 1e5",
        "hinge-pressure --joint " + file + " --load 1e5"}) {
    EXPECT_NE(folder.run(other).err.find(note), std::string::npos) << other;
  }
  folder.run_ill(run + "--tilt 9", 1,
                 "hinge-joint: warning: the load needs a half-angle along the "
                 "pin beyond 80 deg, or beyond the limit of the "
                 "pair\nhinge-joint: warning: rows without a value: 1; the "
                 "half-angle law or the pressure law is undefined there\n");
}

}  // namespace
}  // namespace contact::test::hinge_joint_test
