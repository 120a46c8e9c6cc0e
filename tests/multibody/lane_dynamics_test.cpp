#include "multibody/dynamics/lane_dynamics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "multibody/dynamics/dynamics.hpp"
#include "multibody_support/prepared.hpp"
#include "multibody_support/random_instant.hpp"

// Several motions side by side against each of them alone.
namespace {

using contact::InstructionSet;
using multibody::Dynamics;
using multibody::Instant;
using multibody::JointMode;
using multibody::LaneDynamics;
using multibody::Prepared;
using multibody::Reaction;
using multibody::Vec3;
using multibody::test::Mix;
using multibody::test::Random;
using multibody::test::random_instant;

// Numbers, each as lanes side by side.
class LaneArray {
 public:
  LaneArray(std::size_t size, int lanes)
      : lanes_(lanes), numbers_(size * lanes) {}
  double* data() { return numbers_.data(); }
  void set_lane(int lane, const std::vector<double>& from) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      numbers_[i * lanes_ + lane] = from[i];
    }
  }
  std::vector<double> lane(int lane) const {
    std::vector<double> to;
    for (std::size_t i = lane; i < numbers_.size(); i += lanes_) {
      to.push_back(numbers_[i]);
    }
    return to;
  }

 private:
  int lanes_;
  std::vector<double> numbers_;
};

void append(std::vector<double>& to, const Vec3<double>& v) {
  to.insert(to.end(), {v.x, v.y, v.z});
}

std::vector<double> loading_numbers(const Prepared& p) {
  std::vector<double> to;
  append(to, p.loading.carrier.force);
  append(to, p.loading.carrier.moment);
  for (const multibody::LoadForces<double>& load : p.loading.loads) {
    append(to, load.force);
    append(to, load.moment);
    append(to, load.friction);
  }
  return to;
}

std::vector<double> accelerations(const Dynamics& dynamics) {
  std::vector<double> to;
  append(to, dynamics.carrier().linear);
  append(to, dynamics.carrier().angular);
  for (int i = 0; i < dynamics.size(); ++i) {
    append(to, dynamics.relative_acceleration(i));
  }
  return to;
}

std::vector<double> reactions(const Dynamics& dynamics) {
  std::vector<Reaction<double>> all(dynamics.size());
  dynamics.reactions(all);
  std::vector<double> to;
  for (const Reaction<double>& reaction : all) {
    append(to, reaction.force);
    append(to, reaction.moment);
  }
  return to;
}

std::vector<double> rates(const Dynamics& dynamics, const Prepared& p,
                          const Vec3<double>& gravity) {
  std::vector<double> to(p.state.size());
  dynamics.rates(p.state.data(), gravity, to.data());
  return to;
}

// In units of the largest component, infinite for NaN.
double error(const std::vector<double>& found,
             const std::vector<double>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double d = std::abs(found[i] - expected[i]);
    if (!(d <= difference)) {
      difference = std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
    }
    size = std::max(size, std::abs(expected[i]));
  }
  return difference == 0 ? 0 : difference / size;
}

// Balls, axes and bodies of their own; joints that turn, are held, are
// released, each kind in each mode in 15 loads.
JointMode mode_of(Mix mix, int load) {
  if (mix != Mix::all) return JointMode::turning;
  if (load % 5 == 4) return JointMode::released;
  if (load % 5 < 2) return JointMode::turning;
  return load / 5 % 2 == 0 ? JointMode::held : JointMode::released;
}

// One motion for each lane; of one system or of systems that differ.
std::vector<Prepared> motions(Mix mix, int loads, int lanes, bool same_system) {
  std::vector<Prepared> all;
  Instant first;
  for (int lane = 0; lane < lanes; ++lane) {
    Instant instant = random_instant(mix, loads, 100 * loads + lane);
    if (lane == 0) first = instant;
    if (same_system) instant.carrier = first.carrier;
    for (std::size_t i = 0; i < instant.loads.size(); ++i) {
      instant.loads[i].mode = mode_of(mix, static_cast<int>(i));
      if (same_system) instant.loads[i].load = first.loads[i].load;
    }
    all.push_back(prepare(instant));
  }
  return all;
}

