// Joints from C are bit-identical to C++.
#include "libcontact/joint/joint.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "c/door.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/pressure/factory.hpp"
#include "support/error_message.hpp"
#include "support/random_slip.hpp"

namespace contact::test::joint_test {
namespace {

using Eigen::Vector3d;

const std::string joints = CONTACT_DATA_DIR "/joints/";
// Balls with and without a wall, pins, one with interference.
const std::vector<std::string> names = {"hip_cocr_uhmwpe", "paper_example_2",
                                        "pin_joint", "wheel_pin",
                                        "lined_bush_pressed"};

// NaN too.
void expect_same(double a, double b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b))
      << a << " and " << b;
}
void expect_same(const double (&a)[3], const Vector3d& b) {
  for (int i = 0; i < 3; ++i) expect_same(a[i], b[i]);
}

void expect_same(const contact_solution& a, const JointSolution& b) {
  EXPECT_EQ(static_cast<int>(a.status), static_cast<int>(b.status));
  EXPECT_EQ(static_cast<int>(a.state), static_cast<int>(b.state));
  EXPECT_EQ(a.evaluations, b.evaluations);
  expect_same(a.residual, b.residual);
  expect_same(a.reaction, b.reaction);
  expect_same(a.normal, b.normal);
  expect_same(a.normal_force, b.normal_force);
  expect_same(a.friction_force, b.friction_force);
  expect_same(a.friction_moment, b.friction_moment);
  expect_same(a.textbook_moment, b.textbook_moment);
  expect_same(a.slip_velocity, b.slip_velocity);
  expect_same(a.power, b.power);
  expect_same(a.reaction_angle, b.reaction_angle());
  expect_same(a.friction_angle, b.friction_angle());
  expect_same(a.slip_axis_angle, b.slip_axis_angle());
  expect_same(a.force_coefficient, b.force_coefficient);
  expect_same(a.sliding_coefficient, b.sliding_coefficient);
  expect_same(a.spinning_coefficient, b.spinning_coefficient);
  expect_same(a.adhesion_number, b.adhesion_number);
  expect_same(a.load_parameter, b.load_parameter);
  expect_same(a.half_angle, b.half_angle);
  expect_same(a.peak_pressure, b.peak_pressure);
  expect_same(a.contact_area, b.contact_area);
}

contact_slip c_slip(const Joint::Slip& slip) {
  contact_slip c = {};
  for (int i = 0; i < 3; ++i) {
    c.reaction[i] = slip.reaction[i];
    c.angular_velocity[i] = slip.angular_velocity[i];
    c.axis[i] = slip.axis[i];
  }
  return c;
}

// A joint of both languages, and slips, each near the last one.
struct Both {
  explicit Both(const std::string& name)
      : cpp(read_joint(joints + name + ".toml").contact()),
        c(c_joint(joints + name + ".toml")) {
    RandomSlips random(7);
    Vector3d reaction = 1000 * random.direction();
    Vector3d rate = random.direction();
    for (int i = 0; i < 300; ++i) {
      slips.push_back({reaction, rate,
                       cpp.is_pin() ? rate.normalized() : Vector3d::Zero()});
      reaction += 30 * random.direction();
      rate += 0.03 * random.direction();
    }
    slips[20].reaction.setZero();
    slips[21].angular_velocity.setZero();
  }

  Joint cpp;
  CJoint c;
  std::vector<Joint::Slip> slips;
};

class Joints : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(CDoor, Joints, testing::ValuesIn(names));

TEST_P(Joints, SlideAsInCpp) {
  const Both both(GetParam());
  contact_solution s;
  for (const Joint::Slip& slip : both.slips) {
    const contact_slip c = c_slip(slip);
    ASSERT_EQ(contact_joint_solve(both.c.get(), &c, nullptr, &s), CONTACT_OK);
    expect_same(s, both.cpp.solve(slip));
    EXPECT_EQ(contact_joint_solve_contact(both.c.get(), &c, &s), CONTACT_OK);
    expect_same(s, both.cpp.solve_contact(
                       {slip.reaction, slip.angular_velocity, slip.axis}));
  }
}

TEST_P(Joints, StartFromTheLastSolutionAsInCpp) {
  const Both both(GetParam());
  contact_solution s = {};
  JointSolution last;
  int cold = 0, warm = 0;
  for (const Joint::Slip& slip : both.slips) {
    const contact_slip c = c_slip(slip);
    ASSERT_EQ(contact_joint_solve(both.c.get(), &c, &s, &s), CONTACT_OK);
    last = both.cpp.solve(slip, last);
    expect_same(s, last);
    warm += s.evaluations;
    cold += both.cpp.solve(slip).evaluations;
  }
  EXPECT_LT(warm, cold);
}

