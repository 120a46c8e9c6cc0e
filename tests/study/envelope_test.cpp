// The band of runs over time.
#include "programs/study/findings/envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "study/rows/journal.hpp"
#include "study/study.hpp"

namespace contact::test::envelope_test {
namespace {

namespace fs = std::filesystem;

// An arm on a ball that a thrust turns ever faster. With much thrust the ball
// is pulled beyond Hertz's law on the way, and the run fails.
const std::string case_text =
    "name = 'c'\nrun = { end_time_s = 2, output_step_s = 0.05 }\n"
    "[carrier]\nname = 'a'\nmass_t = 1000\n"
    "principal_inertia_kg_m2 = [1e6, 1e6, 1e6]\n"
    "[[body]]\nname = 'arm'\nmass_kg = 100\ncom_m = [1, 0, 0]\n"
    "principal_inertia_kg_m2 = [100, 100, 100]\n"
    "[body.hinge]\nkind = 'ball'\n"
    "[[body.hinge.joint]]\nname = 'ball'\nkind = 'ball'\n"
    "geometry = { radius_mm = 5, radial_clearance_um = 5 }\n"
    "materials = { pair = '" CONTACT_DATA_DIR
    "/materials/steel_steel.toml' }\n"
    "friction = { coefficient = 0.1 }\nhalf_angle = { law = 'hertz' }\n"
    "pressure = { law = 'sqrt_tan' }\n"
    "[[force]]\nname = 'push'\nkind = 'thrust'\nbody = 'arm'\n"
    "point_m = [1, 0, 0]\ndirection = [0, 1, 0]\nthrust_N = 200\n";

TEST(Envelope, EndsWithTheRunsThatFail) {
  const fs::path folder = fs::path(testing::TempDir()) / "contact_envelope";
  fs::create_directories(folder);
  std::ofstream(folder / "c.toml") << case_text;
  std::ofstream(folder / "s.toml")
      << "name = 's'\ncase = 'c.toml'\nruns = 12\n"
         "quantities = ['arm.peak_reaction_N']\n[[dispersion]]\n"
         "key = 'force[push].thrust_N'\nkind = 'list'\n"
         "values = [200, 20000]\n";
  const study::Study study(folder / "s.toml");
  study::Journal journal((folder / "j").string(), study.identity(),
                         study.columns(), study::Journal::Use::write);
  std::size_t failed = 0;
  for (std::uint64_t run = 0; run <= study.runs(); ++run) {
    const study::Row row = study.row(run);
    failed += row.failure.empty() ? 0 : 1;
    journal.append(row);
  }
  ASSERT_GT(failed, 0u);
  ASSERT_LT(failed, 12u);
  const auto all = study::envelopes(study, study::find(study, journal));
  const auto angles = std::ranges::find(all, "angles", &study::Envelope::name);
  ASSERT_NE(angles, all.end());
  // The twelve and the nominal one; a run that has ended has no numbers.
  EXPECT_EQ(angles->counts.front(), 13u);
  EXPECT_EQ(angles->counts.back(), 13 - failed);
  for (std::size_t i = 1; i < angles->counts.size(); ++i) {
    EXPECT_LE(angles->counts[i], angles->counts[i - 1]) << i;
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace contact::test::envelope_test