LaneDynamics lane_dynamics(const std::vector<Prepared>& all, bool same_system,
                           InstructionSet set) {
  std::vector<multibody::System> systems;
  for (const Prepared& p : all) systems.push_back(p.system);
  LaneDynamics lanes =
      same_system ? LaneDynamics(systems[0], set) : LaneDynamics(systems, set);
  for (int i = 0; i < lanes.size(); ++i) lanes.set_mode(i, all[0].modes[i]);
  return lanes;
}

class LaneDynamicsOf : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!contact::is_supported(GetParam())) GTEST_SKIP() << "not supported";
  }
};

// All that is asked of an evaluation, the largest error of each.
struct Errors {
  double accelerations = 0, reactions = 0, rates = 0;

  void add(LaneDynamics& lanes, const std::vector<Dynamics>& alone,
           const std::vector<Prepared>& all, LaneArray& state) {
    const int width = lanes.lanes();
    const auto loads = lanes.size();
    LaneArray a(6 + 3 * loads, width), r(6 * loads, width),
        d(lanes.layout().size(), width), gravity(3, width);
    for (int lane = 0; lane < width; ++lane) {
      gravity.set_lane(lane, {0.1 * lane, -0.2, -9.81});
    }
    lanes.accelerations(a.data());
    lanes.reactions(r.data());
    lanes.rates(state.data(), gravity.data(), d.data());
    for (int lane = 0; lane < width; ++lane) {
      const Dynamics& dynamics = alone[lane];
      const Prepared& p = all[lane];
      const auto raise = [](double& largest, double value) {
        largest = std::max(largest, value);
      };
      raise(accelerations, error(a.lane(lane), ::accelerations(dynamics)));
      raise(reactions, error(r.lane(lane), ::reactions(dynamics)));
      raise(rates, error(d.lane(lane),
                         ::rates(dynamics, p, {0.1 * lane, -0.2, -9.81})));
    }
  }
  void check(const char* what, double budget) const {
    std::printf("%s: accelerations %.1e, reactions %.1e, rates %.1e\n", what,
                accelerations, reactions, rates);
    EXPECT_LT(accelerations, budget);
    EXPECT_LT(reactions, budget);
    EXPECT_LT(rates, budget);
  }
};

// Measured:
TEST_P(LaneDynamicsOf, EachLaneIsAMotionOfItsOwn) {
  Errors evaluated, changed;
  for (const bool same_system : {true, false}) {
    for (const Mix mix : {Mix::spherical, Mix::axes, Mix::all}) {
      for (const int loads : {1, 2, 3, 5, 8, 15, 17}) {
        const int width = LaneDynamics::lanes(GetParam());
        const std::vector<Prepared> all =
            motions(mix, loads, width, same_system);
        LaneDynamics lanes = lane_dynamics(all, same_system, GetParam());
        ASSERT_EQ(lanes.lanes(), width);
        ASSERT_EQ(lanes.layout().size(), all[0].state.size());
        Random random(loads);
        LaneArray state(all[0].state.size(), width),
            loading(6 + 9 * loads, width), change(3 * loads, width);
        std::vector<Dynamics> alone;
        std::vector<std::vector<Vec3<double>>> changes;
        for (int lane = 0; lane < width; ++lane) {
          const Prepared& p = all[lane];
          state.set_lane(lane, p.state);
          loading.set_lane(lane, loading_numbers(p));
          alone.push_back(p.dynamics());
          alone.back().evaluate(p.state.data(), p.loading);
          std::vector<double> numbers;
          changes.emplace_back();
          for (int i = 0; i < loads; ++i) {
            const Eigen::Vector3d v = random.vector(10);
            changes.back().push_back({v.x(), v.y(), v.z()});
            append(numbers, changes.back().back());
          }
          change.set_lane(lane, numbers);
        }
        lanes.evaluate(state.data(), loading.data());
        evaluated.add(lanes, alone, all, state);
        lanes.add_friction(change.data());
        for (std::size_t lane = 0; lane < alone.size(); ++lane) {
          alone[lane].add_friction(changes[lane]);
        }
        changed.add(lanes, alone, all, state);
      }
    }
  }
  evaluated.check("evaluated", 2e-14);
  changed.check("friction added", 2e-14);
}

