// Two stages turn apart: prints the stage's position every half second, and the
// events.
#include <cstdio>

#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"

using separation::Run;

int main() {
  const auto c = separation::read_case("data/cases/two_stage_turn.toml");
  separation::RunOptions options;
  options.stop = [](long steps) { return steps < 1000 ? "" : "1000 steps"; };
  Run run(c, options);
  const auto angle = run.memory().rows.column("stage.angle_deg");
  while (run.advance_to(run.time() + 0.5) == Run::Status::running) {
    std::printf("%.1f s: %.3f deg\n", run.time(), run.values()[angle]);
  }
  if (run.status() != Run::Status::finished) {
    std::printf("%s\n", run.message().c_str());
  }
  for (const separation::Note& event : run.memory().notes) {
    std::printf("%.3f s: %s\n", event.time, event.what.c_str());
  }
}
