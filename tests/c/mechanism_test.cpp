// Mechanisms from C are bit-identical to mechanisms from C++.
#include "libcontact/joint/steps/mechanism_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "c/door.hpp"
#include "libcontact/files/joint_file.hpp"

namespace contact::test::mechanism_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Mechanism =
    std::unique_ptr<contact_mechanism, void (*)(contact_mechanism*)>;

const std::string folder = CONTACT_DATA_DIR "/joints/";
const std::string hip_file = folder + "hip_cup.toml";
const std::string pin_file = folder + "pin_joint.toml";

Mechanism made(const std::vector<contact_mechanism_joint>& joints,
               std::size_t size) {
  contact_mechanism* mechanism = nullptr;
  EXPECT_EQ(
      contact_mechanism_make(joints.data(), joints.size(), size, &mechanism),
      CONTACT_OK)
      << contact_last_message();
  return {mechanism, contact_mechanism_free};
}

TEST(CMechanism, IsThatOfCpp) {
  const CJoint hip = c_joint(hip_file);
  const CJoint pin = c_joint(pin_file);
  const Mechanism c = made({{hip.get(), 0}, {pin.get(), 4}}, 5);
  const Joint cpp_hip(read_joint(hip_file));
  const Joint cpp_pin(read_joint(pin_file));
  MechanismStep cpp({{&cpp_hip, 0}, {&cpp_pin, 4}}, 5);

  MatrixXd inertia = MatrixXd::Constant(5, 5, 0.125);
  inertia.diagonal() << 1, 2, 3, 4, 5;
  // Two rows, one after the other.
  const std::vector<double> rows = {1, 0, 0, 0.5, 0, 0, 0.25, 0, 0, 1};
  const std::vector<double> stiffness = {2, 3};
  MatrixXd jacobian(2, 5);
  jacobian << 1, 0, 0, 0.5, 0, 0, 0.25, 0, 0, 1;
  ASSERT_EQ(contact_mechanism_weigh(c.get(), inertia.data(), rows.data(),
                                    stiffness.data(), 2, 0.01),
            CONTACT_OK);
  cpp.weigh(inertia, jacobian, Eigen::Vector2d(2, 3), 0.01);
  // A quarter turn about x, row by row.
  const contact_mechanism_start starts[] = {
      {{0, -3000, 1000}, {}, {1, 0, 0, 0, 0, -1, 0, 1, 0}},
      {{0, 0, 5000}, {0, 1, 0}, {}}};
  const VectorXd rates = (VectorXd(5) << 0.1, 0.2, 0.3, 0.4, 0.5).finished();
  const VectorXd end = (VectorXd(5) << 1, -2, 3, -4, 5).finished();
  ASSERT_EQ(contact_mechanism_begin(c.get(), starts, rates.data(), end.data()),
            CONTACT_OK);
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  cpp.begin(std::vector<MechanismStart>{{{0, -3000, 1000}, {}, turn},
                                        {{0, 0, 5000}, {0, 1, 0}}},
            rates, end);

  VectorXd of_c = VectorXd::Zero(5);
  VectorXd of_cpp = of_c;
  double change = 0;
  ASSERT_EQ(contact_mechanism_turn(c.get(), end.data(), of_c.data(), &change),
            CONTACT_OK);
  EXPECT_EQ(cpp.turn(end, of_cpp), change);
  EXPECT_EQ(of_c, of_cpp);
  EXPECT_EQ(change, 1);
  EXPECT_LT(of_c.dot(end), 0);
  contact_sweeps sweeps;
  for (int i = 0; i < 2; ++i) {
    contact_step step;
    ASSERT_EQ(contact_mechanism_get(c.get(), i, &step, &sweeps), CONTACT_OK);
    EXPECT_EQ(Vector3d(step.moment), cpp.steps()[i].moment);
    EXPECT_EQ(Vector3d(step.angular_velocity), cpp.steps()[i].angular_velocity);
    EXPECT_EQ(step.holds, cpp.steps()[i].holds);
  }
  EXPECT_EQ(sweeps.sweeps, cpp.sweeps().sweeps);
  EXPECT_EQ(sweeps.residual, cpp.sweeps().residual);
  ASSERT_EQ(
      contact_mechanism_hold(c.get(), rates.data(), end.data(), of_c.data()),
      CONTACT_OK);
  EXPECT_EQ(of_c, cpp.holding_force(rates, end));
}

TEST(CMechanism, SaysWhatIsWrong) {
  const CJoint pin = c_joint(pin_file);
  contact_mechanism* none = nullptr;
  const contact_mechanism_joint missing{nullptr, 0};
  expect_failure(contact_mechanism_make(&missing, 1, 1, &none),
                 CONTACT_BAD_INPUT,
                 "contact_mechanism_make: joints[0].joint must be other than "
                 "NULL");
  const contact_mechanism_joint outside{pin.get(), 1};
  expect_failure(contact_mechanism_make(&outside, 1, 1, &none),
                 CONTACT_BAD_INPUT,
                 "MechanismStep: the rates of joint 0 must be among 1 and of "
                 "no other joint");
  EXPECT_EQ(none, nullptr);
  contact_mechanism_free(none);

  const Mechanism c = made({{pin.get(), 0}}, 1);
  const double one = 1;
  double force = 0;
  expect_failure(contact_mechanism_turn(c.get(), &one, &force, nullptr),
                 CONTACT_BAD_INPUT,
                 "MechanismStep: weigh() and begin() must come before turn()");
  expect_failure(contact_mechanism_weigh(c.get(), &one, nullptr, nullptr, 1, 1),
                 CONTACT_BAD_INPUT,
                 "contact_mechanism_weigh: rows must be other than NULL");
  EXPECT_EQ(contact_mechanism_weigh(c.get(), &one, nullptr, nullptr, 0, 1),
            CONTACT_OK);
  expect_failure(contact_mechanism_begin(c.get(), nullptr, &one, &one),
                 CONTACT_BAD_INPUT,
                 "contact_mechanism_begin: starts must be other than NULL");
  contact_step step;
  expect_failure(contact_mechanism_get(c.get(), 1, &step, nullptr),
                 CONTACT_BAD_INPUT, "contact_mechanism_get: i must be below 1");
  EXPECT_TRUE(std::isnan(step.moment[0]));
  // Without joints there is nothing to do.
  const Mechanism empty = made({}, 0);
  EXPECT_EQ(contact_mechanism_begin(empty.get(), nullptr, nullptr, nullptr),
            CONTACT_OK);
}

}  // namespace
}  // namespace contact::test::mechanism_test
