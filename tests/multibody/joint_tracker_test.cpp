#include "multibody/tracking/joint_tracker.hpp"
#include "libcontact/base/instruction_set.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pressure/factory.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

// Joints tracked along paths against the solvers, which start from nothing
// at every point.
namespace contact::test::joint_tracker_test {
namespace {

using Eigen::Vector3d;
using multibody::JointTracker;

ElasticPair steel() { return ElasticPair({2e11, 0.3}, {2e11, 0.3}); }

struct LawNames {
  const char* half_angle = "tanh";
  const char* pressure = "cosine";
  std::optional<double> limit_half_angle = {};  // deg
};

JointContact contact_of(JointKind kind, const FrictionModel& friction,
                        JointBody inner = JointBody::carrier,
                        const LawNames& laws = {}) {
  const ElasticPair pair = steel();
  HalfAngleOptions options;
  if (laws.limit_half_angle) {
    options.limit_half_angle = *laws.limit_half_angle * degree;
  }
  return {kind == JointKind::ball ? JointGeometry::ball(0.05, 5e-5, inner)
                                  : JointGeometry::pin(0.05, 5e-5, 0.1, inner),
          pair, friction,
          make_half_angle_law(laws.half_angle, kind, pair, options),
          make_pressure_law(laws.pressure, kind, pair)};
}

// A joint on a path of R and Dw.
struct Path {
  JointContact contact;
  Vector3d reaction, rate;            // at 0
  Vector3d reaction_axis, rate_axis;  // about which they turn, 1 rad per unit
  double growth;                      // rate of ln R and ln |Dw| per unit

