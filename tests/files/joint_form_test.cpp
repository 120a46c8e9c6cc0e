#include "libcontact/files/joint_form.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "support/error_message.hpp"

namespace contact::test::joint_form_test {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(CONTACT_DATA_DIR) / "joints";
constexpr const char* hip_file = "hip_cocr_uhmwpe.toml";

std::string text_of(const char* file) {
  std::ostringstream text;
  text << std::ifstream(folder / file).rdbuf();
  return text.str();
}

JointForm form_of(const char* file, std::vector<std::string> keys,
                  KeySettings settings = {}) {
  return {text_of(file), file, folder, std::move(settings), std::move(keys)};
}

// Settings reach the keys of a file that the joint names, too.
TEST(JointForm, GivesTheJointsOfSettings) {
  JointForm form = form_of(
      hip_file,
      {"geometry.radial_clearance_um", "materials.friction.coefficient"},
      {{"half_angle.law", "exact"}});
  for (const double x : {50.0, 80.5}) {
    const JointSpec wanted = read_joint(
        folder / hip_file,
        {{"half_angle.law", "exact"},
         {"geometry.radial_clearance_um", std::to_string(x)},
         {"materials.friction.coefficient", std::to_string(x / 1000)}});
    EXPECT_EQ(form.with(std::vector{x, x / 1000}), wanted);
  }
}

TEST(JointForm, SaysWhatIsWrongAsSettingsDo) {
  JointForm form = form_of(hip_file, {"geometry.radius_mm"});
  EXPECT_ERROR(form.with(std::vector{-14.0}),
               "hip_cocr_uhmwpe.toml with geometry.radius_mm = -14: "
               "geometry.radius_mm = -14 must be above 0");
  // And continues.
  EXPECT_EQ(form.with(std::vector{14.0}).geometry.radius(), 0.014);
  JointForm name = form_of(hip_file, {"name"});
  EXPECT_ERROR(name.with(std::vector{1.0}),
               "hip_cocr_uhmwpe.toml with name = 1: name = 1 must be a string, "
               "not empty");
}

// How many laws are made for joints that differ by a key.
std::size_t laws_of(const char* file, const char* key,
                    const std::vector<double>& values) {
  JointForm form = form_of(file, {key});
  SharedLaws laws;
  for (const double x : values) form.with({&x, 1}).contact(laws);
  return laws.size();
}

TEST(SharedLaws, AreMadeOnceForAllThatTheyServe) {
  const char* const pin = "pin_joint.toml";
  EXPECT_EQ(laws_of(hip_file, "materials.friction.coefficient", {0.1, 0.2}), 2);
  EXPECT_EQ(laws_of(hip_file, "geometry.radial_clearance_um", {60, 90}), 2);
  EXPECT_EQ(laws_of(hip_file, "geometry.radius_mm", {14, 15}), 4);  // walls
  EXPECT_EQ(laws_of(pin, "geometry.radius_mm", {300, 400}), 2);
  EXPECT_EQ(laws_of(pin, "materials.inner.youngs_modulus_GPa", {50, 60, 50}),
            4);
}

}  // namespace
}  // namespace contact::test::joint_form_test
