// Accelerations and reactions of apps/multibody against other programs and
// other formulations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "multibody/system/eigen_conversion.hpp"
#include "multibody_oracle/case_file.hpp"
#include "multibody_support/compare.hpp"
#include "multibody_support/dense_reference.hpp"
#include "multibody_support/dense_solver.hpp"
#include "multibody_support/prepared.hpp"
#include "multibody_support/random_instant.hpp"
#include "support/accuracy_report.hpp"

namespace contact::test::dynamics_test {
namespace {

using contact::test::AccuracyReport;
using multibody::Instant;
using multibody::InstantResult;
using namespace multibody::test;

std::set<std::filesystem::path> oracle_files(const std::string& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           CONTACT_DATA_DIR "/reference/" + folder)) {
    if (entry.path().extension() == ".json") files.insert(entry.path());
  }
  return files;
}

// Computed by multibody-eval, against what the file expects.
CaseError error_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const auto json = nlohmann::ordered_json::parse(stream);
  const multibody::CaseInstant instant = multibody::read_case(file.string());
  return case_error(to_json(instant, multibody::evaluate(instant)),
                    json["expected"]);
}

TEST(Multibody, OracleCases) {
  // Measured 9.1e-15; the oracle itself was checked to 1e-11.
  AccuracyReport report("oracle cases", 3e-14);
  // Three digits less in any program that works with double: the oracle's
  // own error.
  AccuracyReport degenerate("oracle cases near a point mass", 1e-6);
  degenerate.may_be_empty();
  for (const auto& file : oracle_files("multibody")) {
    const CaseError error = error_of(file);
    const std::string name = file.filename().string();
    const bool near = name.find("near_pendulum") != std::string::npos;
    (near ? degenerate : report)
        .add_error(error.error, name + " " + error.quantity);
  }
  EXPECT_GE(report.size(), 22u);
}

TEST(Multibody, OracleTrees) {
  // The oracle's own bars (README of the data).
  AccuracyReport report("oracle trees", 1e-11);
  AccuracyReport light("oracle tree of light links and a heavy tip", 1e-10);
  for (const auto& file : oracle_files("trees")) {
    const CaseError error = error_of(file);
    const std::string name = file.filename().string();
    const bool is_light = name.find("light_chain") != std::string::npos;
    (is_light ? light : report)
        .add_error(error.error, name + " " + error.quantity);
  }
  EXPECT_EQ(report.size(), 17u);
  EXPECT_EQ(light.size(), 1u);
}

TEST(Multibody, DenseReference) {
  // Measured 6e-14, both sides' inputs differ by the rounding of rotations.
  AccuracyReport report("dense reference in long double", 2e-13);
  for (const Mix mix : {Mix::balls, Mix::axes, Mix::held, Mix::all}) {
    for (const int bodies : {1, 2, 3, 5, 16, 64}) {
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Instant instant =
            random_instant(mix, bodies, 100 * bodies + seed);
        const CaseError error =
            case_error(to_json(instant, multibody::evaluate(instant)),
                       to_json(instant, dense_evaluate<long double>(instant)));
        report.add_error(error.error,
                         "mix " + std::to_string(static_cast<int>(mix)) +
                             ", L = " + std::to_string(bodies) + ", seed " +
                             std::to_string(seed) + " " + error.quantity);
      }
    }
  }
}

// The benchmark's opponent has to solve the same problem.
TEST(Multibody, DenseSolverOfTheBenchmarkAgrees) {
  double largest = 0;
  for (const Mix mix : {Mix::balls, Mix::axes}) {
    for (const int bodies : {1, 4, 16}) {
      const Instant instant = random_instant(mix, bodies, 7);
      const multibody::Prepared p = prepare(instant);
      multibody::Dynamics dynamics = p.dynamics();
      dynamics.evaluate(p.state.data(), p.forces);
      DenseSolver dense(p.system);
      dense.evaluate(p.state.data(), p.forces);
      const auto add = [&](const multibody::Vec3<double>& a,
                           const Eigen::Vector3d& b) {
        largest =
            std::max(largest, (multibody::vec3(a) - b).norm() / (1 + b.norm()));
      };
      add(dynamics.carrier().linear, dense.linear());
      add(dynamics.carrier().angular, dense.angular());
      for (int i = 0; i < bodies; ++i) {
        add(dynamics.relative_acceleration(i), dense.relative_acceleration(i));
      }
    }
  }
  EXPECT_LE(largest, 1e-12);  // measured 2e-14
}

multibody::Dynamics dynamics_of(const multibody::Prepared& p,
                                contact::InstructionSet set) {
  multibody::Dynamics result(p.system, set);
  for (int i = 0; i < result.size(); ++i) result.set_mode(i, p.modes[i]);
  return result;
}