  bool is_pin() const { return contact.geometry().kind() == JointKind::pin; }
  Vector3d rate_at(double t) const {
    Vector3d w = std::exp(-growth * t) * rate;
    if (is_pin()) return w;
    return Eigen::AngleAxisd(t, rate_axis) * w;
  }
  Vector3d reaction_at(double t) const {
    const Vector3d r = std::exp(growth * t) * reaction;
    return Eigen::AngleAxisd(t, is_pin() ? rate.normalized() : reaction_axis) *
           r;
  }
  JointSolution solve(double t) const {
    return solve(reaction_at(t), rate_at(t));
  }
  JointSolution solve(const Vector3d& r, const Vector3d& w) const {
    return Joint(contact).solve(
        {.reaction = r, .angular_velocity = w, .axis = rate.normalized()});
  }
};

// Dry and viscous, balls on either side and pins, b from 10 to 170 deg; with
// contacts from 5 to 80 deg.
std::vector<Path> paths(std::uint64_t seed, int count) {
  RandomSlips random(seed);
  std::vector<Path> all;
  while (static_cast<int>(all.size()) < count) {
    const double f0 = random.log_uniform(0.02, 0.8);
    const double adhesion = random.uniform() < 0.3 ? 0 : f0 * 1e8;
    FrictionModel friction = FrictionLaw(f0, adhesion);
    if (random.uniform() < 0.2) friction = ViscousLaw(f0 * 1e8, f0);
    const JointKind kind =
        random.uniform() < 0.25 ? JointKind::pin : JointKind::ball;
    const JointBody inner =
        random.uniform() < 0.5 ? JointBody::carrier : JointBody::body;
    const double force = random.log_uniform(1e3, 1e6);
    // One after the other: compilers differ in which operand is drawn first.
    const Vector3d pull = force * random.direction();
    const Vector3d turn = random.direction();
    const double speed = random.log_uniform(0.1, 10);
    Path path{contact_of(kind, friction, inner),
              pull,
              speed * turn,
              random.direction(),
              random.direction(),
              2 * random.uniform() - 1};
    const Vector3d axis = path.rate.normalized();
    if (path.is_pin()) {
      path.reaction = force * axis.unitOrthogonal();
    } else if (axis.cross(path.reaction).norm() < 0.17 * force) {
      continue;
    }
    all.push_back(path);
  }
  return all;
}

std::vector<JointContact> contacts(const std::vector<Path>& all) {
  std::vector<JointContact> result;
  for (const Path& path : all) result.push_back(path.contact);
  return result;
}

void go_to(JointTracker& tracker, const std::vector<Path>& all, double t) {
  for (int i = 0; i < tracker.size(); ++i) {
    tracker.set_reaction(i, all[i].reaction_at(t));
    tracker.set_rate(i, all[i].rate_at(t));
  }
}

void advance(JointTracker& tracker, const std::vector<Path>& all, double t) {
  go_to(tracker, all, t);
  tracker.predict();
  tracker.correct();
}

void start(JointTracker& tracker, const std::vector<Path>& all, double t) {
  for (int i = 0; i < tracker.size(); ++i) {
    tracker.start(i, all[i].solve(t), all[i].rate_at(t));
    ASSERT_TRUE(tracker.is_tracked(i));
  }
}

JointTracker started(const std::vector<Path>& all) {
  JointTracker tracker(contacts(all));
  start(tracker, all, 0);
  return tracker;
}

double relative_error(const Vector3d& found, const JointSolution& expected) {
  return (found - expected.friction_moment).norm() /
         expected.friction_moment.norm();
}

// Largest relative errors of M_t, and the largest error over error().
struct Errors {
  double predicted = 0, evaluated = 0, share = 0;
};

// 20 steps of all paths.
Errors track(const std::vector<Path>& all, double step) {
  JointTracker tracker = started(all);
  Errors largest;
  for (int k = 1; k <= 20; ++k) {
    go_to(tracker, all, k * step);
    tracker.predict();
    std::vector<Vector3d> guess;
    for (int i = 0; i < tracker.size(); ++i) {
      EXPECT_TRUE(tracker.is_trusted(i));
      guess.push_back(tracker.moment(i));
    }
    tracker.correct();
    for (int i = 0; i < tracker.size(); ++i) {
      EXPECT_TRUE(tracker.is_trusted(i));
      const JointSolution expected = all[i].solve(k * step);
      EXPECT_EQ(expected.status, Status::ok);
      const double own = relative_error(tracker.moment(i), expected);
      largest.predicted =
          std::max(largest.predicted, relative_error(guess[i], expected));
      largest.evaluated = std::max(largest.evaluated, own);
      // 1e-12: the solver's tolerance and rounding.
      largest.share = std::max(largest.share, own / (tracker.error(i) + 1e-12));
    }
  }
  std::printf("step %g: predicted %.1e, evaluated %.1e, over error() %.2g\n",
              step, largest.predicted, largest.evaluated, largest.share);
  return largest;
}

class JointTrackerSteps : public testing::TestWithParam<double> {};

// One evaluation for each step leaves what error() says; the prediction before
// it is of second order in the step. Measured: 25 step^2, 220 step^3, of
// error() 0.16.
TEST_P(JointTrackerSteps, TracksPaths) {
  const double step = GetParam();
  const Errors largest = track(paths(1, 200), step);
  EXPECT_LT(largest.predicted, 200 * step * step + 1e-12);
  // Third order and more: the slopes are wrong by a step, what is left to go
  // is a step squared.
  EXPECT_LT(largest.evaluated, 4000 * step * step * step + 1e-12);
  EXPECT_LT(largest.share, 1);
}
INSTANTIATE_TEST_SUITE_P(Steps, JointTrackerSteps,
                         testing::Values(1e-3, 1e-4, 1e-5));

// On paths that were not used to calibrate error(), some of them 20 times more
// curved. Measured: 0.62 of error().
TEST(JointTracker, ErrorIsNotExceededOnOtherPaths) {
  for (const std::uint64_t seed : {11, 12, 13, 14, 15}) {
    const std::vector<Path> all = paths(seed, 200);
    for (const double step : {1e-3, 1e-4}) {
      EXPECT_LT(track(all, step).share, 1) << "paths " << seed;
    }
  }
}

// The window of a pin gives slope and curvature: the error of its prediction is
// of third order in the step. Measured: 4.4e-10 and 7e-12, 0.007 step^3.
TEST(JointTracker, PinsArePredictedToThirdOrder) {
  std::vector<Path> all = paths(12, 400);
  std::erase_if(all, [](const Path& path) { return !path.is_pin(); });
  for (const double step : {4e-3, 1e-3}) {
    JointTracker tracker = started(all);
    double largest = 0;
    for (int k = 1; k <= 8; ++k) {
      go_to(tracker, all, k * step);
      tracker.predict();
      // The window is there from the first correction on, and is used by the
      // second.
      for (int i = 0; k > 2 && i < tracker.size(); ++i) {
        largest = std::max(
            largest, relative_error(tracker.moment(i), all[i].solve(k * step)));
      }
      tracker.correct();
    }
    std::printf("step %g: %.1e\n", step, largest);
    EXPECT_LT(largest, 0.05 * step * step * step);
  }
}

// Against differences of the solver's moments.
TEST(JointTracker, MomentsChangeWithTheReactionAsTheySay) {
  const std::vector<Path> all = paths(2, 100);
  JointTracker tracker = started(all);
  // So that the evaluated contact is not the one of the start.
  advance(tracker, all, 1e-4);
  for (int i = 0; i < tracker.size(); ++i) {
    const Vector3d reaction = all[i].reaction_at(1e-4);
    const Vector3d rate = all[i].rate_at(1e-4);
    for (int k = 0; k < 3; ++k) {
      constexpr double h = 1e-6;
      Vector3d change = h * reaction.norm() * Vector3d::Unit(k);
      if (all[i].is_pin()) {
        const Vector3d axis = rate.normalized();
        change -= change.dot(axis) * axis;
      }
      const Vector3d expected =
          all[i].solve(reaction + change, rate).friction_moment -
          all[i].solve(reaction - change, rate).friction_moment;
      tracker.set_reaction(i, reaction + change);
      tracker.extend();
      const Vector3d up = tracker.moment(i);
      tracker.set_reaction(i, reaction - change);
      tracker.extend();
      const Vector3d found = up - tracker.moment(i);
      // Slopes from differences (1e-8), wrong by about the step of 1e-4.
      EXPECT_LT((found - expected).norm(), 1e-2 * h * tracker.moment(i).norm());
    }
  }
}

// With kernels of their own for up to four joints.
TEST(JointTracker, AllInstructionSetsAgree) {
  for (const int count : {1, 3, 4, 5, 13}) {
    const std::vector<Path> all = paths(3, count);
    std::vector<std::vector<Vector3d>> found;
    for (const InstructionSet set : supported_instruction_sets()) {
      const contact::detail::WithInstructionSet with(set);
      JointTracker tracker = started(all);
      advance(tracker, all, 1e-3);
      std::vector<Vector3d>& moments = found.emplace_back();
      for (int i = 0; i < tracker.size(); ++i) {
        moments.push_back(tracker.moment(i));
        // The slopes at the start come from differences of 1e-6 and differ by
        // the integrals' rounding over that, 4e-9; they correct what the
        // prediction missed, 2.5e-5 (joint.md).
        EXPECT_LT((moments[i] - found[0][i]).norm(), 1e-13 * moments[i].norm())
            << count;
      }
    }
  }
}

// A ball and a pin with R that grows by 30 %, through several windows in which
// the half-angle comes from a polynomial where its law is smooth.
std::vector<Path> growing(const LawNames& laws, double ball = 2e4,
                          double pin = 2e4) {
  std::vector<Path> all;
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    Path path{contact_of(kind, FrictionLaw(0.2, 1e7), JointBody::carrier, laws),
              {kind == JointKind::ball ? ball : pin, 0, 0},
              {0, 0, 1},
              {0, 0, 1},
              {0, 0, 1},
              1};
    if (kind == JointKind::ball) path.rate = {0.6, 0, 0.8};
    all.push_back(path);
  }
  return all;
}

double largest_error(const std::vector<Path>& all) {
  JointTracker tracker = started(all);
  constexpr int steps = 3000;
  double largest = 0;
  for (int k = 1; k <= steps; ++k) {
    const double t = 1e-4 * k;
    advance(tracker, all, t);
    if (k % 100 != 0) continue;
    for (int i = 0; i < tracker.size(); ++i) {
      const double here = relative_error(tracker.moment(i), all[i].solve(t));
      if (!(here <= largest)) largest = here;
    }
  }
  return largest;
}

// Measured: 1.7e-15.
TEST(JointTracker, EveryHalfAngleLawIsTrackedThroughItsWindows) {
  for (const char* const law : {"tanh", "arctan", "blend", "fitted", "exact"}) {
    const double largest = largest_error(growing({.half_angle = law}));
    std::printf("%s: %.1e\n", law, largest);
    EXPECT_LT(largest, 1e-14) << law;
  }
}

// Its cosine passes 0. Measured: 1.1e-14, of the solver, which is content with
// 1e-13.
TEST(JointTracker, AHalfAngleIsTrackedThrough90Degrees) {
  const LawNames laws = {.limit_half_angle = 115};
  const std::vector<Path> all = growing(laws, 3e6, 1.6e6);
  for (const Path& path : all) {
    const auto half_angle = [&](double t) {
      return path.contact.half_angle(path.solve(t).normal_force).half_angle /
             degree;
    };
    EXPECT_LT(half_angle(0), 89);
    EXPECT_GT(half_angle(0.3), 91);
  }
  EXPECT_LT(largest_error(all), 1e-13);
}

// A lined bush and a lined ball, with interference and without clearance.
Path pressed(JointKind kind, double clearance) {
  const bool ball = kind == JointKind::ball;
  const JointSpec spec{
      .geometry = ball ? JointGeometry::ball(0.02, clearance)
                       : JointGeometry::pin(0.02, clearance, 0.03),
      .inner = Material{2.1e11, 0.3},
      .outer = {{{0.004, Material{1e9, 0.4}}}, Backing::rigid()},
      .friction = FrictionLaw(0.1, 1e4),
      .half_angle_law = "exact"};
  Path path{spec.contact(), {1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 1};
  if (ball) path.rate = {0.6, 0, 0.8};
  return path;
}

// Closed all round, lifted off and without clearance, with R that grows by
// 20 %: 2e-12 measured. Where a contact lifts off the slopes of a pin have a
// kink: 4e-7 in the one step of 1e-3 over it.
TEST(JointTracker, JointsWithoutClearanceAreTracked) {
  for (const JointKind kind : {JointKind::pin, JointKind::ball}) {
    for (const double share : {0.2, 0.9, 1.5, 0.0}) {
      Path path = pressed(kind, share > 0 ? -2e-5 : 0);
      const double lift_off = path.contact.lift_off_force();
      path.reaction.x() = share > 0 ? share * lift_off : 1000;
      const std::vector<Path> all = {path};
      JointTracker tracker = started(all);
      double largest = 0;
      for (int k = 1; k <= 200; ++k) {
        advance(tracker, all, 1e-3 * k);
        EXPECT_TRUE(tracker.is_trusted(0)) << share;
        const double here =
            relative_error(tracker.moment(0), path.solve(1e-3 * k));
        if (!(here <= largest)) largest = here;
      }
      std::printf("%s at %g of lift-off: %.1e\n", to_string(kind).c_str(),
                  share, largest);
      EXPECT_LT(largest, share == 0.9 ? 1e-6 : 1e-11) << share;
    }
    // Without load the solver alone has an answer.
    const Path path = pressed(kind, -2e-5);
    JointTracker tracker(contacts({path}));
    const JointSolution unloaded = path.solve(Vector3d(0, 0, 0), path.rate);
    EXPECT_EQ(unloaded.state, JointState::sliding);
    tracker.start(0, unloaded, path.rate);
    EXPECT_FALSE(tracker.is_tracked(0));
  }
}

// Laws whose integrals differ from the integrals of the cosine. Measured:
// 1.8e-15.
TEST(JointTracker, EveryPressureLawIsTrackedThroughItsWindows) {
  for (const char* const law : {"sqrt_tan", "sqrt_theta", "mixture", "exact"}) {
    const double largest = largest_error(growing({.pressure = law}));
    std::printf("%s: %.1e\n", law, largest);
    EXPECT_LT(largest, 1e-14) << law;
  }
  // Through 90 degrees, where sine and cosine determine the angle. Its
  // integrals have errors of their own. Measured: 5.6e-15.
  const LawNames wide = {.pressure = "sqrt_theta", .limit_half_angle = 115};
  EXPECT_LT(largest_error(growing(wide, 3e6, 1.6e6)), 2e-14);
}

// R that depends on M_t as in a mechanism, R = R_0 + C M_t, C of every joint
// another one: moments that fit, against plain iteration of the solver.
TEST(JointTracker, AppliedMomentsComeToFitTheReactionsTheyCause) {
  std::vector<Path> all = paths(6, 40);
  std::erase_if(all, [](const Path& path) { return path.is_pin(); });
  JointTracker tracker = started(all);
  RandomSlips random(7);
  std::vector<Eigen::Matrix3d> responses;
  for (const Path& path : all) {
    const JointSolution s = path.solve(0);
    // Contraction of some percent.
    const double size = 0.02 * path.reaction.norm() / s.friction_moment.norm();
    responses.emplace_back(size * random.direction() *
                           random.direction().transpose());
  }
  const auto set_reactions = [&](double t) {
    for (int i = 0; i < tracker.size(); ++i) {
      const Vector3d change = responses[i] * tracker.applied_moment(i);
      tracker.set_reaction(i, all[i].reaction_at(t) + change);
      tracker.set_rate(i, all[i].rate_at(t));
    }
  };
  for (int i = 0; i < tracker.size(); ++i) {
    tracker.set_applied_moment(i, all[i].solve(0).friction_moment);
  }
  int changes = 0;
  constexpr int evaluations = 20;
  for (int k = 0; k < evaluations; ++k) {
    const double t = 1e-4 * k;
    if (k > 1) tracker.extrapolate(1);
    set_reactions(t);
    tracker.predict();
    for (int round = 0; round < 20; ++round) {
      if (tracker.largest().residual <= 1e-12) break;
      tracker.apply();
      ++changes;
      set_reactions(t);
      if (round == 0) {
        tracker.correct();
      } else {
        tracker.extend();
      }
    }
    EXPECT_LE(tracker.largest().residual, 1e-12);
    tracker.keep();
  }
  std::printf("%.2f changes for each evaluation\n",
              static_cast<double>(changes) / evaluations);
  EXPECT_LT(changes, 5 * evaluations);
  const double t = 1e-4 * (evaluations - 1);
  for (int i = 0; i < tracker.size(); ++i) {
    Vector3d moment = tracker.applied_moment(i);
    for (int round = 0; round < 20; ++round) {
      moment = all[i]
                   .solve(all[i].reaction_at(t) + responses[i] * moment,
                          all[i].rate_at(t))
                   .friction_moment;
    }
    EXPECT_LT((tracker.applied_moment(i) - moment).norm(),
              (tracker.error(i) + 1e-11) * moment.norm());
  }
}

std::vector<double> errors_of(const JointTracker& tracker) {
  std::vector<double> errors;
  for (int i = 0; i < tracker.size(); ++i) errors.push_back(tracker.error(i));
  return errors;
}

// The first correction learns the error of the slopes.
TEST(JointTracker, ASecondCorrectionLeavesLittle) {
  const std::vector<Path> all = paths(8, 28);
  JointTracker tracker = started(all);
  advance(tracker, all, 1e-3);
  const std::vector<double> errors = errors_of(tracker);
  EXPECT_EQ(tracker.largest().error, *std::ranges::max_element(errors));
  EXPECT_GT(tracker.largest().error, 1e-7);
  tracker.correct();
  for (int i = 0; i < tracker.size(); ++i) {
    // Or rounding.
    EXPECT_LE(tracker.error(i), 1e-3 * errors[i] + 1e-14);
    EXPECT_LT(relative_error(tracker.moment(i), all[i].solve(1e-3)), 1e-11);
  }
  const std::vector<double> later = errors_of(tracker);
  EXPECT_EQ(tracker.largest().error, *std::ranges::max_element(later));
  EXPECT_TRUE(tracker.largest().is_trusted());
}

// Contacts are evaluated where R has gone on, moments extended by their slopes.
TEST(JointTracker, CorrectsWhereItHasBeenExtended) {
  const std::vector<Path> all = paths(8, 20);
  for (const InstructionSet set : supported_instruction_sets()) {
    const contact::detail::WithInstructionSet with(set);
    JointTracker tracker = started(all);
    advance(tracker, all, 1e-3);
    const JointTracker before = tracker;
    for (int i = 0; i < tracker.size(); ++i) {
      tracker.set_reaction(
          i, (1 + 1e-5) * all[i].reaction_at(1e-3) +
                 1e-5 * all[i].reaction.norm() * all[i].reaction_axis);
    }
    JointTracker extended = tracker;
    extended.extend();
    tracker.correct();
    EXPECT_EQ(tracker.largest().uncorrected, extended.largest().residual);
    for (int i = 0; i < tracker.size(); ++i) {
      EXPECT_NE(extended.moment(i), before.moment(i));
      EXPECT_NE(tracker.moment(i), extended.moment(i));
      EXPECT_LT(tracker.error(i), extended.error(i));
    }
  }
}

TEST(JointTracker, KnowsWhenItIsLost) {
  const std::vector<Path> all = paths(4, 5);
  JointTracker tracker(contacts(all));
  EXPECT_FALSE(tracker.is_tracked(0));
  EXPECT_FALSE(tracker.is_trusted(0));
  start(tracker, all, 0);
  advance(tracker, all, 0);
  for (int i = 0; i < tracker.size(); ++i) {
    EXPECT_TRUE(tracker.is_trusted(i));
    const Vector3d reaction = all[i].reaction_at(0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vector3d& other :
         {Vector3d(2 * reaction), Vector3d(0, 0, 0), Vector3d(nan, 0, 0)}) {
      tracker.set_reaction(i, other);
      tracker.predict();
      EXPECT_FALSE(tracker.is_trusted(i)) << other.transpose();
    }
    // A solution brings it back.
    tracker.start(i, all[i].solve(0), all[i].rate_at(0));
    tracker.set_reaction(i, reaction);
    tracker.predict();
    tracker.correct();
    EXPECT_TRUE(tracker.is_trusted(i));
  }
  tracker.stop(0);
  EXPECT_FALSE(tracker.is_tracked(0));
  JointSolution resting = all[0].solve(all[0].reaction, Vector3d(0, 0, 0));
  tracker.start(0, resting, Vector3d(0, 0, 0));
  EXPECT_FALSE(tracker.is_tracked(0));
  // A solution without convergence cannot start the next one either.
  JointSolution sliding = all[0].solve(0);
  for (const Status status : {Status::not_converged, Status::out_of_range}) {
    sliding.status = status;
    tracker.start(0, sliding, all[0].rate_at(0));
    EXPECT_FALSE(tracker.is_tracked(0));
  }
}

// Across its axis alone a pin's contact feels R.
TEST(JointTracker, ForcesAlongAPinChangeNothing) {
  std::vector<Path> all = paths(13, 40);
  std::erase_if(all, [](const Path& path) { return !path.is_pin(); });
  JointTracker tracker = started(all);
  advance(tracker, all, 1e-4);
  const JointTracker before = tracker;
  for (int i = 0; i < tracker.size(); ++i) {
    const Vector3d reaction = all[i].reaction_at(1e-4);
    tracker.set_reaction(
        i, reaction + 0.1 * reaction.norm() * all[i].rate.normalized());
  }
  tracker.extend();
  for (int i = 0; i < tracker.size(); ++i) {
    // Rounding of the axis.
    EXPECT_NEAR(tracker.error(i), before.error(i), 1e-14);
    EXPECT_LT((tracker.moment(i) - before.moment(i)).norm(),
              1e-14 * before.moment(i).norm());
  }
}

// The law tanh times a factor that somebody changes.
class ChangingLaw final : public HalfAngleLaw {
 public:
  explicit ChangingLaw(const double& factor)
      : HalfAngleLaw(JointKind::ball),
        law_(make_half_angle_law("tanh", JointKind::ball, steel())),
        factor_(factor) {}
  std::string name() const override { return "changing"; }
  HalfAngleResult half_angle(double load) const noexcept override {
    HalfAngleResult result = law_->half_angle(load);
    result.half_angle *= factor_;
    return result;
  }
  LoadParameterResult load_parameter(
      double half_angle) const noexcept override {
    return law_->load_parameter(half_angle / factor_);
  }
  double limit_half_angle() const noexcept override {
    return law_->limit_half_angle();
  }
  std::vector<std::string> validity_notes(const ElasticPair&) const override {
    return {};
  }

 private:
  std::unique_ptr<const HalfAngleLaw> law_;
  const double& factor_;
};

// A contact that is another one than the last one said: friction by adhesion
// goes with its area. What has been predicted says nothing then.
TEST(JointTracker, AContactThatJumpsIsNotTrusted) {
  for (const double change : {1.0, 1.5, 0.7}) {
    double factor = 1;
    Path path{{JointGeometry::ball(0.05, 5e-5), steel(), FrictionLaw(0.01, 1e8),
               std::make_unique<ChangingLaw>(factor),
               make_pressure_law("cosine", JointKind::ball, steel())},
              {2e4, 0, 0},
              {0.6, 0, 0.8},
              {0, 0, 1},
              {0, 0, 1},
              1};
    const std::vector<Path> all = {path};
    JointTracker tracker = started(all);
    factor = change;
    go_to(tracker, all, 1e-4);
    tracker.predict();
    EXPECT_TRUE(tracker.is_trusted(0));
    tracker.correct();
    EXPECT_EQ(tracker.is_trusted(0), change == 1) << change;
  }
}

// At any place in its packet, among joints of any kind.
TEST(JointTracker, OneThatIsLostIsSeenInTheLargest) {
  for (const bool pins : {false, true}) {
    std::vector<Path> many = paths(9, pins ? 100 : 9);
    if (pins) std::erase_if(many, [](const Path& p) { return !p.is_pin(); });
    for (const int size : {1, 3, 5, 9}) {
      const std::vector<Path> all(many.begin(), many.begin() + size);
      for (const InstructionSet set : supported_instruction_sets()) {
        const contact::detail::WithInstructionSet with(set);
        JointTracker tracker = started(all);
        advance(tracker, all, 1e-4);
        EXPECT_TRUE(tracker.largest().is_trusted());
        for (int i = 0; i < size; ++i) {
          const Vector3d reaction = all[i].reaction_at(1e-4);
          for (const Vector3d& lost :
               {Vector3d(0, 0, 0), Vector3d(nan, 1, 1), Vector3d(1, nan, 1),
                Vector3d(1, 1, nan), Vector3d(2 * reaction)}) {
            tracker.set_reaction(i, lost);
            tracker.predict();
            EXPECT_FALSE(tracker.largest().is_trusted())
                << name(set) << ", " << i << " of " << size << ", R "
                << lost.transpose();
            tracker.correct();
            EXPECT_FALSE(tracker.largest().is_trusted())
                << name(set) << ", " << i << " of " << size << ", R "
                << lost.transpose();
            tracker.start(i, all[i].solve(1e-4), all[i].rate_at(1e-4));
            tracker.set_reaction(i, reaction);
            tracker.predict();
            tracker.correct();
            EXPECT_TRUE(tracker.largest().is_trusted());
          }
        }
      }
    }
  }
}

TEST(JointTracker, RefusesAFrictionStress) {
  const JointSpec spec{.geometry = JointGeometry::ball(0.05, 5e-5),
                       .inner = Material{2e11, 0.3},
                       .outer = Material{2e11, 0.3},
                       .friction = FrictionStress::stribeck(0.15, 0.05, 0.01)};
  EXPECT_ERROR(JointTracker({spec.contact()}),
               "friction of a joint that is tracked must be dry or viscous");
}

// Laws end where loads do not: what a solution that is ok starts has numbers.
TEST(JointTracker, StartsWithNumbersWhereTheStatusIsOk) {
  const Vector3d z = Vector3d::UnitZ();
  int started = 0;
  for (const auto& geometry : {JointGeometry::ball(0.01, 2e-5),
                               JointGeometry::pin(0.01, 2e-5, 0.02)}) {
    for (const std::string& half_angle : half_angle_law_names()) {
      for (const std::string& pressure : pressure_law_names()) {
        const Joint joint(JointSpec{.geometry = geometry,
                                    .inner = Material{2.1e11, 0.3},
                                    .outer = Material{1e11, 0.34},
                                    .friction = FrictionLaw(0.1, 1e3),
                                    .half_angle_law = half_angle,
                                    .pressure_law = pressure});
        JointTracker tracker({joint.contact()});
        for (double load = 1e-9; load < 1e13; load *= 20) {
          const Vector3d reaction(load, 0, joint.is_pin() ? 0 : 0.3 * load);
          const auto s = joint.solve({reaction, 0.1 * z, z});
          if (s.status != Status::ok) continue;
          ++started;
          tracker.start(0, s, 0.1 * z);
          EXPECT_TRUE(tracker.moment(0).allFinite())
              << half_angle << ", " << pressure << " under " << load;
        }
      }
    }
  }
  EXPECT_GT(started, 100);
}

// Readers of rows may read the whole last packet.
TEST(JointTracker, StepsAreZeroBeyondTheJoints) {
  const std::vector<Path> many = paths(10, 17);
  for (int size = 1; size <= 17; ++size) {
    const std::vector<Path> all(many.begin(), many.begin() + size);
    for (const InstructionSet set : supported_instruction_sets()) {
      const contact::detail::WithInstructionSet with(set);
      JointTracker tracker(contacts(all));
      const auto step = [&](int joint, int k) {
        constexpr int lanes = VectorRows::lanes;
        const VectorRows rows = tracker.steps();
        return rows
            .first[joint / lanes * rows.packet + k * lanes + joint % lanes];
      };
      const auto check_padding = [&] {
        for (int i = size; i % VectorRows::lanes != 0; ++i) {
          for (int k = 0; k < 3; ++k) EXPECT_EQ(step(i, k), 0) << size;
        }
      };
      for (int i = 0; i < size; ++i) {
        for (int k = 0; k < 3; ++k) EXPECT_EQ(step(i, k), 0);
      }
      check_padding();
      start(tracker, all, 0);
      for (int i = 0; i < size; ++i) {
        tracker.set_applied_moment(i, 0.9 * all[i].solve(0).friction_moment);
      }
      go_to(tracker, all, 1e-4);
      tracker.predict();
      for (int round = 0; round < 3; ++round) {
        tracker.apply();
        check_padding();
        for (int i = 0; i < size; ++i) {
          for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(step(i, k), tracker.step(i)[k]);
          }
          if (round == 0) {
            EXPECT_GT(tracker.step(i).norm(), 0);
          }
        }
        tracker.correct();
      }
      tracker.keep();
      tracker.extrapolate(1);
      check_padding();
      // Joints that are not tracked have no step either.
      tracker.stop(size - 1);
      tracker.predict();
      tracker.apply();
      EXPECT_EQ(tracker.step(size - 1), Vector3d(0, 0, 0));
      check_padding();
    }
  }
}

TEST(JointTracker, DoesNotAllocate) {
  const std::vector<Path> all = paths(5, 20);
  JointTracker tracker = started(all);
  const std::size_t before = allocation_count();
  advance(tracker, all, 1e-3);
  tracker.extend();
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace contact::test::joint_tracker_test
