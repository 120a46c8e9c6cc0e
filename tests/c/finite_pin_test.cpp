// Pins that end, from C, are those of C++ to the last bit.
#include "libcontact/c/finite_pin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "c/door.hpp"
#include "c/expect_table.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace {

using contact::FinitePin;
using contact::FinitePinSolution;
using contact::test::c_joint;
using contact::test::CJoint;
using contact::test::expect_failure;
using CPin = std::unique_ptr<contact_finite_pin, void (*)(contact_finite_pin*)>;

const std::string bush = CONTACT_DATA_DIR "/joints/relieved_bush.toml";

CPin c_pin() {
  contact_finite_pin* pin = nullptr;
  EXPECT_EQ(contact_finite_pin_make(c_joint(bush).get(), &pin), CONTACT_OK)
      << contact_last_message();
  return {pin, contact_finite_pin_free};
}

void expect_same(const CPin& pin, const contact_finite_pin_load& load,
                 const FinitePinSolution& cpp) {
  contact_finite_pin_solution c;
  ASSERT_EQ(contact_finite_pin_solve(pin.get(), &load, &c), CONTACT_OK);
  contact::test::expect_table(contact::finite_pin_quantities(), cpp,
                              contact_finite_pin_quantity,
                              [&](const char* key, double* value) {
                                return contact_finite_pin_get(&c, key, value);
                              });
  EXPECT_EQ(c.friction_force[1], cpp.friction_force.y());
  EXPECT_EQ(c.shift[0], cpp.contact.shift.x());
  EXPECT_EQ(c.stiffness[10], cpp.contact.stiffness(2, 2));
  EXPECT_EQ(c.end_pressure[1], cpp.contact.end_pressure[1]);
  EXPECT_EQ(c.energy, cpp.contact.energy);
  EXPECT_GT(c.peak_pressure, 0);
}

TEST(CFinitePin, IsWhatCppSays) {
  const CPin pin = c_pin();
  const FinitePin cpp(contact::read_joint(bush));
  expect_same(pin, {{1e4, 200}, 1, {2e-4, 1e-4}, 0, 0, 0},
              cpp.solve({1e4, 200}, {2e-4, 1e-4}, 1));
  expect_same(pin, {{1e4, 0}, -2, {}, 1, 1e-3, 0.01},
              cpp.solve_at({1e4, 0}, 1e-3, {-2, 0.01}));
}

TEST(CFinitePin, RefusesWhatCannotBe) {
  contact_finite_pin* none = nullptr;
  const CJoint ball = c_joint(CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml");
  EXPECT_EQ(contact_finite_pin_make(ball.get(), &none), CONTACT_BAD_INPUT);
  EXPECT_NE(std::string(contact_last_message()).find("requires"),
            std::string::npos)
      << contact_last_message();
  EXPECT_EQ(none, nullptr);
  const CPin pin = c_pin();
  contact_finite_pin_solution c;
  expect_failure(contact_finite_pin_solve(pin.get(), nullptr, &c),
                 CONTACT_BAD_INPUT,
                 "contact_finite_pin_solve: load must be other than NULL");
  EXPECT_EQ(c.status, CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::isnan(c.moment[2]) && std::isnan(c.stiffness[15]));
  const contact_finite_pin_load huge = {{1e14, 0}, 1, {}, 0, 0, 0};
  EXPECT_EQ(contact_finite_pin_solve(pin.get(), &huge, &c),
            CONTACT_OUT_OF_RANGE);
  contact_finite_pin_free(nullptr);
}

}  // namespace
