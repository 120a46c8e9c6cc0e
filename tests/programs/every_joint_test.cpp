// Every kind of friction with every kind of wall, through every door: programs,
// studies, cases, C and Python take what a joint file may say, and answer
// alike.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "c/door.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/every_joint.hpp"
#include "support/program.hpp"

namespace contact::test::every_joint_test {
namespace {

constexpr double reaction = 2000;  // N, at right angles to the slip axis
constexpr double rate = 0.4;       // rad/s

double moment_by_library(const JointText& joint) {
  const Joint made(parse_joint(joint.toml, joint.name));
  return made.solve({{reaction, 0, 0}, {0, 0, rate}, {0, 0, 1}})
      .friction_moment.norm();
}

// Each kind of friction of each kind of joint once, and each kind of wall:
// for programs that take one joint at a time.
std::vector<JointText> some_joints() {
  std::vector<JointText> some;
  const auto all = every_joint();
  constexpr std::size_t walls = 5;
  for (std::size_t i = 0; i < all.size(); i += walls) {
    some.push_back(all[i + (i / walls) % walls]);
  }
  return some;
}

bool has_law(const JointText& joint) {
  return joint.toml.find("[friction]\nlaw") != std::string::npos;
}

class EveryJoint : public testing::Test {
 protected:
  ProgramResult run(const JointText& joint, const std::string& command) const {
    folder_.write("joint.toml", joint.toml);
    SCOPED_TRACE(joint.name);
    return folder_.run_well(command);
  }

