// Friction in chains of balls and hinges beside Simbody's own steps.
#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

#include "hosts/simbody/hinge_friction.hpp"

namespace {

using namespace SimTK;  // NOLINT(google-build-using-namespace)
using contact_hosts::simbody::Fit;
using contact_hosts::simbody::HingeFriction;

enum class Friction { none, converged, lagged, rests };

// Links that hang and swing, or hang at rest.
struct Chain {
  MultibodySystem system;
  SimbodyMatterSubsystem matter{system};
  GeneralForceSubsystem forces{system};
  std::optional<HingeFriction> friction;
  State state;

  Chain(int links, bool balls, Friction kind) {
    if (kind != Friction::none) {
      const Fit fit = kind == Friction::lagged ? Fit::lagged : Fit::converged;
      friction.emplace(system, forces, contact_hosts::simbody::Options{fit});
    }
    const Force::UniformGravity weight(forces, matter, Vec3(0, 0, -9.81));
    const Body::Rigid body(
        MassProperties(1, Vec3(0, 0, -0.25), Inertia(0.0825, 0.0825, 0.002)));
    // A pin turns about z of its frames: here y of the links.
    const Rotation turn(balls ? 0 : -Pi / 2, XAxis);
    const Transform own(turn, Vec3(0));
    MobilizedBody parent = matter.Ground();
    const std::string file =
        std::string(CONTACT_HOST_TESTS) + (balls ? "ball.toml" : "pin.toml");
    for (int i = 0; i < links; ++i) {
      const Transform on_parent(turn, Vec3(0, 0, i ? -0.5 : 0));
      if (balls) {
        parent = MobilizedBody::Ball(parent, on_parent, body, own);
      } else {
        parent = MobilizedBody::Pin(parent, on_parent, body, own);
      }
      if (friction) friction->add(parent, file);
    }
    state = system.realizeTopology();
    for (int i = 0; i < state.getNU() && kind != Friction::rests; ++i) {
      state.updU()[i] = 1 + 0.1 * i;
    }
    if (friction) friction->settle(state);
  }
};

void step(benchmark::State& state, bool balls, Friction kind) {
  const Chain chain(static_cast<int>(state.range(0)), balls, kind);
  double steps = 0;
  const auto asked = [&] {
    return chain.system.getNumRealizationsOfThisStage(Stage::Dynamics);
  };
  const double before = asked();
  for (auto _ : state) {
    RungeKuttaMersonIntegrator integrator(chain.system);
    integrator.setAccuracy(1e-4);
    TimeStepper stepper(chain.system, integrator);
    stepper.initialize(chain.state);
    stepper.stepTo(0.2);
    steps += integrator.getNumStepsTaken();
  }
  const double evaluations = asked() - before;
  const auto each = benchmark::Counter::kIsRate | benchmark::Counter::kInvert;
  state.counters["step"] = benchmark::Counter(steps, each);
  state.counters["evaluation"] = benchmark::Counter(evaluations, each);
  const auto runs = static_cast<double>(state.iterations());
  state.counters["steps"] = steps / runs;
  state.counters["evaluations"] = evaluations / runs;
}

}  // namespace

int main(int argc, char** argv) {
  for (const bool balls : {true, false}) {
    const std::string name = balls ? "balls/" : "hinges/";
    for (const auto& [kind, text] :
         {std::pair(Friction::none, "none"),
          std::pair(Friction::converged, "converged"),
          std::pair(Friction::lagged, "lagged"),
          std::pair(Friction::rests, "rests")}) {
      auto* const added = benchmark::RegisterBenchmark((name + text).c_str(),
                                                       step, balls, kind);
      added->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond);
      // Sixteen balls with friction take minutes.
      if (!balls) added->Arg(16);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