// One NaN stays in its lane.
TEST_P(LaneDynamicsOf, NanDoesNotLeaveItsLane) {
  const int width = LaneDynamics::lanes(GetParam());
  const std::vector<Prepared> all = motions(Mix::all, 7, width, true);
  LaneDynamics lanes = lane_dynamics(all, true, GetParam());
  LaneArray state(all[0].state.size(), width), loading(6 + 9 * 7, width),
      result(6 + 3 * 7, width);
  for (int lane = 0; lane < width; ++lane) {
    state.set_lane(lane, all[lane].state);
    loading.set_lane(lane, loading_numbers(all[lane]));
  }
  std::vector<double> broken = all[0].state;
  broken[multibody::StateLayout::angular_velocity] =
      std::numeric_limits<double>::quiet_NaN();
  for (int lane = 0; lane < width; ++lane) {
    LaneArray with_nan = state;
    with_nan.set_lane(lane, broken);
    lanes.evaluate(with_nan.data(), loading.data());
    lanes.accelerations(result.data());
    for (int other = 0; other < width; ++other) {
      const std::vector<double> found = result.lane(other);
      EXPECT_EQ(std::isnan(found[0]), other == lane) << lane << " " << other;
    }
  }
}

// Released joints have other numbers in the state.
TEST_P(LaneDynamicsOf, ModesMayChangeBetweenEvaluations) {
  const int width = LaneDynamics::lanes(GetParam());
  constexpr int loads = 10;
  const std::vector<Prepared> all = motions(Mix::all, loads, width, true);
  LaneDynamics fresh = lane_dynamics(all, true, GetParam());
  LaneDynamics changed(all[0].system, GetParam());
  LaneArray state(all[0].state.size(), width), loading(6 + 9 * loads, width),
      found(6 + 3 * loads, width), expected(6 + 3 * loads, width),
      other(1000, width);
  for (int lane = 0; lane < width; ++lane) {
    other.set_lane(lane, std::vector<double>(1000, 1));
    state.set_lane(lane, all[lane].state);
    loading.set_lane(lane, loading_numbers(all[lane]));
  }
  for (const JointMode mode : {JointMode::released, JointMode::held}) {
    for (int i = 0; i < loads; ++i) {
      if (i % 5 < 4) changed.set_mode(i, mode);
    }
    changed.evaluate(other.data(), loading.data());
  }
  for (int i = 0; i < loads; ++i) changed.set_mode(i, all[0].modes[i]);
  ASSERT_EQ(changed.layout().size(), fresh.layout().size());
  for (LaneDynamics* const lanes : {&fresh, &changed}) {
    lanes->evaluate(state.data(), loading.data());
    lanes->accelerations((lanes == &fresh ? expected : found).data());
  }
  for (int lane = 0; lane < width; ++lane) {
    EXPECT_EQ(found.lane(lane), expected.lane(lane)) << lane;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, LaneDynamicsOf,
                         testing::Values(InstructionSet::baseline,
                                         InstructionSet::avx2,
                                         InstructionSet::avx512),
                         [](const auto& set) {
                           return std::string(contact::name(set.param));
                         });

TEST(LaneDynamics, SystemsHaveToBeAsManyAsLanesAndOfTheSameKinds) {
  const int width = LaneDynamics::lanes(contact::best_instruction_set());
  std::vector<multibody::System> systems;
  for (const Prepared& p : motions(Mix::all, 5, width, false)) {
    systems.push_back(p.system);
  }
  EXPECT_NO_THROW(LaneDynamics{systems});
  std::vector<multibody::System> fewer(systems.begin(), systems.end() - 1);
  EXPECT_THROW(LaneDynamics{fewer}, contact::Error);
  systems.back() = motions(Mix::axes, 5, 1, true)[0].system;
  EXPECT_THROW(LaneDynamics{systems}, contact::Error);
  systems.back() = motions(Mix::all, 4, 1, true)[0].system;
  EXPECT_THROW(LaneDynamics{systems}, contact::Error);
}

}  // namespace