  ProgramFolder folder_;
};

TEST_F(EveryJoint, HingeJointAnswersAsTheLibrary) {
  for (const JointText& joint : every_joint()) {
    const auto result =
        run(joint,
            "hinge-joint --joint joint.toml --reaction 2kN --rate 0.4 "
            "--columns M_t_N_m" +
                std::string(joint.name[0] == 'b' ? " --beta 90" : ""));
    const CsvTable table(result.out);
    ASSERT_EQ(table.size(), 1u) << joint.name;
    // The program's directions are sines and cosines of degrees.
    EXPECT_NEAR(table.at("M_t_N_m") / moment_by_library(joint), 1, 1e-9)
        << joint.name;
  }
}

TEST_F(EveryJoint, CAnswersAsTheLibrary) {
  for (const JointText& joint : every_joint()) {
    contact_joint* made = nullptr;
    ASSERT_EQ(
        contact_joint_parse(joint.toml.c_str(), nullptr, nullptr, 0, &made),
        CONTACT_OK)
        << joint.name << contact_last_message();
    const CJoint owner(made, contact_joint_free);
    const contact_slip slip = {{reaction, 0, 0}, {0, 0, rate}, {0, 0, 1}};
    contact_solution s;
    ASSERT_EQ(contact_joint_solve(made, &slip, nullptr, &s), CONTACT_OK);
    EXPECT_EQ(std::hypot(s.friction_moment[0], s.friction_moment[1],
                         s.friction_moment[2]),
              moment_by_library(joint))
        << joint.name;
  }
}

// To the last digits of the norm of a vector, which NumPy sums otherwise.
TEST_F(EveryJoint, PythonAnswersAsTheLibrary) {
#ifndef CONTACT_PYTHON
  GTEST_SKIP() << "built without Python";
#else
  const auto all = every_joint();
  for (std::size_t i = 0; i < all.size(); ++i) {
    folder_.write(std::to_string(i) + ".toml", all[i].toml);
  }
  folder_.write("ask.py",
                "import numpy, libcontact\n"
                "for i in range(" +
                    std::to_string(all.size()) +
                    "):\n"
                    "    joint = libcontact.Joint.from_file(f'{i}.toml')\n"
                    "    s = joint.solve([2000, 0, 0], [0, 0, 0.4], "
                    "axis=[0, 0, 1])\n"
                    "    print(repr(float(numpy.linalg.norm("
                    "s.friction_moment))))\n");
  const auto answer = folder_.run(CONTACT_PYTHON " ask.py");
  ASSERT_EQ(answer.status, 0) << answer.err;
  std::istringstream moments(answer.out);
  for (const JointText& joint : all) {
    double moment = 0;
    moments >> moment;
    EXPECT_NEAR(moment / moment_by_library(joint), 1, 1e-15) << joint.name;
  }
#endif
}

TEST_F(EveryJoint, AnglePressureAndTableTakeIt) {
  for (const JointText& joint : some_joints()) {
    run(joint, "hinge-angle --joint joint.toml --load 2kN");
    run(joint, "hinge-pressure --joint joint.toml --load 2kN --summary");
    if (joint.name[0] == 'b') {
      run(joint, "hinge-table --joint joint.toml --theta0 20 --alpha 30");
    }
  }
}

TEST_F(EveryJoint, DutyAndIdentifyTakeIt) {
  folder_.write("cycle.csv",
                "time_s,R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,"
                "w_z_rad_per_s\n0,2e3,100,0,0,0,1\n0.3,3e3,0,0,0,0,0.5\n"
                "0.6,2e3,-100,0,0,0,-1\n0.9,3e3,0,0,0,0,-0.5\n");
  folder_.write("moments.csv",
                "R_N,b_deg,torque_N_m\n1000,90,2.1\n2000,90,4\n3000,90,6.1\n"
                "4000,90,8\n");
  folder_.write("moments_of_pins.csv",
                "R_N,torque_N_m\n1000,2.1\n2000,4\n3000,6.1\n4000,8\n");
  for (const JointText& joint : some_joints()) {
    run(joint, "hinge-duty --joint joint.toml --cycle cycle.csv");
    const std::string identify =
        "hinge-identify --joint joint.toml --sigma-rel 0.05 --data " +
        std::string(joint.name[0] == 'b' ? "moments.csv"
                                         : "moments_of_pins.csv");
    if (joint.friction == "dry" || joint.friction == "adhesive") {
      run(joint, identify);
    } else {
      folder_.run_ill(
          identify, 2,
          "hinge-identify: --fit f0,A requires dry friction; that of the "
          "joint is not dry\n");
    }
  }
}

TEST_F(EveryJoint, StudiesAnswerAsTheLibrary) {
  folder_.write("study.toml",
                "name = \"s\"\njoint = \"joint.toml\"\nseed = 1\n[load]\n"
                "reaction_kN = 2\nrate_rad_per_s = 0.4\n[[requirement]]\n"
                "quantity = \"M_t_N_m\"\nat_most = 1e6\nsuccess = 0.5\n"
                "[[dispersion]]\nkey = \"geometry.radial_clearance_um\"\n"
                "kind = \"uniform\"\nlow = 39\nhigh = 41\n");
  for (const JointText& joint : some_joints()) {
    std::filesystem::remove(folder_.path() / "j");
    run(joint, "hinge-study study.toml --runs 3 --journal j --csv rows.csv");
    const CsvTable rows(folder_.read("rows.csv"));
    ASSERT_EQ(rows.size(), 4u) << joint.name;  // and the nominal run
    for (const double moment : rows["M_t_N_m"]) {
      EXPECT_NEAR(moment / moment_by_library(joint), 1, 0.03) << joint.name;
    }
  }
}

// A body on the swinging joint runs for half a second and continues from a
// checkpoint; it must be rejected if the joints differ.
TEST_F(EveryJoint, CasesTakeIt) {
  for (const JointText& joint : some_joints()) {
    const bool ball = joint.name[0] == 'b';
    folder_.write(
        "case.toml",
        "name = \"c\"\ngravity_m_per_s2 = [0, 0, -9.81]\n[run]\nend_time_s = "
        "0.5\noutput_step_s = 0.1\n[carrier]\nname = \"ground\"\nfixed = true\n"
        "[[body]]\nname = \"arm\"\nmass_kg = 200\ncom_m = [1, 0, 0]\n"
        "principal_inertia_kg_m2 = [1, 20, 20]\n[body.hinge]\nkind = \"" +
            std::string(ball ? "ball\"\n" : "axis\"\naxis = [0, 1, 0]\n") +
            "carrier_point_m = [0, 0, 0]\njoint = [ { file = \"joint.toml\" } "
            "]\n");
    if (has_law(joint)) {
      folder_.write("joint.toml", joint.toml);
      const auto refused = folder_.run("hinge-separation case.toml");
      EXPECT_EQ(refused.status, 2) << joint.name;
      EXPECT_TRUE(has_text(refused.err,
                           "joints with another friction law are for "
                           "hinge-joint and hinge-duty"));
      continue;
    }
    run(joint,
        "hinge-separation case.toml --checkpoint k --checkpoint-every "
        "0.2 --output whole.json");
    run(joint, "hinge-separation case.toml --resume k --output again.json");
  }
}

// An FMU cannot print this later.
TEST_F(EveryJoint, FmusSayWhatTheyLeaveOut) {
  const std::pair<const char*, bool> left_out[] = {
      {"hinge-fmu data/joints/ball_stud.toml", false},
      {"hinge-fmu data/joints/relieved_bush.toml", false},
      {"sed 's/^coefficient.*/viscous_constant = 1e6/' "
       "data/joints/relieved_bush.toml >viscous.toml && hinge-fmu viscous.toml",
       true}};
  for (const auto& [command, is_said] : left_out) {
    const ProgramResult made = folder_.run(command);
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(has_text(made.err, "the relief of the ends is ignored"), is_said)
        << made.err;
    EXPECT_FALSE(has_text(made.err, "[seat] is left out")) << made.err;
  }
}

TEST_F(EveryJoint, MayNameAShippedPair) {
  folder_.run_well(
      "sed 's/^pair = .*/pair = \"steel_bronze\"/' "
      "data/joints/pin_joint.toml >named.toml");
  for (const std::string run : {"hinge-joint named.toml --reaction 1kN",
                                "hinge-fmu named.toml --output it.fmu"}) {
    EXPECT_EQ(folder_.run(run).status, 0) << run;
  }
}

TEST_F(EveryJoint, FmusSayWhatTheyHave) {
  const std::string run =
      "hinge-fmu data/joints/pin_joint.toml --output it.fmu";
  EXPECT_EQ(folder_.run_well(run).err,
            "hinge-fmu: note: wrote it.fmu: joint pin_joint: 24 inputs, 12 "
            "outputs, 11 parameters\n");
  EXPECT_EQ(folder_.run_well(run + " --quiet").err, "");
}

}  // namespace
}  // namespace contact::test::every_joint_test
