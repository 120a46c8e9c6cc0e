// How much faster than real time separations run: without output and
// clearance, friction converged at every evaluation.
#include <benchmark/benchmark.h>

#include <string>

#include "separation/case_reader.hpp"
#include "separation/run_case.hpp"

namespace {

using separation::FrictionChoice;

void run(benchmark::State& state, const std::string& name,
         FrictionChoice friction) {
  const separation::Case c =
      separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
  separation::RunOptions options;
  options.friction = friction;
  options.rows = false;
  options.clearance = false;
  options.only_events = true;
  separation::Outcome outcome;
  for (auto _ : state) {
    outcome = separation::run_case(c, options);
    benchmark::DoNotOptimize(outcome);
  }
  if (!outcome.failure.empty()) state.SkipWithError(outcome.failure.c_str());
  state.counters["times_real_time"] = benchmark::Counter(
      c.end_time, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["steps"] = static_cast<double>(outcome.counts.steps);
  state.counters["evaluations"] =
      static_cast<double>(outcome.counts.evaluations);
  state.counters["outer_iterations"] =
      static_cast<double>(outcome.counts.outer_iterations);
}

BENCHMARK_CAPTURE(run, soyuz_full, "soyuz", FrictionChoice::full);
BENCHMARK_CAPTURE(run, soyuz_ideal, "soyuz", FrictionChoice::ideal);
BENCHMARK_CAPTURE(run, two_stage_turn, "two_stage_turn", FrictionChoice::full);
BENCHMARK_CAPTURE(run, slosh, "slosh", FrictionChoice::full);
BENCHMARK_CAPTURE(run, flywheels, "flywheels", FrictionChoice::full);
BENCHMARK_CAPTURE(run, platform, "platform", FrictionChoice::full);

}  // namespace

BENCHMARK_MAIN();
