// hinge-joint --measured-moment: f0 from a measured friction moment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "support/program.hpp"

namespace contact::test::measured_moment_test {
namespace {

// A cell of the only row.
std::string text(const ProgramResult& result, const std::string& column) {
  EXPECT_EQ(result.status, 0) << result.err;
  const CsvTable table(result.out);
  EXPECT_EQ(table.size(), 1U);
  return table.text(column);
}
double number(const ProgramResult& result, const std::string& column) {
  return CsvTable(result.out).at(column);
}

struct Case {
  const char* joint;
  const char* state;
  const char* laws;
};
std::ostream& operator<<(std::ostream& to, const Case& c) {
  return to << c.joint << ' ' << c.state << ' ' << c.laws;
}
class RoundTrip : public testing::TestWithParam<Case> {};

// f0, moment, f0. M_t comes back to rounding, a few 1e-16, and f0 to that times
// d ln f0/d ln M_t. That is largest where adhesion has most of the moment, some
// 60 for f0 = 0.001 of the pin under 100 N: 8 roundings of M_t. The largest
// error was 1.4e-14.
TEST_P(RoundTrip, FindsTheFriction) {
  const ProgramFolder folder;
  const auto& [joint, state, laws] = GetParam();
  for (const std::string adhesion : {"0", "1e5"}) {
    for (const double f0 : {0.001, 0.05, 0.3, 1., 2.5}) {
      const std::string run = fmt::format(
          "hinge-joint --joint data/joints/{}.toml {} {} "
          "--adhesion {} ",
          joint, state, laws, adhesion);
      const ProgramResult direct =
          folder.run(run + fmt::format("--friction {}", f0));
      const ProgramResult found =
          folder.run(run + "--measured-moment " + text(direct, "M_t_N_m"));
      const double moment = number(direct, "M_t_N_m");
      EXPECT_NEAR(number(found, "M_t_N_m"), moment, 3e-14 * moment);
      EXPECT_NEAR(number(found, "f0"), f0, 1e-13 * f0) << run;
      // Everything equals the joint with this f0.
      for (const char* column : {"R_n_N", "p_peak_Pa", "f_M"}) {
        const double value = number(direct, column);
        EXPECT_NEAR(number(found, column), value, 1e-13 * value) << column;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    MeasuredMoment, RoundTrip,
    testing::Values(
        Case{"hip_cocr_uhmwpe_infinite", "--reaction 2e3 --beta 90",
             "--law tanh"},
        Case{"hip_cocr_uhmwpe_infinite", "--reaction 2e3 --beta 40",
             "--law exact --pressure exact"},
        Case{"hip_cocr_uhmwpe_infinite", "--normal-force 2e3 --alpha 30",
             "--pressure sqrt_tan"},
        Case{"paper_example_1",
             "--reaction-xyz 1e5,2e4,-3e4 --rate-xyz 0.1,0.2,-3", "--law tanh"},
        Case{"paper_example_1", "--reaction 1e6 --beta 120",
             "--law fitted --pressure exact"},
        Case{"pin_joint", "--reaction 100", "--law hertz"},
        Case{"pin_joint", "--reaction 2e5", "--law exact --pressure exact"},
        Case{"pin_joint", "--normal-force 2e5", "--pressure cosine"},
        Case{"spherical_plain_bearing", "--reaction 1e5 --beta 70", ""}));

// A pin without adhesion, by hand: tan g = f0 and f_M = f0 S cos g, so that
// f0 = f_M/sqrt(S^2 - f_M^2).
TEST(MeasuredMoment, OfAPinByHand) {
  const ProgramFolder folder;
  const auto file = read_joint(std::filesystem::path(CONTACT_DATA_DIR) /
                               "joints" / "pin_joint.toml");
  const ProgramResult found = folder.run(
      "hinge-joint --joint data/joints/pin_joint.toml --pressure cosine "
      "--reaction 2e5 --measured-moment 450");
  const double f_m = 450 / (0.02 * 2e5);
  EXPECT_NEAR(number(found, "f_M"), f_m, 1e-14);
  const double s = make_pressure_law("cosine", file.geometry.kind(),
                                     file.pair(), file.conditions())
                       ->force_ratio(number(found, "theta0_deg") * degree);
  EXPECT_NEAR(number(found, "f0"), f_m / std::sqrt(s * s - f_m * f_m), 1e-14);
}

// The sample hip's f0 gives the friction factor of its source, 0.062,
// and f0 has three digits: half a unit of the last is 5e-5 in both.
TEST(MeasuredMoment, TheHipsFrictionFactorIsThatOfItsSource) {
  const ProgramFolder folder;
  const std::string hip =
      "hinge-joint --joint data/joints/hip_cocr_uhmwpe.toml --reaction 2000 "
      "--beta 90 ";
  EXPECT_NEAR(number(folder.run(hip), "f_M"), 0.062, 5e-5);
  // 1.736 N m = 0.062 * 14 mm * 2 kN.
  EXPECT_NEAR(number(folder.run(hip + "--measured-moment 1.736"), "f0"), 0.0587,
              5e-5);
}

// The joint's own adhesion counts, --adhesion takes its place, and a joint
// without friction has none. Each pair of laws has its own f0.
TEST(MeasuredMoment, AdhesionIsGiven) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-joint --joint data/joints/paper_example_1.toml --reaction 3e5 "
      "--beta 60 --measured-moment 9000 ";
  const double own = number(folder.run(run), "f0");
  EXPECT_EQ(number(folder.run(run + "--adhesion 40e6"), "f0"), own);
  EXPECT_GT(number(folder.run(run + "--adhesion 0"), "f0"), 2 * own);
  EXPECT_EQ(number(folder.run("hinge-joint --joint pin --pair "
                              "data/materials/steel_bronze.toml --radius 20mm "
                              "--clearance 40um --length 50mm "
                              "--reaction 2e5 --measured-moment 450"),
                   "Abar"),
            0);

  const auto several =
      csv_rows(folder.run(run + "--law tanh,fitted --adhesion 0").out);
  const auto f0 = csv_column(several, "f0");
  ASSERT_EQ(f0.size(), 2U);
  EXPECT_EQ(f0[0], text(folder.run(run + "--law tanh --adhesion 0"), "f0"));
  EXPECT_NE(f0[0], f0[1]);
  // No moment and no adhesion: no friction.
  EXPECT_EQ(text(folder.run("hinge-joint --joint data/joints/pin_joint.toml "
                            "--reaction 1e3 --measured-moment 0"),
                 "f0"),
            "0");
}

}  // namespace
}  // namespace contact::test::measured_moment_test
