// Rows of slips solved through the C interface beside the same in C++. Each
// once, so that instructions can be counted: valgrind --tool=callgrind
//   build/bench/c_bench --benchmark_filter=pin/c/warm
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "libcontact/c/contact.h"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/random_slip.hpp"

namespace {

using contact::Joint;
using contact::JointSolution;

constexpr std::size_t count = 100'000;

// A path that turns slowly, as of a simulator.
std::vector<contact_slip> path() {
  contact::test::RandomSlips random(5);
  std::vector<contact_slip> slips(count);
  Eigen::Vector3d reaction(0, 300, 2000), rate(1, 0, 0.5);
  for (contact_slip& slip : slips) {
    reaction += 2 * random.direction();
    rate += 1e-3 * random.direction();
    for (int k = 0; k < 3; ++k) {
      slip.reaction[k] = reaction[k];
      slip.angular_velocity[k] = rate[k];
    }
  }
  return slips;
}

struct Rows {
  explicit Rows(const std::string& file)
      : cpp(contact::read_joint(file).contact()), slips(path()) {
    contact_joint_read(file.c_str(), nullptr, 0, &joint);
  }

  void by_c(bool warm) {
    contact_slips s = {};
    s.count = count;
    s.reaction = slips[0].reaction;
    s.angular_velocity = slips[0].angular_velocity;
    s.reaction_stride = s.angular_velocity_stride = sizeof slips[0];
    s.warm = warm;
    if (contact_joint_solve_rows(joint, &s, of_c.data(), sizeof of_c[0])) {
      std::abort();
    }
  }
  void by_cpp(bool warm) {
    for (std::size_t i = 0; i < count; ++i) {
      const Joint::Slip slip = {Eigen::Vector3d(slips[i].reaction),
                                Eigen::Vector3d(slips[i].angular_velocity)};
      of_cpp[i] =
          warm && i > 0 ? cpp.solve(slip, of_cpp[i - 1]) : cpp.solve(slip);
    }
  }

  Joint cpp;
  contact_joint* joint = nullptr;
  std::vector<contact_slip> slips;
  std::vector<contact_solution> of_c = std::vector<contact_solution>(count);
  std::vector<JointSolution> of_cpp = std::vector<JointSolution>(count);
};

void add(const std::string& name, const std::string& file) {
  const auto rows = std::make_shared<Rows>(CONTACT_DATA_DIR "/joints/" + file);
  const auto add_one = [&](const char* way, auto solve) {
    benchmark::RegisterBenchmark(
        (name + way).c_str(),
        [rows, solve](benchmark::State& state) {
          for (auto _ : state) solve(*rows);
          state.SetItemsProcessed(state.iterations() * count);
        })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  };
  add_one("/nothing", [](Rows&) {});
  add_one("/c/warm", [](Rows& r) { r.by_c(true); });
  add_one("/cpp/warm", [](Rows& r) { r.by_cpp(true); });
  add_one("/c/cold", [](Rows& r) { r.by_c(false); });
  add_one("/cpp/cold", [](Rows& r) { r.by_cpp(false); });
}

}  // namespace

int main(int argc, char** argv) {
  add("hip", "hip_cocr_uhmwpe.toml");
  add("ball", "paper_example_2.toml");
  add("pin", "pin_joint.toml");
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
