// Accelerations and reactions of apps/multibody against other programs and
// other formulations.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "multibody/case_file.hpp"
#include "multibody/eigen_conversion.hpp"
#include "multibody/prepared.hpp"
#include "multibody_support/compare.hpp"
#include "multibody_support/dense_reference.hpp"
#include "multibody_support/dense_solver.hpp"
#include "multibody_support/random_instant.hpp"
#include "support/accuracy_report.hpp"

namespace {

using contact::test::AccuracyReport;
using multibody::Instant;
using multibody::InstantResult;
using namespace multibody::test;

std::set<std::filesystem::path> oracle_files() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           CONTACT_DATA_DIR "/reference/multibody")) {
    if (entry.path().extension() == ".json") files.insert(entry.path());
  }
  return files;
}

TEST(Multibody, OracleCases) {
  // Measured 9.1e-15; the oracle itself was checked to 1e-11.
  AccuracyReport report("oracle cases", 3e-14);
  // Three digits less in any program that works with double: the oracle's
  // own error.
  AccuracyReport degenerate("oracle cases near a point mass", 1e-6);
  for (const auto& file : oracle_files()) {
    std::ifstream stream(file);
    const auto json = nlohmann::ordered_json::parse(stream);
    const Instant instant = multibody::read_case(file.string());
    const CaseError error = case_error(
        to_json(instant, multibody::evaluate(instant)), json["expected"]);
    const std::string name = file.filename().string();
    const bool near = name.find("near_pendulum") != std::string::npos;
    (near ? degenerate : report)
        .add_error(error.error, name + " " + error.quantity);
  }
  EXPECT_GE(report.size(), 22u);
  report.check();
  if (degenerate.size() > 0) degenerate.check();
}

TEST(Multibody, DenseReference) {
  // Measured 6e-14, both sides' inputs differ by the rounding of rotations.
  AccuracyReport report("dense reference in long double", 2e-13);
  for (const Mix mix : {Mix::spherical, Mix::axes, Mix::held, Mix::all}) {
    for (const int loads : {1, 2, 3, 5, 16, 64}) {
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Instant instant = random_instant(mix, loads, 100 * loads + seed);
        const CaseError error =
            case_error(to_json(instant, multibody::evaluate(instant)),
                       to_json(instant, dense_evaluate<long double>(instant)));
        report.add_error(error.error,
                         "mix " + std::to_string(static_cast<int>(mix)) +
                             ", L = " + std::to_string(loads) + ", seed " +
                             std::to_string(seed) + " " + error.quantity);
      }
    }
  }
  report.check();
}

// The benchmark's opponent has to solve the same problem.
TEST(Multibody, DenseSolverOfTheBenchmarkAgrees) {
  double largest = 0;
  for (const Mix mix : {Mix::spherical, Mix::axes}) {
    for (const int loads : {1, 4, 16}) {
      const Instant instant = random_instant(mix, loads, 7);
      const multibody::Prepared p = prepare(instant);
      multibody::Dynamics dynamics = p.dynamics();
      dynamics.evaluate(p.state.data(), p.loading);
      DenseSolver dense(p.system);
      dense.evaluate(p.state.data(), p.loading);
      const auto add = [&](const multibody::Vec3<double>& a,
                           const Eigen::Vector3d& b) {
        largest =
            std::max(largest, (multibody::vec3(a) - b).norm() / (1 + b.norm()));
      };
      add(dynamics.carrier().linear, dense.linear());
      add(dynamics.carrier().angular, dense.angular());
      for (int i = 0; i < loads; ++i) {
        add(dynamics.relative_acceleration(i), dense.relative_acceleration(i));
      }
    }
  }
  EXPECT_LE(largest, 1e-12);  // measured 2e-14
}

}  // namespace
