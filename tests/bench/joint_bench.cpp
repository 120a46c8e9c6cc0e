// The joint solver under a known reaction: one evaluation of the exact
// friction coefficients at the solution is the unit, timed in the same run
// and in turn with the solves; beside every time stands the error.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/fixed_point.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "support/joint_sweep.hpp"
#include "support/random_slip.hpp"

namespace {

using contact::FixedPointResult;
using contact::Joint;
using contact::JointSolution;
using contact::Status;
using contact::test::RandomSlip;
using contact::test::RandomSlips;
using Eigen::Vector3d;

// Fits the cache, so that the solver is timed and not the memory.
constexpr std::size_t count = 256;
constexpr double move = 1e-3;

/// Inputs, a solution for each, and the inputs moved by a thousandth.
struct States {
  std::vector<RandomSlip> inputs;
  std::vector<JointSolution> solutions;
  std::vector<RandomSlip> moved;
  std::vector<JointSolution> moved_solutions;

  void add(const RandomSlip& input, RandomSlips& random) {
    RandomSlip next = input;
    next.reaction += move * input.reaction.norm() * random.direction();
    next.rate += move * input.rate.norm() * random.direction();
    inputs.push_back(input);
    solutions.push_back(input.joint.solve(input.slip()));
    moved_solutions.push_back(next.joint.solve(next.slip()));
    moved.push_back(std::move(next));
  }
};

/// All that a joint can meet (support/random_slip.hpp).
States any_states() {
  RandomSlips random(3);
  States states;
  while (states.inputs.size() < count) states.add(random.next(), random);
  return states;
}

/// Steel ball joints as in the paper's examples: f0 from 0.05 to 0.3, half of
/// them with A/f0 up to 1e9 Pa, half-angles from 10 to 80 deg, any b.
States steel_states() {
  RandomSlips random(4);
  const contact::ElasticPair pair({2e11, 0.3}, {2e11, 0.3});
  const auto geometry = contact::JointGeometry::ball(0.05, 0.05e-3);
  const contact::LoadScale scale(geometry, pair);
  States states;
  while (states.inputs.size() < count) {
    const double f0 = 0.05 + 0.25 * random.uniform();
    const double adhesion =
        random.uniform() < 0.5 ? 0 : f0 * random.log_uniform(1e6, 1e9);
    const Joint joint(
        {geometry, pair, contact::FrictionLaw(f0, adhesion),
         contact::make_half_angle_law("tanh", contact::JointKind::ball, pair),
         std::make_unique<contact::CosinePressure>(contact::JointKind::ball)});
    const double force = scale.load(random.log_uniform(0.005, 20));
    states.add({joint, force * random.direction(), random.direction()}, random);
  }
  return states;
}

double seconds() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2,
                   values.end());
  return values[values.size() / 2];
}

/// The friction coefficients at the solutions of the moved inputs: the unit.
/// One begins when the one before is there, as in a solver, or they overlap
/// as far as the processor can.
void evaluate(const States& states, bool overlap) {
  double wait = 0;
  for (const JointSolution& s : states.moved_solutions) {
    const auto i =
        contact::friction_integrals(s.half_angle + wait, s.slip_axis);
    benchmark::DoNotOptimize(i);
    if (!overlap) wait = 0 * i.coefficient.force;
  }
}

/// Times `solve` over all states, each time in turn with the unit.
template <class Solve>
void run(benchmark::State& state, const States& states, const Solve& solve) {
  std::vector<double> multiples;
  std::vector<double> nanoseconds;
  for (auto _ : state) {
    const double start = seconds();
    evaluate(states, false);
    const double middle = seconds();
    for (std::size_t i = 0; i < count; ++i) solve(i);
    const double end = seconds();
    state.SetIterationTime(end - middle);
    nanoseconds.push_back(1e9 * (end - middle) / count);
    multiples.push_back((end - middle) / (middle - start));
  }
  state.counters["multiples"] = median(std::move(multiples));
  state.counters["ns"] = median(std::move(nanoseconds));
}

template <class Solve>
void solve_bench(benchmark::State& state, const States& states,
                 const Solve& solve) {
  run(state, states, [&](std::size_t i) {
    benchmark::DoNotOptimize(solve(i).friction_moment.data());
  });
  double evaluations = 0;
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const JointSolution s = solve(i);
    evaluations += s.evaluations;
    largest = std::max(largest,
                       contact::test::true_residual(states.moved[i].joint, s));
  }
  state.counters["evaluations"] = evaluations / count;
  state.counters["max_residual"] = largest;
}

template <bool overlap>
void unit(benchmark::State& state, const States& states) {
  std::vector<double> nanoseconds;
  for (auto _ : state) {
    const double start = seconds();
    evaluate(states, overlap);
    const double time = seconds() - start;
    state.SetIterationTime(time);
    nanoseconds.push_back(1e9 * time / count);
  }
  state.counters["ns"] = median(std::move(nanoseconds));
}

void warm(benchmark::State& state, const States& states) {
  solve_bench(state, states, [&](std::size_t i) {
    const RandomSlip& input = states.moved[i];
    return input.joint.solve(input.slip(), states.solutions[i]);
  });
}

void cold(benchmark::State& state, const States& states) {
  solve_bench(state, states, [&](std::size_t i) {
    const RandomSlip& input = states.moved[i];
    return input.joint.solve(input.slip());
  });
}

/// The paper's inner loop to a residual of 1e-12 or 1,000 steps, over the
/// states where it does not fail.
void fixed_point(benchmark::State& state, const States& states) {
  const auto solve = [&](std::size_t i) {
    const RandomSlip& input = states.moved[i];
    return contact::fixed_point(input.joint, input.slip(), {});
  };
  std::vector<std::size_t> good;
  double steps = 0;
  double most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const FixedPointResult result = solve(i);
    if (result.status != Status::ok) continue;
    good.push_back(i);
    steps += result.steps;
    most = std::max<double>(most, result.steps);
  }
  run(state, states, [&](std::size_t i) {
    benchmark::DoNotOptimize(solve(good[i % good.size()]).steps);
  });
  state.counters["steps"] = steps / static_cast<double>(good.size());
  state.counters["most_steps"] = most;
  state.counters["fails"] = static_cast<double>(count - good.size());
}

/// A friction solution without an equation: the contact's R_n is known.
void known_contact(benchmark::State& state, const States& states) {
  run(state, states, [&](std::size_t i) {
    const RandomSlip& input = states.moved[i];
    benchmark::DoNotOptimize(
        input.joint.solve_contact({input.reaction, input.rate})
            .friction_moment.data());
  });
}

void register_all(const char* name, const States& states) {
  const auto add = [&](const char* what, auto function) {
    benchmark::RegisterBenchmark((std::string(what) + '/' + name).c_str(),
                                 function, states)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  };
  add("unit", unit<false>);
  add("unit_overlapping", unit<true>);
  add("warm", warm);
  add("cold", cold);
  add("fixed_point", fixed_point);
  add("known_contact", known_contact);
}

}  // namespace

int main(int argc, char** argv) {
  const States any = any_states();
  const States steel = steel_states();
  register_all("steel", steel);
  register_all("any", any);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
