// Costs of a state of a pin that ends, after the table of its slices' law: of
// random loads with a known tilt, and off the middle.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "libcontact/finite_pin/finite_pin.hpp"
#include "timing.hpp"

namespace contact::bench {
namespace {

using Eigen::Vector2d;

const Material steel = {210e9, 0.3};

JointSpec bush(Relief relief) {
  return {.geometry = JointGeometry::pin(0.02, 2e-5, 0.05),
          .inner = steel,
          .outer = {{{0.004, {110e9, 0.34}}, {0.02, steel}}, Backing::held()},
          .friction = FrictionLaw(0.1),
          .relief = relief};
}

// A liner of 0.025 radii.
JointSpec liner(Relief relief) {
  JointSpec joint = bush(relief);
  joint.outer = {{{0.0005, {3e9, 0.4}}, {0.02, steel}}, Backing::held()};
  return joint;
}

struct State {
  Vector2d reaction;
  Vector2d tilt;
  double place;  ///< m
};

// Reactions in equal ratios from 1 to 100 kN, tilts up to 1e-3, places up to a
// tenth of the length from the middle.
std::vector<State> states() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<State> all;
  while (all.size() < count) {
    const double size = 1e4 * std::pow(10, any(random));
    const double angle = 3 * any(random);
    all.push_back({size * Vector2d(std::cos(angle), std::sin(angle)),
                   1e-3 * Vector2d(any(random), any(random)),
                   5e-3 * any(random)});
  }
  return all;
}

void report(benchmark::State& state, const FinitePin& pin, bool placed) {
  const std::vector<State> all = states();
  double iterations = 0;
  double failed = 0;
  for (const State& s : all) {
    const FinitePinSolution solution =
        placed ? pin.solve_at(s.reaction, s.place, 1)
               : pin.solve(s.reaction, s.tilt, 1);
    iterations += solution.contact.iterations;
    failed += solution.contact.status == Status::ok ? 0 : 1;
  }
  state.counters["steps"] = iterations / static_cast<double>(all.size());
  state.counters["failed"] = failed;
}

void tilted(benchmark::State& state, const JointSpec& joint) {
  const FinitePin pin(joint);
  const std::vector<State> all = states();
  time_each(state, [&](std::size_t i) {
    return pin.solve(all[i].reaction, all[i].tilt, 1);
  });
  report(state, pin, false);
}

void placed(benchmark::State& state, const JointSpec& joint) {
  const FinitePin pin(joint);
  const std::vector<State> all = states();
  time_each(state, [&](std::size_t i) {
    return pin.solve_at(all[i].reaction, all[i].place, 1);
  });
  report(state, pin, true);
}

BENCHMARK_CAPTURE(tilted, straight, bush(Relief::none()));
BENCHMARK_CAPTURE(tilted, barrel, bush(Relief::barrel(1e-5)));
BENCHMARK_CAPTURE(tilted, ends, bush(Relief::ends(1.5e-5, 0.008)));
BENCHMARK_CAPTURE(tilted, liner, liner(Relief::ends(1.5e-5, 0.008)));
BENCHMARK_CAPTURE(placed, straight, bush(Relief::none()));
BENCHMARK_CAPTURE(placed, barrel, bush(Relief::barrel(1e-5)));
BENCHMARK_CAPTURE(placed, ends, bush(Relief::ends(1.5e-5, 0.008)));
BENCHMARK_CAPTURE(placed, liner, liner(Relief::ends(1.5e-5, 0.008)));

}  // namespace
}  // namespace contact::bench

BENCHMARK_MAIN();
