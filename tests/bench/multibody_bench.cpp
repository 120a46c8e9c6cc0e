// One acceleration evaluation of a carrier with L loads: state in, all
// accelerations out, kinematics included, frictionless, gravity only.
#include <benchmark/benchmark.h>

#include "multibody/prepared.hpp"
#include "multibody_support/dense_solver.hpp"
#include "multibody_support/random_instant.hpp"
#ifdef CONTACT_HAS_SIMBODY
#include "simbody_system.hpp"
#endif

namespace {

using multibody::Instant;
using multibody::test::Mix;

Instant free_motion(Mix mix, int loads) {
  Instant instant = random_instant(mix, loads, 1);
  instant.active_force.setZero();
  instant.active_moment_com.setZero();
  for (multibody::LoadInstant& load : instant.loads) {
    load.active_force.setZero();
    load.active_moment_com.setZero();
    load.friction_moment.setZero();
  }
  return instant;
}

void two_step(benchmark::State& state, Mix mix) {
  const auto p = prepare(free_motion(mix, static_cast<int>(state.range(0))));
  multibody::Dynamics dynamics = p.dynamics();
  for (auto _ : state) {
    dynamics.evaluate(p.state.data(), p.loading);
    benchmark::DoNotOptimize(&dynamics.relative_acceleration(0));
    benchmark::ClobberMemory();
  }
}

void increment(benchmark::State& state, Mix mix) {
  const auto p = prepare(free_motion(mix, static_cast<int>(state.range(0))));
  multibody::Dynamics dynamics = p.dynamics();
  dynamics.evaluate(p.state.data(), p.loading);
  const std::vector<multibody::Vec3<double>> change(dynamics.size(),
                                                    {1e-3, 2e-3, -1e-3});
  for (auto _ : state) {
    dynamics.add_friction(change);
    benchmark::DoNotOptimize(&dynamics.relative_acceleration(0));
    benchmark::ClobberMemory();
  }
}

void dense_cholesky(benchmark::State& state, Mix mix) {
  const auto p = prepare(free_motion(mix, static_cast<int>(state.range(0))));
  multibody::test::DenseSolver dense(p.system);
  for (auto _ : state) {
    dense.evaluate(p.state.data(), p.loading);
    benchmark::DoNotOptimize(&dense.relative_acceleration(0));
    benchmark::ClobberMemory();
  }
}

#ifdef CONTACT_HAS_SIMBODY
void simbody(benchmark::State& state, Mix mix) {
  const Instant instant = free_motion(mix, static_cast<int>(state.range(0)));
  multibody::bench::SimbodySystem system(instant);
  for (auto _ : state) system.evaluate();
  const multibody::InstantResult ours = evaluate(instant);
  state.counters["difference"] =
      (ours.acceleration - system.carrier_acceleration()).norm() /
          ours.acceleration.norm() +
      (ours.angular_acceleration - system.carrier_angular_acceleration())
              .norm() /
          ours.angular_acceleration.norm();
}
#endif

void register_all(const std::string& name, Mix mix) {
  const auto add = [&](const char* method, auto function, int most) {
    auto* b = benchmark::RegisterBenchmark(
        (name + "/" + method).c_str(),
        [=](benchmark::State& state) { function(state, mix); });
    for (const int loads : {1, 2, 4, 8, 16, 64, 256}) {
      if (loads <= most) b->Arg(loads);
    }
  };
  add("two_step", two_step, 256);
  add("increment", increment, 256);
  add("dense_cholesky", dense_cholesky, 64);
#ifdef CONTACT_HAS_SIMBODY
  add("simbody", simbody, 256);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  register_all("spherical", Mix::spherical);
  register_all("axes", Mix::axes);
  benchmark::RunSpecifiedBenchmarks();
}
