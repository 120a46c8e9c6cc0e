// Numbers with units at the command line are those without.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "support/program.hpp"

namespace contact::test {
namespace {

struct Same {
  std::string run;
  std::string with;
  std::string without;
};
std::ostream& operator<<(std::ostream& to, const Same& same) {
  return to << same.run << same.with;
}

const std::string hip = " --joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
const std::string pair = " --pair data/materials/steel_bronze.toml ";
const std::string ball = pair + "--joint ball --clearance 50um --radius ";

// All three in mm, as one may slip: a ball of 28 m, which is said.
TEST(LengthOptions, MetresThatAreHardlyMeant) {
  const ProgramFolder folder;
  const std::string angle =
      "hinge-angle --joint ball --pair data/materials/cocr_uhmwpe.toml "
      "--backing rigid --load 2000 ";
  const auto said = [&](const std::string& size) {
    return folder.run_well(angle + size).err;
  };
  EXPECT_EQ(said("--diameter 28 --clearance 0.1 --wall 8"),
            "hinge-angle: note: --diameter 28 is 28 m; 28mm is 28 mm\n"
            "hinge-angle: note: --wall 8 is 8 m; 8mm is 8 mm\n");
  EXPECT_EQ(said("--radius 14 --clearance 1e-3 --wall 1"),
            "hinge-angle: note: --radius 14 is 14 m; 14mm is 14 mm\n");
  EXPECT_EQ(said("--diameter 28mm --clearance 0.1mm --wall 8mm"), "");
  EXPECT_EQ(said("--diameter 2 --clearance 1e-3 --wall 0.5"), "");
  EXPECT_EQ(said("--diameter 28m --clearance 0.1 --wall 8m"), "");
}

TEST(NumberOptions, ThousandsThatAreLists) {
  const ProgramFolder folder;
  const auto said = [&](const std::string& program, const std::string& loads) {
    return folder
        .run_well(program + loads +
                  " --joint data/joints/hip_cocr_uhmwpe.toml ")
        .err;
  };
  const std::string angle = "hinge-angle --load ";
  const std::string joint = "hinge-joint --beta 90 --reaction ";
  for (const char* loads : {"2,000", "1,500", "12,500", "1,000,000"}) {
    EXPECT_TRUE(has_text(said(angle, loads),
                         std::string("hinge-angle: note: --load ") + loads +
                             " is a list of numbers: "
                             "thousands have no commas here\n"));
  }
  EXPECT_TRUE(has_text(said(joint, "2,500"), "note: --reaction 2,500 is"));
  for (const char* loads :
       {"500,2000", "100,200,300", "100,200", "2,5", "1,20,300", "0,500"}) {
    EXPECT_EQ(said(angle, loads), "") << loads;
  }
}

class UnitOptions : public testing::TestWithParam<Same> {};

TEST_P(UnitOptions, AreTheSameNumbers) {
  const auto& [run, with, without] = GetParam();
  const ProgramFolder folder;
  const auto expected = folder.run(run + without);
  ASSERT_EQ(expected.status, 0) << run << without << '\n' << expected.err;
  const auto result = folder.run(run + with);
  EXPECT_EQ(result.status, 0) << run << with << '\n' << result.err;
  EXPECT_EQ(result.out, expected.out) << run << with;
}

INSTANTIATE_TEST_SUITE_P(
    Angle, UnitOptions,
    testing::Values(
        Same{"hinge-angle --load ", "0.1kN:2kN:log3" + hip,
             "100:2000:log3" + hip},
        Same{"hinge-angle --inverse --theta0 ", "0:40deg:20deg" + hip,
             "0:40:20" + hip},
        Same{"hinge-angle --load 1e4 ", ball + "5cm", ball + "0.05"},
        Same{"hinge-angle --load 1e4 ", ball + "2in", ball + "50.8mm"},
        Same{"hinge-angle --law tanh --load 2000 --limit-angle ",
             "1.5707963267948966rad" + hip, "90" + hip},
        Same{"hinge-angle --law exact --load 2000 --loading ",
             "back:30deg" + hip, "back:30" + hip}));

INSTANTIATE_TEST_SUITE_P(Pressure, UnitOptions,
                         testing::Values(Same{
                             "hinge-pressure --summary --load ", "2kN" + hip,
                             "2000" + hip}));

INSTANTIATE_TEST_SUITE_P(
    Joint, UnitOptions,
    testing::Values(
        Same{"hinge-joint" + hip, "--reaction 2kN --beta 30deg --rate 60rpm",
             "--reaction 2000 --beta 30 --rate 6.283185307179586"},
        Same{"hinge-joint" + hip, "--normal-force 2kN --alpha 30deg",
             "--normal-force 2000 --alpha 30"},
        Same{"hinge-joint" + hip, "--reaction-xyz 1kN,20N,0 --rate-xyz 0,0,1",
             "--reaction-xyz 1000,20,0 --rate-xyz 0,0,1"},
        Same{"hinge-joint" + hip,
             "--reaction-xyz 1e3,20,0 --moment-xyz 0,2N*m,500N_mm",
             "--reaction-xyz 1e3,20,0 --moment-xyz 0,2,0.5"},
        Same{"hinge-joint --reaction 1e3 --beta 90" + hip + "--friction 0.1 ",
             "--adhesion 0.5kPa", "--adhesion 500"},
        Same{"hinge-joint --reaction 1e3 --beta 90" + hip,
             "--viscous 2MPa*s/m,0.1s/m", "--viscous 2e6,0.1"},
        Same{"hinge-joint --reaction 1e3 --friction 0.1 --joint pin --radius "
             "25mm --clearance 25um --backing rigid" +
                 pair,
             "--length 3cm --wall 0.5cm", "--length 0.03 --wall 5mm"}));

const std::string duty =
    "hinge-duty --joint data/reference/duty/cycle_hip.toml --cycle "
    "data/reference/duty/cycle_hip_in.csv --euler zxy ";
const std::string rig =
    "hinge-identify --joint data/duty/torque_rig.toml --data "
    "data/duty/torque_rig.csv ";

INSTANTIATE_TEST_SUITE_P(
    Duty, UnitOptions,
    testing::Values(
        Same{duty, "--period 1000ms", "--period 1"},
        Same{duty, "--friction 0.1 --adhesion 0.5kPa",
             "--friction 0.1 --adhesion 500"},
        Same{duty, "--viscous 2MPa*s/m,0.1s/m", "--viscous 2e6,0.1"},
        Same{rig + "--fit f0 ", "--adhesion 1MPa", "--adhesion 1e6"}));

INSTANTIATE_TEST_SUITE_P(Table, UnitOptions,
                         testing::Values(Same{"hinge-table ",
                                              "--theta0 30deg --alpha 45deg",
                                              "--theta0 30 --alpha 45"}));

INSTANTIATE_TEST_SUITE_P(Separation, UnitOptions,
                         testing::Values(Same{
                             "hinge-separation data/cases/flywheels.toml "
                             "--checkpoint c.cbor ",
                             "--checkpoint-every 20000ms --time-limit 1e6ms",
                             "--checkpoint-every 20"}));

}  // namespace
}  // namespace contact::test