// A user's own structure, there and back.
struct Record {
  char name;
  double reaction[3], rate[3], axis[3];
  contact_solution solution;
};

TEST_P(Joints, SolveRowsWithStrides) {
  const Both both(GetParam());
  const std::size_t n = both.slips.size();
  std::vector<Record> records(n);
  for (std::size_t i = 0; i < n; ++i) {
    const contact_slip c = c_slip(both.slips[i]);
    std::copy_n(c.reaction, 3, records[i].reaction);
    std::copy_n(c.angular_velocity, 3, records[i].rate);
    std::copy_n(c.axis, 3, records[i].axis);
  }
  constexpr auto stride = static_cast<std::ptrdiff_t>(sizeof(Record));
  contact_slips slips = {};
  slips.count = n;
  slips.reaction = records[0].reaction;
  slips.angular_velocity = records[0].rate;
  slips.axis = records[0].axis;
  slips.reaction_stride = slips.angular_velocity_stride = slips.axis_stride =
      stride;
  for (const bool warm : {false, true}) {
    slips.warm = warm;
    ASSERT_EQ(contact_joint_solve_rows(both.c.get(), &slips,
                                       &records[0].solution, stride),
              CONTACT_OK);
    JointSolution last;
    for (std::size_t i = 0; i < n; ++i) {
      last = warm ? both.cpp.solve(both.slips[i], last)
                  : both.cpp.solve(both.slips[i]);
      expect_same(records[i].solution, last);
    }
  }
  // From the last to the first, all with the rate of the third, no axis.
  std::vector<contact_solution> solutions(n);
  slips.reaction = records[n - 1].reaction;
  slips.reaction_stride = -stride;
  slips.angular_velocity = records[2].rate;
  slips.angular_velocity_stride = 0;
  slips.axis = nullptr;
  slips.warm = 0;
  ASSERT_EQ(contact_joint_solve_rows(both.c.get(), &slips, solutions.data(),
                                     sizeof solutions[0]),
            CONTACT_OK);
  for (std::size_t i = 0; i < n; ++i) {
    expect_same(solutions[i], both.cpp.solve({both.slips[n - 1 - i].reaction,
                                              both.slips[2].angular_velocity}));
  }
}

TEST_P(Joints, RestAsInCpp) {
  const Both both(GetParam());
  contact_rest warm = {};
  RestSolution last;
  for (std::size_t i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const Joint::Slip& slip = both.slips[i];
    const Joint::Hold hold = {slip.reaction, slip.angular_velocity, slip.axis};
    const contact_slip c = c_slip(slip);
    contact_hold h = {};
    std::copy_n(c.reaction, 3, h.reaction);
    std::copy_n(c.angular_velocity, 3, h.moment);
    std::copy_n(c.axis, 3, h.axis);
    const auto compare = [](const contact_rest& a, const RestSolution& b) {
      EXPECT_EQ(static_cast<int>(a.status), static_cast<int>(b.status));
      EXPECT_EQ(a.solves, b.solves);
      expect_same(a.utilisation, b.utilisation);
      expect_same(a.direction, b.direction);
      expect_same(a.slip, b.slip);
    };
    ASSERT_EQ(contact_joint_at_rest(both.c.get(), &h, &warm, &warm),
              CONTACT_OK);
    last = both.cpp.at_rest(hold, last);
    compare(warm, last);
    contact_rest cold;
    ASSERT_EQ(contact_joint_at_rest(both.c.get(), &h, nullptr, &cold),
              CONTACT_OK);
    compare(cold, both.cpp.at_rest(hold));
  }
}

