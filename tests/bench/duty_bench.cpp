// Costs of a duty cycle: friction stresses of p and v beside dry friction and
// GSL, places of the largest p v beside the solution they belong to, a hip's
// cycle, its wear maps, friction from measured moments.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/stress_rule.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/identify/identify.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/random_slip.hpp"
#include "support/reference_table.hpp"
#include "timing.hpp"

namespace contact::bench {
namespace {

using Eigen::Vector3d;
using test::ReferenceTable;

// Steel ball, polymer seat.
ElasticPair pair() { return ElasticPair::from_modulus_ratio(7, 0.3, 0.4); }

std::unique_ptr<PressureLaw> pressure(const std::string& name) {
  return make_pressure_law(name, JointKind::ball, pair());
}

struct Point {
  StressedContact contact;
  SlipAxis axis;
};

// Uniform in theta0 and a up to 90 deg.
std::vector<Point> points() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0, std::numbers::pi / 2);
  std::vector<Point> all;
  while (all.size() < count) {
    const double half_angle = angle(random);
    all.push_back(
        {{half_angle, 3e7, 0.035}, SlipAxis::from_angle(angle(random))});
  }
  return all;
}

// Against four times as many points.
double largest_error(const PressureLaw& law, const FrictionStress& stress,
                     const std::vector<Point>& all) {
  double largest = 0;
  for (std::size_t i = 0; i < all.size(); i += 16) {
    const auto& [contact, axis] = all[i];
    const FrictionTriple t = stress_integrals(law, contact, axis, stress);
    const FrictionTriple exact =
        stress_integrals(law, contact, axis, stress, 96);
    const double size = std::hypot(exact.sliding, exact.spinning);
    largest = std::max({largest, std::abs(t.force / exact.force - 1),
                        std::abs(t.sliding - exact.sliding) / size,
                        std::abs(t.spinning - exact.spinning) / size});
  }
  return largest;
}

void stress(benchmark::State& state, const FrictionStress& stress) {
  const auto law = pressure("cosine");
  const std::vector<Point> all = points();
  time_each(state, [&](std::size_t i) {
    const auto& [contact, axis] = all[i];
    return stress_integrals(*law, contact, axis, stress);
  });
  state.counters["error_1e12"] = 1e12 * largest_error(*law, stress, all);
}

// The closed forms of f0 p + A.
void dry(benchmark::State& state) {
  const auto law = pressure("cosine");
  const std::vector<Point> all = points();
  time_each(state, [&](std::size_t i) {
    const auto& [contact, axis] = all[i];
    return friction_integrals(*law, contact.half_angle, axis);
  });
}

// f0 p + A by GSL's adaptive quadrature of the definition.
void gsl(benchmark::State& state) {
  const std::vector<Point> all = points();
  time_each(state, [&](std::size_t i) {
    const auto& [contact, axis] = all[i];
    return reference::quadrature_friction_integrals(contact.half_angle, axis,
                                                    1e-10);
  });
}

// Solutions of a joint with adhesion, and the rates they belong to.
struct Solved {
  explicit Solved(const std::string& law)
      : joint({JointGeometry::ball(0.014, 1e-4), pair(), FrictionLaw(0.06, 1e5),
               make_half_angle_law("tanh", JointKind::ball, pair()),
               pressure(law)}) {
    test::RandomSlips random(5);
    while (slips.size() < count) {
      slips.push_back({random.log_uniform(1e2, 1e4) * random.direction(),
                       2 * random.direction()});
      solutions.push_back(joint.solve(slips.back()));
    }
  }
  Joint joint;
  std::vector<Joint::Slip> slips;
  std::vector<JointSolution> solutions;
};

void solution(benchmark::State& state, const std::string& law) {
  const Solved solved(law);
  time_each(state,
            [&](std::size_t i) { return solved.joint.solve(solved.slips[i]); });
}

// Totals and the places of the largest p v and heat.
void largest_pv(benchmark::State& state, const std::string& law) {
  const Solved solved(law);
  time_each(state, [&](std::size_t k) {
    return SlidingContact(solved.joint.contact(), solved.solutions[k],
                          solved.slips[k].angular_velocity);
  });
}