// Vectors in rows, with a further row after each packet that must stay
// unchanged.
class Rows {
 public:
  explicit Rows(int size) {
    numbers_.resize((size + width - 1) / width * stride);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (i % stride >= 3 * width) numbers_[i] = guard;
    }
  }
  multibody::VectorRows rows() { return {numbers_.data(), stride}; }
  void set(int body, const Eigen::Vector3d& v) {
    double* const to = rows().at(body);
    for (int k = 0; k < 3; ++k) to[k * width] = v[k];
  }
  Eigen::Vector3d get(int body) {
    const double* const from = rows().at(body);
    return {from[0], from[width], from[2 * width]};
  }
  bool guards_are_untouched() const {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (i % stride >= 3 * width && numbers_[i] != guard) return false;
    }
    return true;
  }

 private:
  static constexpr int width = multibody::VectorRows::lanes;
  static constexpr int stride = 4 * width;
  static constexpr double guard = 12345;
  std::vector<double> numbers_;
};

// Balls alone, axes alone (whose packets follow on each other as the rows do),
// and all kinds; some held or released at random.
struct ModeCase {
  Mix mix;
  bool changed;
};
Instant instant_of(const ModeCase& c, int bodies, std::uint64_t seed) {
  Instant instant = random_instant(c.mix, bodies, seed);
  Random random(seed);
  for (multibody::BodyInstant& body : instant.bodies) {
    if (!c.changed || body.body.kind == multibody::HingeKind::none) continue;
    const double share = random.uniform(0, 1);
    if (share < 0.3) {
      body.mode = multibody::JointMode::held;
      body.relative_angular_velocity.setZero();
      body.angle_rate = 0;
    } else if (share < 0.5) {
      body.mode = multibody::JointMode::released;
    }
  }
  return instant;
}

using Vectors = std::vector<Eigen::Vector3d>;

// Largest difference over largest component, infinite for NaN.
double miss(const Vectors& found, const Vectors& expected) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Eigen::Vector3d d = found[i] - expected[i];
    if (!d.allFinite()) return std::numeric_limits<double>::infinity();
    difference = std::max(difference, d.lpNorm<Eigen::Infinity>());
    size = std::max(size, expected[i].lpNorm<Eigen::Infinity>());
  }
  return difference == 0 ? 0 : difference / size;
}

Vectors relative_accelerations(const multibody::Dynamics& dynamics) {
  Vectors all;
  for (int i = 0; i < dynamics.size(); ++i) {
    all.push_back(multibody::vec3(dynamics.relative_acceleration(i)));
  }
  return all;
}

Vectors reaction_forces(const multibody::Dynamics& dynamics) {
  std::vector<multibody::Reaction<double>> reactions(dynamics.size());
  dynamics.reactions(reactions);
  Vectors all;
  for (const auto& reaction : reactions) {
    all.push_back(multibody::vec3(reaction.force));
  }
  return all;
}

// The same at once, in rows.
void expect_rows_agree(const multibody::Dynamics& dynamics) {
  const int bodies = dynamics.size();
  Rows forces(bodies), moments(bodies);
  const contact::VectorRows rows = moments.rows();
  dynamics.reactions(forces.rows(), &rows);
  EXPECT_TRUE(forces.guards_are_untouched());
  EXPECT_TRUE(moments.guards_are_untouched());
  std::vector<multibody::Reaction<double>> reactions(bodies);
  dynamics.reactions(reactions);
  std::vector<multibody::Vec3<double>> at_once(bodies);
  dynamics.relative_accelerations(at_once);
  const Vectors expected = relative_accelerations(dynamics);
  for (int i = 0; i < bodies; ++i) {
    const auto& [force, moment] = reactions[i];
    EXPECT_EQ(forces.get(i), multibody::vec3(force)) << bodies << ", " << i;
    EXPECT_EQ(moments.get(i), multibody::vec3(moment)) << bodies << ", " << i;
    EXPECT_EQ(multibody::vec3(at_once[i]), expected[i])
        << bodies << " bodies, " << i;
  }
}

class MultibodyRows : public testing::TestWithParam<contact::InstructionSet> {
 protected:
  void SetUp() override {
    if (!contact::is_supported(GetParam())) GTEST_SKIP() << "not supported";
  }
};

