// Several joints in one run: --set KEY=VALUES and several --joint.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/joint/key_settings.hpp"
#include "libcontact/files/joint_file.hpp"
#include "support/program.hpp"

namespace contact::test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

class ComparedJoints : public testing::Test {
 protected:
  Rows rows(const std::string& command) const {
    const auto result = folder_.run(command);
    EXPECT_EQ(result.status, 0) << command << '\n' << result.err;
    return csv_rows(result.out);
  }
  // Without the first cells of each row, and without the header.
  static Rows without(Rows rows, std::ptrdiff_t cells) {
    rows.erase(rows.begin());
    for (auto& row : rows) row.erase(row.begin(), row.begin() + cells);
    return rows;
  }

  ProgramFolder folder_;
  const std::string hip_ =
      " --joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
};

// Every key in its own unit, in the place of the file's; the rows are those of
// files that say so.
TEST_F(ComparedJoints, RowsAreThoseOfTheirFiles) {
  std::string text = folder_.read("data/joints/hip_cocr_uhmwpe_infinite.toml");
  const std::string in_file = "radial_clearance_um = 100";
  ASSERT_TRUE(has_text(text, in_file));
  text.replace(text.find(in_file), in_file.size(),
               "radial_clearance_mm = 0.05");
  text.replace(text.find("../materials"), 12, "data/materials");
  folder_.write("other.toml", text);
  const std::string set = "--set geometry.radial_clearance_mm=0.05,0.1";
  for (const std::string program :
       {"hinge-angle --load 100:1000:log3", "hinge-pressure --load 10,20",
        "hinge-joint --friction 0.1 --reaction 100,200 --beta 90"}) {
    const Rows both = rows(program + hip_ + set);
    EXPECT_EQ(both[0][0], "geometry.radial_clearance_mm");
    Rows expected = without(rows(program + " --joint other.toml"), 0);
    const Rows second = without(rows(program + hip_), 0);
    if (program.starts_with("hinge-joint")) {  // joints run fastest
      expected = {expected[0], second[0], expected[1], second[1]};
    } else {
      expected.insert(expected.end(), second.begin(), second.end());
    }
    EXPECT_EQ(without(both, 1), expected) << program;
    const std::string files =
        " --joint other.toml --joint data/joints/hip_cocr_uhmwpe_infinite.toml";
    const Rows named = rows(program + files);
    EXPECT_EQ(named[0][0], "joint");
    EXPECT_EQ(named[1][0], "other");
    EXPECT_EQ(without(named, 1), expected) << program;
  }
}

TEST_F(ComparedJoints, AllCombinationsTheLastKeyFastest) {
  const Rows all = rows(
      "hinge-angle --x 1 --joint data/joints/hip_cocr_uhmwpe.toml "
      "--set 'wall.layer[1].thickness_mm=4:8:4' "
      "--set wall.backing=rigid,held");
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(csv_column(all, "wall.layer[1].thickness_mm"),
            (std::vector<std::string>{"4", "4", "8", "8"}));
  EXPECT_EQ(csv_column(all, "wall.backing"),
            (std::vector<std::string>{"rigid", "held", "rigid", "held"}));
  const auto theta0 = csv_column(all, "theta0_exact_deg");
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(theta0[i], theta0[j]);
  }
}

TEST_F(ComparedJoints, PicturesNameThem) {
  if (folder_.run("command -v gnuplot").status != 0) GTEST_SKIP();
  for (const std::string program :
       {"hinge-angle --load 100:1000:log3",
        "hinge-pressure --load 1000 "
        "--pressure exact",
        "hinge-joint --friction 0.1 --reaction 100:1000:100 --beta 90"}) {
    rows(program + hip_ +
         "--set geometry.radial_clearance_um=50,100 --plot p.svg");
    const std::string picture = folder_.read("p.svg");
    for (const char* value : {"50", "100"}) {
      EXPECT_TRUE(
          has_text(picture, "radial_clearance_um = " + std::string(value)))
          << program;
    }
  }
}

TEST(KeySettings, TablesAreMadeAndTextsNeedNoQuotes) {
  const auto settings = cli::key_settings(
      {"half_angle.law=tanh", "half_angle.limit_half_angle_deg=80,85",
       "name=a 'b' \"c\""});
  ASSERT_EQ(settings.size(), 2u);
  const auto joint = read_joint(
      std::string(CONTACT_DATA_DIR) + "/joints/wheel_ball.toml", settings[1]);
  EXPECT_EQ(joint.half_angle_law, "tanh");
  EXPECT_DOUBLE_EQ(*joint.half_angle_options.limit_half_angle / 85 * 180,
                   3.14159265358979323846);
  EXPECT_EQ(joint.name, "a 'b' \"c\"");
}

}  // namespace
}  // namespace contact::test
