// Friction coefficients by pressure law: the cosine pressure is the unit;
// beside every time stands the error against quadrature of the definition.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/tools/reference/quadrature.hpp"

namespace {

using contact::InstructionSet;
using contact::JointKind;
using contact::PressureLaw;
using contact::SlipAxis;

constexpr std::size_t count = 4096;

// Steel ball, polymer seat: the exact pressure's expansion is a long one.
contact::ElasticPair pair() {
  return contact::ElasticPair::from_modulus_ratio(7, 0.3, 0.4);
}

// Uniform in theta0 (from `low` to `high`, deg) and a.
struct Points {
  std::vector<double> half_angle, axis_sin, axis_cos;
  Points(double low, double high) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const double a = std::numbers::pi / 2 * uniform(random);
      half_angle.push_back((low + (high - low) * uniform(random)) *
                           contact::degree);
      axis_sin.push_back(std::sin(a));
      axis_cos.push_back(std::cos(a));
    }
  }
};

double largest_error(const PressureLaw& law) {
  double largest = 0;
  for (const auto& [theta0_deg, alpha_deg] :
       {std::array{10.0, 30.0}, {40.0, 45.0}, {60.0, 60.0}, {100.0, 35.0}}) {
    const SlipAxis axis = SlipAxis::from_degrees(alpha_deg);
    const double half_angle = theta0_deg * contact::degree;
    if (half_angle > law.largest_half_angle()) continue;
    const auto c =
        contact::friction_integrals(law, half_angle, axis).coefficient;
    const auto e = contact::reference::quadrature_friction_integrals(
                       law, half_angle, axis, 1e-11)
                       .value.coefficient;
    largest = std::max({largest, std::abs(c.force / e.force - 1),
                        std::abs(c.sliding / e.sliding - 1),
                        std::abs(c.spinning / e.spinning - 1)});
  }
  return largest;
}

void scalar(benchmark::State& state, const std::string& name, double low,
            double high) {
  const auto law = contact::make_pressure_law(name, JointKind::ball, pair());
  const Points p(low, high);
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ % count;
    benchmark::DoNotOptimize(contact::friction_integrals(
        *law, p.half_angle[k], {p.axis_sin[k], p.axis_cos[k]}));
  }
  state.counters["max_error"] = largest_error(*law);
}

void batch(benchmark::State& state, const std::string& name, InstructionSet set,
           double low, double high) {
  if (!contact::is_supported(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  const contact::detail::WithInstructionSet with(set);
  const auto law = contact::make_pressure_law(name, JointKind::ball, pair());
  const Points p(low, high);
  std::array<std::vector<double>, 3> r;
  for (auto& column : r) column.resize(count);
  // One iteration is one point, so that the times compare.
  while (state.KeepRunningBatch(count)) {
    contact::friction_integrals(*law, {p.half_angle, p.axis_sin, p.axis_cos},
                                {{}, {}, {}, {}, {}, {}, {}, r[0], r[1], r[2]});
    benchmark::ClobberMemory();
  }
}

void make_exact(benchmark::State& state, JointKind kind) {
  const auto materials = pair();
  for (auto _ : state) {
    benchmark::DoNotOptimize(contact::ExactPressure(kind, materials));
  }
}

void register_all() {
  for (const std::string& name : contact::pressure_law_names()) {
    benchmark::RegisterBenchmark(("scalar/" + name).c_str(), scalar, name, 0,
                                 90);
    const bool wide = name != "worn";  // which ends at 90 deg
    if (wide) {
      benchmark::RegisterBenchmark(("beyond_90_deg/" + name).c_str(), scalar,
                                   name, 90, 120);
    }
    using enum InstructionSet;
    for (const auto set : {baseline, avx2, avx512}) {
      benchmark::RegisterBenchmark(
          ("batch_" + std::string(contact::name(set)) + "/" + name).c_str(),
          batch, name, set, 0, 90);
      if (!wide) continue;
      benchmark::RegisterBenchmark(
          ("batch_beyond_90_deg_" + std::string(contact::name(set)) + "/" +
           name)
              .c_str(),
          batch, name, set, 90, 120);
    }
  }
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    benchmark::RegisterBenchmark(
        ("make_exact/" + std::string(to_string(kind))).c_str(), make_exact,
        kind)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