TEST_P(Joints, HaveTheContactOfCpp) {
  const Both both(GetParam());
  const auto& contact = both.cpp.contact();
  for (const double force : {1e-3, 20., 700., 3000.}) {
    contact_patch patch;
    ASSERT_EQ(contact_joint_patch(both.c.get(), force, &patch), CONTACT_OK);
    const double half_angle = contact.half_angle(force).half_angle;
    expect_same(patch.load_parameter, contact.load_parameter(force));
    expect_same(patch.half_angle, half_angle);
    expect_same(patch.peak_pressure, contact.peak_pressure(force, half_angle));
    expect_same(patch.mean_pressure, contact.mean_pressure(force, half_angle));
    expect_same(patch.area, contact.area(half_angle));
    double back;
    ASSERT_EQ(contact_joint_normal_force(both.c.get(), half_angle, &back),
              CONTACT_OK);
    const bool closed = contact.state(force) == ContactState::closed;
    // law.hpp: both directions. One that is closed is so up to lift-off.
    const double largest = closed ? contact.lift_off_force() : force;
    EXPECT_NEAR(back, largest, 1e-9 * largest);
    double p;
    ASSERT_EQ(contact_joint_pressure(both.c.get(), force, half_angle / 3, &p),
              CONTACT_OK);
    expect_same(p, contact.pressure(half_angle / 3, force, half_angle));
    ASSERT_EQ(contact_joint_pressure(both.c.get(), force, 0, &p), CONTACT_OK);
    // Lifted contacts have p(0) in a table of its own, good to 1e-7.
    const bool lifted = contact.state(force) == ContactState::lifted;
    EXPECT_NEAR(p, patch.peak_pressure, (lifted ? 1e-7 : 1e-12) * p);
    contact_friction f;
    const contact_status known =
        contact_joint_friction(both.c.get(), half_angle, 0.3, &f);
    if (closed) {
      expect_failure(
          known, CONTACT_OUT_OF_RANGE,
          "contact_joint_friction: half_angle = 3.141592653589793 must be "
          "below pi rad: coefficients of a contact that is closed "
          "all round depend on its load");
      continue;
    }
    ASSERT_EQ(known, CONTACT_OK);
    const auto i = contact.integrals(half_angle, SlipAxis::from_angle(0.3), {});
    expect_same(f.coefficient[0], i.coefficient.force);
    expect_same(f.coefficient[1], i.coefficient.sliding);
    expect_same(f.coefficient[2], i.coefficient.spinning);
    expect_same(f.area[0], i.area.force);
    expect_same(f.area[1], i.area.sliding);
    expect_same(f.area[2], i.area.spinning);
  }
}

// A stress of pressure and speed is solved, but its integrals are no two
// functions of the half-angle and the slip axis.
TEST(JointFromC, FrictionStressHasNoCoefficients) {
  const std::string file = CONTACT_DATA_DIR "/duty/stribeck_pin.toml";
  const CJoint pin = c_joint(file);
  const contact_slip slip = {{2000, 0, 0}, {0, 0, 3}, {}};
  contact_solution solution;
  ASSERT_EQ(contact_joint_solve(pin.get(), &slip, nullptr, &solution),
            CONTACT_OK);
  expect_same(
      solution.friction_moment,
      Joint(read_joint(file).contact())
          .solve({.reaction = {2000, 0, 0}, .angular_velocity = {0, 0, 3}})
          .friction_moment);
  contact_friction friction;
  EXPECT_EQ(contact_joint_friction(pin.get(), 0.5, 0.3, &friction),
            CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::string(contact_last_message())
                  .starts_with("contact_joint_friction: joint must be one"));
}

// The stiffness is the slope of the approach: central differences, to 1e-6.
TEST(JointFromC, ApproachHasItsSlope) {
  const CJoint hip = c_joint(joints + "hip_cocr_uhmwpe.toml");
  double less, more, at, stiffness, ignored;
  const double force = 1500, step = 1;
  ASSERT_EQ(contact_joint_approach(hip.get(), force, &at, &stiffness),
            CONTACT_OK);
  contact_joint_approach(hip.get(), force - step, &less, &ignored);
  contact_joint_approach(hip.get(), force + step, &more, &ignored);
  EXPECT_LT(less, at);
  EXPECT_NEAR(2 * step / (more - less), stiffness, 1e-5 * stiffness);
}

