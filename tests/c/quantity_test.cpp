// Quantities from C by their names: all of the tables, as C++ has them.
#include "libcontact/c/quantity.h"

#include <gtest/gtest.h>

#include <string>

#include "c/door.hpp"
#include "c/expect_table.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/tables.hpp"

namespace {

using contact::Joint;
using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_table;

const std::string hip = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
const std::string pressed = CONTACT_DATA_DIR "/joints/lined_bush_pressed.toml";

TEST(CQuantities, OfSolutionsAreThoseOfCpp) {
  for (const std::string& file : {hip, pressed}) {
    const Joint cpp(contact::read_joint(file).contact());
    const CJoint c = c_joint(file);
    // One slides, one rests.
    for (const double rate : {0.8, 0.0}) {
      const contact_slip slip = {{100, 0, 2000}, {rate, 0, rate}, {}};
      contact_solution s;
      ASSERT_EQ(contact_joint_solve(c.get(), &slip, nullptr, &s), CONTACT_OK);
      expect_table(contact::solution_quantities(),
                   cpp.solve({{100, 0, 2000}, {rate, 0, rate}}),
                   contact_solution_quantity, [&](const char* key, double* to) {
                     return contact_solution_get(&s, key, to);
                   });
    }
  }
}

TEST(CQuantities, OfRestAreThoseOfCpp) {
  const Joint cpp(contact::read_joint(hip).contact());
  const CJoint c = c_joint(hip);
  const contact_hold hold = {{0, 0, 2000}, {0.5, 0, 0.2}, {}};
  contact_rest rest;
  ASSERT_EQ(contact_joint_at_rest(c.get(), &hold, nullptr, &rest), CONTACT_OK);
  expect_table(contact::rest_quantities(),
               cpp.at_rest({{0, 0, 2000}, {0.5, 0, 0.2}}),
               contact_rest_quantity, [&](const char* key, double* to) {
                 return contact_rest_get(&rest, key, to);
               });
}

TEST(CQuantities, OfPatchesAreThoseOfCpp) {
  for (const std::string& file : {hip, pressed}) {
    const Joint cpp(contact::read_joint(file).contact());
    const CJoint c = c_joint(file);
    const contact::ContactPatch patch = {
        cpp.contact(), 2000, cpp.contact().half_angle(2000).half_angle};
    expect_table(contact::patch_quantities(), patch, contact_patch_quantity,
                 [&](const char* key, double* to) {
                   return contact_patch_get(c.get(), 2000, key, to);
                 });
  }
}

TEST(CQuantities, OfRatingsAreThoseOfCpp) {
  const Joint cpp(contact::read_joint(hip).contact());
  const CJoint c = c_joint(hip);
  const contact_slip slip = {{100, 0, 2000}, {0.8, 0, 0.8}, {}};
  contact_solution s;
  ASSERT_EQ(contact_joint_solve(c.get(), &slip, nullptr, &s), CONTACT_OK);
  const Eigen::Vector3d rate(0.8, 0, 0.8);
  const auto solution = cpp.solve({{100, 0, 2000}, rate});
  expect_table(contact::rating_quantities(),
               contact::SlidingContact(cpp.contact(), solution, rate).rating(),
               contact_rating_quantity, [&](const char* key, double* to) {
                 return contact_rating_get(c.get(), &slip, &s, key, to);
               });
}

TEST(CQuantities, RefuseWhatIsNotThere) {
  const contact_solution s = {};
  double value;
  EXPECT_EQ(contact_solution_get(&s, "friction_momnet", &value),
            CONTACT_BAD_INPUT);
  EXPECT_EQ(std::string(contact_last_message())
                .find("unknown quantity \"friction_momnet\": did you mean "
                      "\"friction_moment\"?"),
            0u);
  EXPECT_EQ(contact_solution_get(nullptr, "power", &value), CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_solution_get(&s, nullptr, &value), CONTACT_BAD_INPUT);
  EXPECT_EQ(contact_solution_get(&s, "power", nullptr), CONTACT_BAD_INPUT);
}

}  // namespace
