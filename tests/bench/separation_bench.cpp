// How much faster than real time separations run: without output and
// clearance, friction converged at every evaluation; what a checkpoint costs.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "programs/separation/output/checkpoint.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"

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

// A checkpoint with one new row after many others: its cost does not depend on
// them.
void checkpoint(benchmark::State& state) {
  const separation::Case c =
      separation::read_case(CONTACT_DATA_DIR "/cases/soyuz.toml");
  separation::Simulation simulation(c, FrictionChoice::full);
  separation::Recorder recorder(c, true, false, false);
  recorder.look(simulation);
  separation::Recorder::Memory memory = recorder.memory();
  auto& numbers = memory.rows.numbers;
  const std::vector<double> row = numbers;
  const auto add_row = [&] {
    numbers.insert(numbers.end(), row.begin(), row.end());
  };
  for (long i = 1; i < state.range(0); ++i) add_row();

  const auto folder = std::filesystem::temp_directory_path() /
                      ("separation_bench." + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  {
    separation::CheckpointWriter writer(folder / "c.cbor", "bench", 1);
    writer.write(simulation.save(), memory);
    for (auto _ : state) {
      add_row();
      writer.write(simulation.save(), memory);
    }
  }
  std::filesystem::remove_all(folder);
}

BENCHMARK(checkpoint)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(run, soyuz_full, "soyuz", FrictionChoice::full);
BENCHMARK_CAPTURE(run, soyuz_ideal, "soyuz", FrictionChoice::ideal);
BENCHMARK_CAPTURE(run, two_stage_turn, "two_stage_turn", FrictionChoice::full);
BENCHMARK_CAPTURE(run, slosh, "slosh", FrictionChoice::full);
BENCHMARK_CAPTURE(run, flywheels, "flywheels", FrictionChoice::full);
BENCHMARK_CAPTURE(run, platform, "platform", FrictionChoice::full);

}  // namespace

BENCHMARK_MAIN();