std::string contents(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(JointFromC, IsTheSameFromAFileATextAndNumbers) {
  const std::string file = joints + "pin_joint.toml";
  contact_joint* read = nullptr;
  contact_joint* parsed = nullptr;
  contact_joint* made = nullptr;
  const contact_setting longer = {"geometry.length_mm", "70"};
  ASSERT_EQ(contact_joint_read(file.c_str(), &longer, 1, &read), CONTACT_OK);
  const std::string text = contents(file);
  ASSERT_EQ(
      contact_joint_parse(text.c_str(), joints.c_str(), &longer, 1, &parsed),
      CONTACT_OK)
      << contact_last_message();
  const auto spec = read_joint(file);
  contact_joint_numbers numbers = {};
  numbers.kind = CONTACT_PIN;
  numbers.radius = spec.geometry.radius();
  numbers.radial_clearance = spec.geometry.radial_clearance();
  numbers.length = 0.07;
  numbers.inner = {spec.pair().inner().youngs_modulus,
                   spec.pair().inner().poissons_ratio};
  numbers.outer = {spec.pair().outer().youngs_modulus,
                   spec.pair().outer().poissons_ratio};
  numbers.coefficient = 0.1;
  ASSERT_EQ(contact_joint_make(&numbers, &made), CONTACT_OK);
  const contact_slip slip = {{3000, 0, 100}, {0, 0, 2}, {}};
  contact_solution s[3];
  contact_joint* all[] = {read, parsed, made};
  for (int i = 0; i < 3; ++i) {
    contact_joint_size size = {};
    ASSERT_EQ(contact_joint_get_size(all[i], &size), CONTACT_OK);
    EXPECT_EQ(size.kind, CONTACT_PIN);
    EXPECT_EQ(size.body_has_inner, 0);
    EXPECT_EQ(size.radius, spec.geometry.radius());
    EXPECT_EQ(size.radial_clearance, spec.geometry.radial_clearance());
    EXPECT_EQ(size.length, 0.07);
    EXPECT_EQ(size.effective_modulus, spec.pair().effective_modulus());
    ASSERT_EQ(contact_joint_solve(all[i], &slip, nullptr, &s[i]), CONTACT_OK);
    contact_joint_free(all[i]);
  }
  for (int i = 1; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      expect_same(s[i].friction_moment[k], s[0].friction_moment[k]);
    }
    expect_same(s[i].peak_pressure, s[0].peak_pressure);
  }
}

TEST(JointFromC, MadeOfNumbersHasTheirFrictionAndLaws) {
  const ElasticPair pair({2e11, 0.3}, {1e11, 0.34});
  contact_joint_numbers n = {};
  n.body_has_inner = 1;
  n.radius = 0.02;
  n.radial_clearance = 1e-4;
  n.inner = {2e11, 0.3};
  n.outer = {1e11, 0.34};
  n.half_angle_law = "tanh";
  n.pressure_law = "cosine";
  n.coefficient = 0.2;
  n.adhesion = 1e5;
  n.viscous_constant = 3e4;
  n.viscous_slope = 0.01;
  const auto geometry = JointGeometry::ball(0.02, 1e-4, JointBody::body);
  const auto ball = JointKind::ball;
  const auto cpp = [&](FrictionModel friction) {
    return Joint({geometry, pair, friction,
                  make_half_angle_law("tanh", ball, pair),
                  make_pressure_law("cosine", ball, pair)});
  };
  const Joint::Slip slip = {{10, 200, 3000}, {1, 0.2, 0.5}};
  for (const bool viscous : {false, true}) {
    n.viscous = viscous;
    contact_joint* joint = nullptr;
    ASSERT_EQ(contact_joint_make(&n, &joint), CONTACT_OK);
    const contact_slip c = c_slip(slip);
    contact_solution s;
    ASSERT_EQ(contact_joint_solve(joint, &c, nullptr, &s), CONTACT_OK);
    if (viscous) {
      expect_same(s, cpp(ViscousLaw(3e4, 0.01)).solve(slip));
    } else {
      expect_same(s, cpp(FrictionLaw(0.2, 1e5)).solve(slip));
    }
    contact_joint_free(joint);
  }
}

TEST(JointFromC, SaysWhereItLeavesTheTheory) {
  const CJoint fine = c_joint(joints + "pin_joint.toml");
  EXPECT_EQ(contact_joint_note(fine.get(), 0), nullptr);
  const contact_setting loose = {"geometry.radial_clearance_um", "2000"};
  contact_joint* joint = nullptr;
  ASSERT_EQ(contact_joint_read((joints + "pin_joint.toml").c_str(), &loose, 1,
                               &joint),
            CONTACT_OK);
  ASSERT_NE(contact_joint_note(joint, 0), nullptr);
  EXPECT_TRUE(has_text(std::string(contact_joint_note(joint, 0)), "clearance"));
  contact_joint_free(joint);
}

