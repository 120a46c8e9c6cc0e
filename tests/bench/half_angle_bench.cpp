// The half-angle laws. One std::tanh is the unit; error_percent is the law's
// largest error against exact.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "timing.hpp"

namespace {

using namespace contact;
using Clock = std::chrono::steady_clock;

using namespace contact::bench;

double nanoseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

void unit(benchmark::State& state) {
  const std::vector<double> load = loads();
  time_each(state, [&](std::size_t i) { return std::tanh(load[i]); });
}

// Unequal materials.
ElasticPair unequal_pair() {
  return ElasticPair::from_modulus_ratio(0.3, 0.35, 0.25);
}

void half_angle(benchmark::State& state, const char* name, JointKind kind) {
  const std::vector<double> load = loads();
  const ElasticPair pair = unequal_pair();
  const auto law = make_half_angle_law(name, kind, pair);
  time_each(state, [&](std::size_t i) { return law->half_angle(load[i]); });
  const ExactLaw exact(kind, pair);
  double error = 0;
  for (const double value : load) {
    const double half_angle = law->half_angle(value).half_angle;
    // (Hertz has no value beyond x = 1.)
    if (std::isnan(half_angle)) continue;
    error = std::max(
        error, std::abs(half_angle / exact.half_angle(value).half_angle - 1));
  }
  state.counters["error_percent"] = 100 * error;
}

void load_parameter(benchmark::State& state, const char* name, JointKind kind) {
  const auto law = make_half_angle_law(name, kind, unequal_pair());
  const double limit = law->limit_half_angle();
  time_each(state, [&](std::size_t i) {
    return law->load_parameter(limit * fraction(i)).load_parameter;
  });
}

// A law of a pair not seen before, and one half-angle.
void set_up(benchmark::State& state, const char* name, JointKind kind) {
  const std::vector<double> load = loads();
  const std::vector<ElasticPair> pair = pairs();
  time_each(state, [&](std::size_t i) {
    return make_half_angle_law(name, kind, pair[i])->half_angle(load[i]);
  });
}

void register_all() {
  benchmark::RegisterBenchmark("tanh", unit);
  for (const JointKind kind : {JointKind::pin, JointKind::ball}) {
    const std::string joint = kind == JointKind::pin ? "pin" : "ball";
    for (const char* name :
         {"hertz", "arctan", "tanh", "blend:0.5", "fitted", "exact"}) {
      benchmark::RegisterBenchmark((joint + "/half_angle/" + name).c_str(),
                                   half_angle, name, kind);
    }
    for (const char* name : {"tanh", "blend:0.5", "fitted", "exact"}) {
      benchmark::RegisterBenchmark((joint + "/load_parameter/" + name).c_str(),
                                   load_parameter, name, kind);
    }
    for (const char* name : {"fitted", "exact"}) {
      benchmark::RegisterBenchmark((joint + "/set_up/" + name).c_str(), set_up,
                                   name, kind);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Before anything else: what the first exact ball of a program takes, the
  // tables of the method included, and a further load of the same pair.
  const Clock::time_point start = Clock::now();
  const ExactLaw ball(JointKind::ball, unequal_pair());
  benchmark::DoNotOptimize(ball.half_angle(1));
  const double first = nanoseconds_since(start);
  const Clock::time_point again = Clock::now();
  benchmark::DoNotOptimize(ball.half_angle(2));
  benchmark::AddCustomContext("first_exact_ball_ms",
                              std::to_string(1e-6 * first));
  benchmark::AddCustomContext("further_load_us",
                              std::to_string(1e-3 * nanoseconds_since(again)));
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
