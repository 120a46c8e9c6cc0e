// --wall and --backing: the same joint as by a file with [wall].
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program.hpp"

namespace contact::test {
namespace {

class WallOptions : public testing::Test {
 protected:
  std::string out(const std::string& command) const {
    return folder_.run_well(command).out;
  }
  // Of `column` in the first row.
  double value(const std::string& command, const std::string& column) const {
    return std::stod(csv_column(csv_rows(out(command)), column).at(0));
  }

  const ProgramFolder folder_;
  const std::string hip_file_ = "data/joints/hip_cocr_uhmwpe.toml ";
  const std::string hip_pair_ = "ball --pair data/materials/cocr_uhmwpe.toml ";
  const std::string hip_ = hip_pair_ +
                           "--radius 14mm --clearance 100um --wall 8mm "
                           "--backing rigid ";
};

TEST_F(WallOptions, RigidShell) {
  for (const std::string program :
       {"hinge-angle --load 100,2000 --joint ",
        "hinge-angle --inverse --theta0 20,40 --joint ",
        "hinge-pressure --load 2000 --points 5 --joint ",
        "hinge-pressure --load 2000 --summary --joint "}) {
    const std::string expected = out(program + hip_file_);
    EXPECT_TRUE(has_text(expected, "exact")) << program;
    EXPECT_EQ(out(program + hip_), expected) << program;
  }
  const std::string state = "hinge-joint --reaction 2000 --beta 30,90 --joint ";
  EXPECT_EQ(out(state + hip_ + "--inner-body body"), out(state + hip_file_));
}

TEST_F(WallOptions, MaterialOfAFile) {
  const std::string load = "hinge-angle --load 1e3,1e5 --joint ";
  EXPECT_EQ(out(load + "ball --pair data/materials/steel_ptfe_liner.toml "
                       "--radius 17.5mm --clearance 15um --wall 0.4mm "
                       "--backing data/backings/carbon_steel.toml"),
            out(load + "data/joints/spherical_plain_bearing.toml"));
}

TEST_F(WallOptions, HeldPin) {
  folder_.write("held.toml",
                "name = \"bush\"\nkind = \"pin\"\n[geometry]\n"
                "radius_mm = 25\nradial_clearance_um = 25\nlength_mm = 30\n"
                "[materials]\npair = \"data/materials/steel_bronze.toml\"\n"
                "[wall]\nbacking = \"held\"\n"
                "[[wall.layer]]\nthickness_mm = 5\n");
  const std::string pin =
      "pin --pair data/materials/steel_bronze.toml --radius 25mm "
      "--clearance 25um --wall 5mm --backing held ";
  const std::string summary = "hinge-pressure --summary --load 6e4 --joint ";
  EXPECT_EQ(out(summary + pin + "--length 30mm"), out(summary + "held.toml"));
  const std::string state =
      "hinge-joint --friction 0.1 --reaction 1e4 --joint ";
  EXPECT_EQ(out(state + pin + "--length 30mm"), out(state + "held.toml"));
}

// Without a size the thickness is over the radius.
TEST_F(WallOptions, Dimensionless) {
  const std::string relative = "--wall 0.5714285714285714 --backing rigid";
  const std::string x = "hinge-angle --x 1 --joint ";
  const double expected = value(x + hip_file_, "theta0_exact_deg");
  // 8/14 is rounded twice, the solutions are of 1e-12.
  EXPECT_NEAR(value(x + hip_pair_ + relative, "theta0_exact_deg"), expected,
              1e-9);
  // The constants of cocr_uhmwpe.toml.
  EXPECT_NEAR(value(x + "ball --modulus-ratio 230 --poisson2 0.4 " + relative,
                    "theta0_exact_deg"),
              expected, 1e-9);
  const std::string table = "hinge-table --theta0 60 --alpha 90 --joint ";
  EXPECT_NEAR(value(table + hip_pair_ + relative, "sigma_Z_exact"),
              value(table + hip_file_, "sigma_Z_exact"), 1e-10);
  // A thick wall is as good as none.
  EXPECT_NEAR(
      value(x + "ball --modulus-ratio 2 --wall 1e5 --backing held",
            "theta0_exact_deg"),
      value(x + "ball --modulus-ratio 2 --law exact", "theta0_exact_deg"),
      1e-6);
}

}  // namespace
}  // namespace contact::test