// All quantities of interference without load, and joints without them.
TEST(JointFromC, InterferenceIsThatOfCpp) {
  const std::string file = joints + "lined_bush_pressed.toml";
  const CJoint pin = c_joint(file);
  const Joint cpp(read_joint(file).contact());
  const auto& contact = cpp.contact();
  const auto got = [&](double force, const char* key) {
    double value = 0;
    EXPECT_EQ(contact_patch_get(pin.get(), force, key, &value), CONTACT_OK);
    return value;
  };
  expect_same(got(0, "interference_pressure"), contact.interference_pressure());
  expect_same(got(0, "lift_off_force"), contact.lift_off_force());
  const double moment = contact.unloaded_moment(0);
  expect_same(got(0, "unloaded_moment"), moment);
  for (const double force : {0., 2000., 3500., 9000.}) {
    const double half_angle = contact.half_angle(force).half_angle;
    expect_same(got(force, "sum_of_pressures"),
                contact.sum_of_pressures(force, half_angle));
    expect_same(got(force, "shift"), contact.shift(force, half_angle));
  }
  const contact_slip turning = {{0, 0, 0}, {0, 0, 3}, {0, 0, 1}};
  contact_solution s;
  ASSERT_EQ(contact_joint_solve(pin.get(), &turning, nullptr, &s), CONTACT_OK);
  EXPECT_EQ(s.state, CONTACT_SLIDING);
  EXPECT_NEAR(s.friction_moment[2], -moment, 1e-13 * moment);
  const contact_hold hold = {{0, 0, 0}, {0, 0, 0.5 * moment}, {0, 0, 1}};
  contact_rest rest;
  ASSERT_EQ(contact_joint_at_rest(pin.get(), &hold, nullptr, &rest),
            CONTACT_OK);
  EXPECT_NEAR(rest.utilisation, 0.5, 1e-13);

  contact_joint_numbers n = {};
  n.kind = CONTACT_PIN;
  n.radius = 0.01;
  n.radial_clearance = -1e-6;
  n.length = 0.01;
  n.inner = {2.1e11, 0.3};
  n.outer = {1e11, 0.3};
  n.coefficient = 0.1;
  n.half_angle_law = "fitted";
  contact_joint* none = nullptr;
  expect_failure(contact_joint_make(&n, &none), CONTACT_BAD_INPUT,
                 "half-angle law fitted must be exact with interference");
  // An incompressible pin in a rigid hole.
  n.half_angle_law = nullptr;
  n.inner.poissons_ratio = 0.5;
  n.outer.youngs_modulus = INFINITY;
  EXPECT_EQ(contact_joint_make(&n, &none), CONTACT_BAD_INPUT);
  EXPECT_TRUE(has_text(contact_last_message(), "incompressible"))
      << contact_last_message();
}

