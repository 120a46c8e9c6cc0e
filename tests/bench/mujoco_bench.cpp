// Friction in chains of balls and hinges beside MuJoCo's own step.
#include <benchmark/benchmark.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "hosts/mujoco/hinge_friction.hpp"

namespace {

using contact_hosts::mujoco::HingeFriction;

const std::string folder = CONTACT_HOST_TESTS;

// Links that hang and swing a little.
struct Chain {
  mjModel* model;
  mjData* data;

  Chain(int links, const std::string& type) {
    std::string begin;
    std::string end;
    for (int i = 0; i < links; ++i) {
      begin += "<body pos='0 0 " + std::string(i ? "-.5" : "0") +
               "'><joint name='" + std::to_string(i) + "' " + type +
               "/><inertial mass='1' pos='0 0 -.25' diaginertia='.02 .02 "
               ".002'/>";
      end += "</body>";
    }
    const std::string path = "contact_mujoco_bench.xml";
    std::ofstream(path) << "<mujoco><option timestep='1e-3'/><worldbody>"
                        << begin << end << "</worldbody></mujoco>";
    char error[300] = "";
    model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    if (!model) throw std::runtime_error(error);
    data = mj_makeData(model);
  }
  ~Chain() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }
  // Rates that all hinges keep for the time that is measured, or none.
  void restart(bool slides) const {
    mj_resetData(model, data);
    for (int i = 0; i < model->nv && slides; ++i) data->qvel[i] = 1 + 0.1 * i;
  }
};

constexpr int steps = 20;

enum class Friction { none, slides, rests };

void step(benchmark::State& state, bool balls, Friction kind) {
  const int links = static_cast<int>(state.range(0));
  const Chain chain(links, balls ? "type='ball'" : "type='hinge' axis='0 1 0'");
  double sweeps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    chain.restart(kind != Friction::rests);
    HingeFriction friction(chain.model);
    for (int i = 0; i < links; ++i) {
      friction.add(std::to_string(i),
                   folder + (balls ? "ball.toml" : "pin.toml"));
    }
    state.ResumeTiming();
    for (int i = 0; i < steps; ++i) {
      if (kind == Friction::none) {
        mj_step(chain.model, chain.data);
      } else {
        friction.step(chain.data);
        sweeps += friction.sweeps().sweeps;
      }
    }
  }
  state.counters["step"] =
      benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate |
                                    benchmark::Counter::kInvert);
  state.counters["sweeps"] =
      sweeps / steps / static_cast<double>(state.iterations());
}

}  // namespace

int main(int argc, char** argv) {
  for (const bool balls : {true, false}) {
    const std::string name = balls ? "balls/" : "hinges/";
    for (const auto& [kind, text] : {std::pair(Friction::none, "mj_step"),
                                     std::pair(Friction::slides, "slides"),
                                     std::pair(Friction::rests, "rests")}) {
      benchmark::RegisterBenchmark((name + text).c_str(), step, balls, kind)
          ->Arg(1)
          ->Arg(4)
          ->Arg(16);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
