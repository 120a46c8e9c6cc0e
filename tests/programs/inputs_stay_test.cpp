// No program overwrites a file that it has read, under any name.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"

namespace contact::test::inputs_stay_test {
namespace {

class InputsStay : public testing::Test {
 protected:
  InputsStay() {
    copy("joints/pin_joint.toml", "j.toml");
    copy("joints/paper_example_2.toml", "ball.toml");
    copy("materials/steel_bronze.toml", "pair.toml");
    copy("duty/torque_rig.csv", "m.csv");
    copy("reference/duty/cycle_hip_in.csv", "cycle.csv");
    folder_.write("points.csv", "theta0_deg,alpha_deg\n45,30\n");
    folder_.write("states.csv", "R_N,beta_deg\n1000,90\n");
    folder_.write("s.toml",
                  "name = 's'\njoint = 'j.toml'\nruns = 5\n"
                  "load = { reaction_kN = 10 }\nquantities = 'M_t_N_m'\n"
                  "[[dispersion]]\nkey = 'load.reaction_kN'\n"
                  "kind = 'uniform'\nlow = 9\nhigh = 11\n");
    folder_.run_well(
        "sed 's|\"../joints/paper_example_2.toml\"|\"ball.toml\"|' "
        "data/cases/two_stage_turn.toml > case.toml");
  }

  void copy(const std::string& from, const std::string& to) const {
    folder_.run_well("sed 's|\"../materials/|\"data/materials/|' data/" + from +
                     " > " + to);
  }

  // `run` is refused because of its output, and changes nothing.
  void refuses(const std::string& run, const std::string& output,
               const std::string& input) const {
    const auto files = folder_.files();
    const std::string before = folder_.read(input);
    const ProgramResult result = folder_.run(run + ' ' + output);
    EXPECT_EQ(result.status, 2) << run << ' ' << output;
    EXPECT_EQ(result.out, "");
    // A file that is named by another one has its place in front.
    EXPECT_TRUE(result.err.ends_with(": " + output +
                                     " must be another file than " + input +
                                     ", which is read\n"))
        << result.err;
    EXPECT_TRUE(folder_.read(input) == before) << run << ' ' << output;
    EXPECT_EQ(folder_.files(), files);
  }

  ProgramFolder folder_;
};

const std::string identify =
    "hinge-identify --joint data/duty/torque_rig.toml --data m.csv";
const std::string table = "hinge-table --points points.csv";
const std::string separate =
    "hinge-separation case.toml --end-time 0.2 --no-clearance";

TEST_F(InputsStay, OfEveryProgram) {
  refuses(identify, "--residuals m.csv", "m.csv");
  refuses(identify, "--output m.csv", "m.csv");
  refuses(
      "hinge-duty --joint data/reference/duty/cycle_hip.toml --euler zxy "
      "--cycle cycle.csv",
      "--states cycle.csv", "cycle.csv");
  refuses(table, "--output points.csv", "points.csv");
  const std::string states = "hinge-joint --joint j.toml --friction 0.1 ";
  refuses(states + "--points states.csv", "--output states.csv", "states.csv");
  refuses(states + "--reaction 1000 --beside m.csv", "--output m.csv", "m.csv");
  refuses("hinge-angle --load 5 --joint j.toml", "--output j.toml", "j.toml");
  refuses(
      "hinge-pressure --joint ball --radius 50mm --clearance 50um "
      "--load 1e4 --pair pair.toml",
      "--output pair.toml", "pair.toml");
}

TEST_F(InputsStay, OfCasesAndStudies) {
  refuses(separate, "--output case.toml", "case.toml");
  refuses(separate, "--output ball.toml", "ball.toml");
  refuses("hinge-study s.toml", "--csv j.toml", "j.toml");
  refuses("hinge-fmu case.toml", "--output ball.toml", "ball.toml");
  refuses("hinge-study s.toml", "--output s.toml", "s.toml");
  // Files to resume from, and to merge.
  folder_.run_well(separate +
                   " --checkpoint k --checkpoint-every 0.1 "
                   "--output o.json");
  refuses(separate + " --resume k", "--output k", "k");
  ASSERT_LE(folder_.run("hinge-study s.toml --journal part").status, 1);
  refuses("hinge-study s.toml --merge part", "--csv part", "part");
}

TEST_F(InputsStay, UnderOtherNames) {
  folder_.run_well(
      "ln -s points.csv soft.csv; ln points.csv hard.csv; "
      "mkdir sub; ln -s .. sub/up");
  for (const std::string name :
       {"./points.csv", "sub/../points.csv", "soft.csv", "hard.csv",
        "sub/up/points.csv", "\"$PWD/points.csv\""}) {
    const std::string before = folder_.read("points.csv");
    const ProgramResult result = folder_.run(table + " --output " + name);
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_TRUE(result.err.ends_with(
        " must be another file than points.csv, which is read\n"))
        << result.err;
    EXPECT_EQ(folder_.read("points.csv"), before) << name;
  }
  folder_.run_ill(
      "hinge-table --points - --output hard.csv < points.csv", 2,
      "hinge-table: --output hard.csv must be another file than standard "
      "input, which is read\n");
}

// Inputs may be read twice, and by devices and pipes nothing is lost.
TEST_F(InputsStay, OthersMayBeWritten) {
  for (const std::string& run :
       {table + " --output o.csv", table + " --output o.csv",
        std::string("hinge-table --points /dev/null --output /dev/null; "
                    "test $? -eq 2"),
        std::string("cat points.csv | hinge-table --points - --output "
                    "points.csv")}) {
    folder_.run_well(run);
  }
}

}  // namespace
}  // namespace contact::test::inputs_stay_test