TEST(CJoint, StepsAreThoseOfCpp) {
  const CJoint ball = c_joint(joints + "paper_example_2.toml");
  const CJoint pin = c_joint(joints + "wheel_pin.toml");
  const Joint cpp_ball(read_joint(joints + "paper_example_2.toml"));
  const Joint cpp_pin(read_joint(joints + "wheel_pin.toml"));
  const auto expect_step = [](const contact_step& a, const JointStep& b) {
    EXPECT_EQ(static_cast<int>(a.status), static_cast<int>(b.status));
    EXPECT_EQ(a.holds, b.holds);
    expect_same(a.angular_velocity, b.angular_velocity);
    expect_same(a.moment, b.moment);
    expect_same(a.solution, b.solution);
    expect_same(a.rest.utilisation, b.rest.utilisation);
  };
  const auto cpp = [](const contact_step_start& s) {
    return StepStart{Vector3d(s.reaction), Vector3d(s.angular_velocity),
                     Vector3d(s.free), Vector3d(s.axis)};
  };
  std::vector<contact_step_start> starts = {
      {{3e5, 1e5, 2e4}, {0, 1, 0.5}, {2, 1, 0}, {0, 0, 0}},
      {{3e2, 1e2, 0}, {0, 0, 0}, {0, 0, 0.1}, {0, 0, 1}}};
  const double w[9] = {2e4, 1e3, 0, 1e3, 3e4, 0, 0, 0, 1e4};
  const Eigen::Matrix3d matrix(w);
  contact_step step = {};
  JointStep last;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(contact_joint_step(ball.get(), &starts[0], w, &step, &step),
              CONTACT_OK);
    last = contact::step(cpp_ball, cpp(starts[0]), matrix, last);
    expect_step(step, last);
    std::copy_n(step.angular_velocity, 3, starts[0].angular_velocity);
  }

  const contact_joint* both[] = {ball.get(), pin.get()};
  const Joint* cpp_both[] = {&cpp_ball, &cpp_pin};
  const StepStart cpp_starts[] = {cpp(starts[0]), cpp(starts[1])};
  Eigen::Matrix4d mass = Eigen::Matrix4d::Identity();
  mass.topLeftCorner<3, 3>() = matrix;
  mass.row(3) << 3, 2, 1, 50;
  mass.col(3) << 3, 2, 1, 50;
  std::vector<contact_step> steps(2);
  std::vector<JointStep> cpp_steps(2);
  contact_sweeps sweeps;
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(contact_joints_step(both, 2, starts.data(), mass.data(),
                                  steps.data(), &sweeps),
              CONTACT_OK);
    const StepSweeps done =
        contact::step(cpp_both, cpp_starts, mass, cpp_steps);
    EXPECT_EQ(sweeps.sweeps, done.sweeps);
    expect_same(sweeps.residual, done.residual);
    for (int k = 0; k < 2; ++k) expect_step(steps[k], cpp_steps[k]);
  }

  starts[1].axis[2] = 0;
  expect_failure(contact_joints_step(both, 2, starts.data(), mass.data(),
                                     steps.data(), nullptr),
                 CONTACT_BAD_INPUT,
                 "contact_joints_step: starts[1].axis must be the axis of the "
                 "pin, other than 0");
  starts[0].free[0] = NAN;
  EXPECT_EQ(contact_joint_step(ball.get(), &starts[0], w, nullptr, &step),
            CONTACT_OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(step.moment[0]));
  expect_failure(
      contact_joint_step(ball.get(), &starts[0], nullptr, nullptr, &step),
      CONTACT_BAD_INPUT, "contact_joint_step: inertia must be other than NULL");
  const double none[9] = {};
  expect_failure(
      contact_joint_step(ball.get(), &starts[0], none, nullptr, &step),
      CONTACT_BAD_INPUT,
      "contact_joint_step: inertia must be symmetric and positive definite, of "
      "a pin positive about its axis");
  EXPECT_EQ(step.status, CONTACT_BAD_INPUT);
  EXPECT_TRUE(std::isnan(step.moment[0]));
  starts[1].axis[2] = 1;
  mass(3, 3) = -50;
  expect_failure(contact_joints_step(both, 2, starts.data(), mass.data(),
                                     steps.data(), nullptr),
                 CONTACT_BAD_INPUT,
                 "step: inertia of joint 1 must be positive definite");
}

// The notes of contacts equal the notes of C++, by every number.
TEST(CJoint, HasNotesOnContacts) {
  const std::string file = CONTACT_DATA_DIR "/joints/hip_cocr_uhmwpe.toml";
  const CJoint joint = c_joint(file);
  const JointSpec spec = read_joint(file);
  const JointContact contact = spec.contact();
  char text[4000];
  for (const double half_angle : {0.1, 1.5}) {
    for (const double pressure : {1e5, 1e9}) {
      ASSERT_EQ(contact_joint_contact_notes(joint.get(), half_angle, pressure,
                                            text, sizeof text),
                CONTACT_OK);
      LargestContact largest;
      largest.add(half_angle, pressure);
      const auto notes = contact.limits().notes(largest);
      EXPECT_EQ(text, detail::joined(notes, "\n"));
      EXPECT_EQ(notes.empty(), pressure == 1e5);
    }
  }
  ASSERT_EQ(contact_joint_contact_notes(joint.get(), NAN, NAN, text, 4000),
            CONTACT_OK);
  EXPECT_EQ(text[0], 0);
}

// As C libraries with small stacks have them. Debug builds take more.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
TEST(CJointStack, IsAsSmallAsThePageSays) {
  struct Reading {
    std::string file;
    contact_status status = CONTACT_FAILURE;
  };
  const auto read = [](void* given) -> void* {
    auto& reading = *static_cast<Reading*>(given);
    contact_joint* joint = nullptr;
    reading.status =
        contact_joint_read(reading.file.c_str(), nullptr, 0, &joint);
    contact_joint_free(joint);
    return nullptr;
  };
  for (const auto& [name, stack] : {std::pair("hip_cocr_uhmwpe", 128),
                                    {"pin_joint", 128},
                                    {"spherical_plain_bearing", 128},
                                    {"relieved_bush", 384},
                                    {"lined_bush_pressed", 384}}) {
    Reading reading = {std::string(CONTACT_DATA_DIR "/joints/") + name +
                       ".toml"};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes,
                              static_cast<std::size_t>(stack) * 1024);
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, read, &reading), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    EXPECT_EQ(reading.status, CONTACT_OK) << name;
  }
}
#endif

}  // namespace
}  // namespace contact::test::joint_test