// Vectors exchanged in rows equal vectors exchanged body by body, and the sums
// equal the sums of a full evaluation.
TEST_P(MultibodyRows, AreTheVectorsOfAllBodies) {
  // Measured 0: the same operations.
  AccuracyReport by_body("friction added in rows", 1e-14);
  // Measured 1.3e-15; the bound that Dynamics states.
  AccuracyReport in_full("friction added later", 1e-14);
  for (const ModeCase& c :
       {ModeCase{Mix::balls, false}, ModeCase{Mix::balls, true},
        ModeCase{Mix::axes, false}, ModeCase{Mix::axes, true},
        ModeCase{Mix::all, false}, ModeCase{Mix::all, true}}) {
    for (int bodies = 1; bodies <= 17; ++bodies) {
      multibody::Prepared p = prepare(instant_of(c, bodies, 50 * bodies + 3));
      multibody::Dynamics rows = dynamics_of(p, GetParam());
      multibody::Dynamics single = dynamics_of(p, GetParam());
      multibody::Dynamics full = dynamics_of(p, GetParam());
      rows.evaluate(p.state.data(), p.forces);
      single.evaluate(p.state.data(), p.forces);
      expect_rows_agree(rows);
      Random random(bodies);
      Rows change(bodies);
      std::vector<multibody::Vec3<double>> changes;
      for (int i = 0; i < bodies; ++i) {
        const Eigen::Vector3d v = random.vector(20);
        change.set(i, v);
        changes.push_back(multibody::vec3(v));
        p.forces.bodies[i].friction += changes.back();
      }
      rows.add_friction(change.rows());
      single.add_friction(changes);
      full.evaluate(p.state.data(), p.forces);
      expect_rows_agree(rows);
      const std::string label = std::to_string(bodies) + " bodies, mix " +
                                std::to_string(static_cast<int>(c.mix));
      for (const auto quantity : {relative_accelerations, reaction_forces}) {
        const Vectors found = quantity(rows);
        by_body.add_error(miss(found, quantity(single)), label);
        in_full.add_error(miss(found, quantity(full)), label);
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Sets, MultibodyRows,
                         testing::Values(contact::InstructionSet::baseline,
                                         contact::InstructionSet::avx2,
                                         contact::InstructionSet::avx512),
                         [](const auto& set) {
                           return std::string(contact::name(set.param));
                         });

// A carrier at rest that weighs k times as much moves by 1/k: so do the
// accelerations relative to it differ from those on a fixed one. Measured:
// 0.07/k to 1.9/k of them, and of the sum of the reactions 0.27/k to 0.94/k.
TEST(Multibody, AVeryHeavyCarrierIsAFixedOne) {
  for (const Mix mix : {Mix::balls, Mix::axes, Mix::all}) {
    for (const int bodies : {1, 3, 9}) {
      Instant instant = random_instant(mix, bodies, 11 + bodies);
      instant.angular_velocity.setZero();
      const multibody::Carrier light = instant.carrier;
      for (const double k : {1e6, 1e8, 1e10, 1e12}) {
        instant.carrier.mass = k * light.mass;
        instant.carrier.inertia = k * light.inertia;
        const multibody::Prepared p = prepare(instant);
        multibody::Dynamics heavy = p.dynamics();
        multibody::Dynamics fixed = p.dynamics();
        heavy.evaluate(p.state.data(), p.forces);
        fixed.evaluate_prescribed(p.state.data(), p.forces, {});
        const double change =
            miss(relative_accelerations(heavy), relative_accelerations(fixed));
        EXPECT_LT(change, 4 / k);
        EXPECT_GT(change, 0.02 / k);
        // Newton's law of the carrier under the reactions of a fixed one.
        Eigen::Vector3d force = instant.active_force;
        const Vectors reactions = reaction_forces(fixed);
        for (int i = 0; i < bodies; ++i) {
          force -=
              multibody::vec3(fixed.axes(i) * multibody::vec3(reactions[i]));
        }
        const Eigen::Vector3d found =
            instant.carrier.mass * multibody::vec3(heavy.carrier().linear);
        EXPECT_LT((found - force).norm(), (2 / k + 1e-13) * force.norm());
      }
    }
  }
}

// Bodies that shrink to point masses on their arms tend to the motion of point
// masses, in proportion to their inertia. Measured: 0.1 to 2.9 of its share.
TEST(Multibody, SmallInertiaTendsToAPointMass) {
  for (const Mix mix : {Mix::balls, Mix::axes}) {
    for (const int bodies : {1, 3, 9}) {
      Instant instant = random_instant(mix, bodies, 21 + bodies);
      for (multibody::BodyInstant& body : instant.bodies) {
        // A point mass on a ball does not resist a moment along its arm.
        body.active_moment_com.setZero();
        body.friction_moment.setZero();
      }
      const auto evaluated = [&](double share) {
        Instant small = instant;
        for (multibody::BodyInstant& body : small.bodies) {
          body.body.inertia *= share;
        }
        const InstantResult result = multibody::evaluate(small);
        std::array<Vectors, 2> both;
        both[0].push_back(result.acceleration_minus_gravity);
        for (const multibody::BodyResult& body : result.bodies) {
          both[1].push_back(body.reaction_force);
        }
        return both;
      };
      const std::array<Vectors, 2> point = evaluated(0);
      for (const double share : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const std::array<Vectors, 2> small = evaluated(share);
        for (int quantity = 0; quantity < 2; ++quantity) {
          const double change = miss(small[quantity], point[quantity]);
          EXPECT_LT(change, 6 * share) << quantity;
          EXPECT_GT(change, 0.03 * share) << quantity;
        }
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::dynamics_test
