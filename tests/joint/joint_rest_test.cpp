#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/joints.hpp"
#include "support/long_run.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::joint_rest_test {
namespace {

using Eigen::Vector3d;

// Sliding about u needs just the moment that makes the joint slide about u.
TEST(JointAtRest, OnsetOfSlipIsTheLimitOfSlowSliding) {
  RandomSlips random(1);
  // The moments that a contact holds are a flat body, theta0 times as thick
  // as wide, and under strong adhesion (tan psi) they turn quickly with b:
  // the rounding of M and R counts (1 + tan psi)/theta0 times.
  AccuracyReport plain("tau of tau M_t(R, u), condition below 100", 1e-12);
  AccuracyReport scaled("tau of tau M_t(R, u) over condition", 3e-14);
  AccuracyReport moment("slip.friction_moment against M/tau", 1e-12);
  AccuracyReport warm_report("warm against cold tau over condition", 3e-14);
  int compared = 0;
  double most_solves = 0;
  double cold_solves = 0;
  int cold = 0;
  for (int i = 0; i < 1500; ++i) {
    const RandomSlip input = random.next();
    const JointSolution slip = input.joint.solve(input.slip());
    if (slip.power == 0) continue;
    const double condition =
        (1 + slip.memory.tangent) / std::min(1.0, slip.half_angle);
    const double tau = random.log_uniform(1e-3, 1e3);
    const Vector3d m = tau * slip.friction_moment;
    const RestSolution rest = input.joint.at_rest({input.reaction, m});
    const std::string label = "input " + std::to_string(i);
    ASSERT_EQ(rest.status, Status::ok) << label;
    if (slip.memory.tangent < 0.5) {
      cold_solves += rest.solves;
      ++cold;
    }
    moment.add_error(
        magnitude(rest.slip.friction_moment - m / rest.utilisation) /
            magnitude(rest.slip.friction_moment),
        label);
    EXPECT_NEAR(rest.direction.norm(), 1, 1e-14);
    const double error = std::abs(rest.utilisation / tau - 1);
    if (condition < 100) plain.add_error(error, label);
    scaled.add_error(error / condition, label);
    const RestSolution warm = input.joint.at_rest(
        {input.reaction, m + 1e-3 * m.norm() * random.direction()}, rest);
    ASSERT_EQ(warm.status, Status::ok) << label;
    const RestSolution back = input.joint.at_rest({input.reaction, m}, warm);
    warm_report.add_error(
        std::abs(back.utilisation / rest.utilisation - 1) / condition, label);
    most_solves = std::max<double>(most_solves, back.solves);
    ++compared;
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(plain.size(), 300u);
  std::printf("sliding solutions: %g of %d, warm at most %g\n",
              cold_solves / cold, cold, most_solves);
  // One equation finds the slip axis; 16 intervals of b took 22 to 26.
  EXPECT_LE(cold_solves, 5 * cold);
}

// Counts the evaluations of contacts: without a slope each asks the law.
class CountingLaw final : public HalfAngleLaw {
 public:
  explicit CountingLaw(const char* name)
      : HalfAngleLaw(JointKind::ball),
        law_(make_half_angle_law(name, JointKind::ball, steel_in_steel)) {}
  std::string name() const override { return law_->name(); }
  HalfAngleResult half_angle(double load) const noexcept override {
    ++count;
    const HalfAngleResult of = law_->half_angle(load);
    return {of.half_angle, of.status};
  }
  LoadParameterResult load_parameter(double angle) const noexcept override {
    return law_->load_parameter(angle);
  }
  double limit_half_angle() const noexcept override {
    return law_->limit_half_angle();
  }
  std::vector<std::string> validity_notes(const ElasticPair&) const override {
    return {};
  }
  mutable long count = 0;

 private:
  std::unique_ptr<const HalfAngleLaw> law_;
};

// The utilisation of a moment at this angle from the reaction, along Z, as
// at_rest() found it before: a solution at each of 16 angles of u, and steps in
// the interval where the moment passes.
double searched(const Joint& joint, double force, double angle, double needed) {
  JointSolution last;
  const auto excess = [&](double c) {
    last = joint.solve({{0, 0, force}, {std::sin(c), 0, std::cos(c)}}, last);
    const Vector3d& m = last.friction_moment;
    return std::atan2(std::hypot(m.x(), m.y()), -m.z()) - angle;
  };
  double low = 0;
  double at_low = excess(low);
  for (int i = 1; i <= 16; ++i) {
    double high = pi * i / 16;
    double at_high = excess(high);
    if (at_low <= 0 && at_high >= 0) {
      while (low == 0 && at_low < 0) {
        const double value = excess(high / 16);
        (value <= 0 ? low : high) = high / 16;
        (value <= 0 ? at_low : at_high) = value;
      }
      excess(shrink_bracket(excess, low, high, at_low, at_high, 52).middle());
      const double found = needed / magnitude(last.friction_moment);
      while (++i <= 16) excess(pi * i / 16);  // for other roots
      return found;
    }
    low = high;
    at_low = at_high;
  }
  return nan;
}

// 1e5 states each in long runs: 8.2e-14 at most, 5.1 to 5.4 times fewer.
TEST(JointAtRest, SaysTheSameByAFifthOfTheEvaluations) {
  for (const char* name : {"tanh", "fitted"}) {
    for (const double f0 : {0.06, 0.2, 0.5}) {
      const auto law = std::make_shared<CountingLaw>(name);
      const Joint joint(JointContact(
          JointGeometry::ball(0.05, 0.05e-3), steel_in_steel, FrictionLaw(f0),
          law, std::make_shared<CosinePressure>(JointKind::ball)));
      const double unit = 1 / joint.contact().load_parameter(1);
      const std::string label = std::string(name) + ' ' + std::to_string(f0);
      AccuracyReport same("utilisation by the search, " + label, 1e-12);
      RandomSlips random(5);
      long before = 0, now = 0;
      const int states = 100'000 / every(200);
      for (int i = 0; i < states; ++i) {
        const double force = unit * random.log_uniform(1e-3, 10);
        const double angle = std::acos(random.uniform());
        law->count = 0;
        const double expected = searched(joint, force, angle, 0.1);
        before += law->count;
        law->count = 0;
        const RestSolution rest =
            joint.at_rest({{0, 0, force},
                           {0.1 * std::sin(angle), 0, -0.1 * std::cos(angle)}});
        now += law->count;
        ASSERT_EQ(rest.status, Status::ok);
        same.add(rest.utilisation, expected, "state " + std::to_string(i));
      }
      std::printf("%s: %.1f evaluations, %.1f by the search\n", label.c_str(),
                  double(now) / states, double(before) / states);
      EXPECT_LE(5 * now, before) << label;
    }
  }
}

// n = R/|R| at rest would hold too much: the traditional error.
TEST(JointAtRest, HoldsLessThanTheContactUnderTheWholeReaction) {
  struct Case {
    const char* file;
    double force, least, most;  // how much more the other would hold
  };
  for (const Case& c : {Case{"paper_example_1", 2.63e5, 1.0, 1.174},
                        Case{"paper_example_2", 1.1676e6, 1.0, 1.966}}) {
    const Joint joint(read_joint(std::filesystem::path(CONTACT_DATA_DIR) /
                                 "joints" / (std::string(c.file) + ".toml"))
                          .contact());
    const Vector3d reaction(0, 0, c.force);
    const MomentSet whole =
        joint.moment_set(joint.solve({reaction, Vector3d::Zero()}));
    double least = infinity;
    double most = 0;
    for (int i = 0; i <= 90; ++i) {
      const double angle = i * pi / 180;
      const Vector3d m(1e3 * std::sin(angle), 0, 1e3 * std::cos(angle));
      const double ratio =
          joint.at_rest({reaction, m}).utilisation / whole.utilisation(m);
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
    std::printf("%s: holds %.4f to %.4f times less\n", c.file, least, most);
    EXPECT_NEAR(least, c.least, 1e-9);
    EXPECT_NEAR(most, c.most,
                0.5e-3);  // as printed in docs/explanation/joint.md
  }
}

TEST(JointAtRest, NoMomentNoSlip) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const Vector3d reaction(3e4, 0, 4e4);
  const RestSolution rest = joint.at_rest({reaction, Vector3d::Zero()});
  EXPECT_EQ(rest.status, Status::ok);
  EXPECT_EQ(rest.utilisation, 0);
  EXPECT_EQ(rest.slip.state, JointState::resting);
  EXPECT_TRUE(rest.slip.normal.isApprox(reaction / 5e4, 1e-15));
  EXPECT_EQ(rest.direction, Vector3d::Zero());
  // Towards it.
  const RestSolution near = joint.at_rest({reaction, {1e-9, 0, 0}});
  EXPECT_EQ(near.status, Status::ok);
  EXPECT_GT(near.utilisation, 0);
  EXPECT_LT(near.utilisation, 1e-9);
}

TEST(JointAtRest, MomentsAlongAndAcrossTheReaction) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const Vector3d reaction(0, 0, 1e5);
  for (const double sign : {1.0, -1.0}) {
    // Spinning about R.
    const RestSolution spin = joint.at_rest({reaction, {0, 0, 10 * sign}});
    EXPECT_EQ(spin.status, Status::ok);
    EXPECT_LE((spin.direction - Vector3d(0, 0, -sign)).norm(), 1e-14);
    EXPECT_NEAR(spin.utilisation * spin.slip.friction_moment.z(), 10 * sign,
                1e-11);
    // Sliding about an axis normal to R: a = 0.
    const RestSolution slide = joint.at_rest({reaction, {10 * sign, 0, 0}});
    EXPECT_EQ(slide.status, Status::ok);
    EXPECT_LE((slide.direction - Vector3d(-sign, 0, 0)).norm(), 1e-14);
    EXPECT_NEAR(slide.slip.slip_axis_angle(), 0, 1e-14);
  }
}

TEST(JointAtRest, WithoutFrictionOrLoadHoldsNothing) {
  const Vector3d m(1, 2, 3);
  const Vector3d reaction(0, 0, 1e5);
  EXPECT_EQ(steel_ball(FrictionLaw(0)).at_rest({reaction, m}).utilisation,
            infinity);
  const Joint viscous = steel_ball(ViscousLaw(1e6, 0.1));
  EXPECT_EQ(viscous.at_rest({reaction, m}).utilisation, infinity);
  EXPECT_EQ(viscous.at_rest({reaction, Vector3d::Zero()}).utilisation, 0);
  const Joint dry = steel_ball(FrictionLaw(0.2));
  EXPECT_EQ(dry.at_rest({Vector3d::Zero(), m}).utilisation, infinity);
}

// Vectors may lie anywhere that a double may.
TEST(JointAtRest, BitsAreThoseOfNumbersNotOfAddresses) {
  RandomSlips random(2);
  alignas(16) std::array<std::byte, sizeof(Joint::Hold) + 8> aligned, shifted;
  for (int i = 0; i < 200; ++i) {
    const RandomSlip input = random.next();
    const Joint::Slip slip = input.slip();
    const Joint::Hold hold = {slip.reaction, slip.angular_velocity};
    const auto& a = *new (aligned.data()) Joint::Hold(hold);
    const auto& b = *new (shifted.data() + 8) Joint::Hold(hold);
    EXPECT_EQ(input.joint.at_rest(a).utilisation,
              input.joint.at_rest(b).utilisation)
        << i;
  }
}

TEST(JointAtRest, NanGivesNanAndNothingAllocates) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const std::size_t before = allocation_count();
  for (const double bad : {nan, infinity}) {
    for (const RestSolution& rest :
         {joint.at_rest({{bad, 0, 0}, {0, 0, 1}}),
          joint.at_rest({{1e5, 0, 0}, {0, 0, bad}})}) {
      EXPECT_EQ(rest.status, Status::out_of_range);
      EXPECT_TRUE(std::isnan(rest.utilisation));
      EXPECT_TRUE(rest.direction.hasNaN());
    }
  }
  const RestSolution rest = joint.at_rest({{1e5, 0, 0}, {1, 2, 3}});
  joint.at_rest({{1e5, 0, 0}, {1, 2, 3.003}}, rest);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace contact::test::joint_rest_test