// The hip of the reference data, 100 rows.
struct Hip {
  static std::vector<Vector3d> columns(const ReferenceTable& table,
                                       const std::vector<std::string>& names,
                                       double unit) {
    std::vector<Vector3d> all;
    for (const ReferenceTable::Row row : table) {
      all.push_back(unit * Vector3d(row.value(names[0]), row.value(names[1]),
                                    row.value(names[2])));
    }
    return all;
  }
  static DutyCycle make_duty() {
    const ReferenceTable table("duty/cycle_hip_in.csv");
    std::vector<double> times;
    for (const ReferenceTable::Row row : table) {
      times.push_back(row.value("time_s"));
    }
    const double period = times.back() + times[1] - times[0];
    return {{times, columns(table, {"R_x_N", "R_y_N", "R_z_N"}, 1),
             columns(table,
                     {"flexion_deg", "adduction_deg", "internal_rotation_deg"},
                     degree),
             period},
            {},
            DutyCycle::TurnSequence("zxy")};
  }
  DutyCycle duty = make_duty();
  Joint joint{read_joint(std::filesystem::path(CONTACT_DATA_DIR) /
                         "reference/duty/cycle_hip.toml")
                  .contact()};
};

// All that hinge-duty says of a cycle without a map: its sums and the largest
// p v through time.
void hip_cycle(benchmark::State& state) {
  const Hip hip;
  for (auto _ : state) {
    const JointCycle cycle(hip.duty, hip.joint);
    benchmark::DoNotOptimize(
        cycle.integral([](const auto& i) { return -i.solution.power; }));
    benchmark::DoNotOptimize(cycle.largest(
        [&](const auto& i) { return cycle.sliding(i).largest_pv().value; }));
  }
}

// 2000 points on each body, and the deepest.
void hip_wear_maps(benchmark::State& state) {
  const Hip hip;
  const JointCycle cycle(hip.duty, hip.joint);
  for (auto _ : state) {
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      const WearMap map(cycle, body);
      const auto grid = map.grid(2000);
      std::vector<WearMap::Wear> wear;
      for (const Vector3d& point : grid) wear.push_back(map.at(point));
      benchmark::DoNotOptimize(map.deepest(grid, wear));
    }
  }
}

// f0 and A from 40 moments of the reference data.
void identification(benchmark::State& state) {
  const ReferenceTable table("duty/identify.csv");
  std::vector<MeasuredMoment> data;
  for (const ReferenceTable::Row row : table) {
    if (row.text("set") != "wide") continue;
    const double b = row.value("b_deg") * degree;
    data.push_back({row.value("R_N") * Vector3d(std::sin(b), 0, std::cos(b)),
                    Vector3d::UnitZ(), row.value("torque_N_m"),
                    row.value("sigma_N_m")});
  }
  const ElasticPair steel_bronze({207e9, 0.292}, {111e9, 0.349});
  const JointContact joint(
      JointGeometry::ball(0.025, 25e-6), steel_bronze, FrictionLaw(0),
      make_half_angle_law("tanh", JointKind::ball, steel_bronze),
      make_pressure_law("cosine", JointKind::ball, steel_bronze));
  for (auto _ : state) {
    benchmark::DoNotOptimize(identify_friction(joint, data));
  }
  state.counters["rows"] = static_cast<double>(data.size());
}

BENCHMARK(dry);
BENCHMARK_CAPTURE(stress, stribeck, FrictionStress::stribeck(0.15, 0.05, 0.01));
BENCHMARK_CAPTURE(stress, power, FrictionStress::power(0.1, 1e7, 0.25));
BENCHMARK(gsl)->Unit(benchmark::kMillisecond)->Iterations(64);
BENCHMARK_CAPTURE(solution, cosine, "cosine");
BENCHMARK_CAPTURE(largest_pv, cosine, "cosine");
BENCHMARK_CAPTURE(solution, mixture, "mixture");
BENCHMARK_CAPTURE(largest_pv, mixture, "mixture");
BENCHMARK_CAPTURE(solution, exact, "exact");
BENCHMARK_CAPTURE(largest_pv, exact, "exact");
BENCHMARK(hip_cycle)->Unit(benchmark::kMillisecond);
BENCHMARK(hip_wear_maps)->Unit(benchmark::kMillisecond);
BENCHMARK(identification)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace contact::bench

BENCHMARK_MAIN();
