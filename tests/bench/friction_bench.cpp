// Friction integrals: one Boost set of complete elliptic integrals (K, E, Pi)
// is the unit; beside every time stands the error of the method.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"

namespace {

using contact::FrictionIntegrals;
using contact::InstructionSet;
using contact::SlipAxis;

constexpr std::size_t count = 4096;
constexpr double right_angle = std::numbers::pi / 2;

struct Points {
  std::vector<double> half_angle, axis_sin, axis_cos;
  void add(double theta0, double a) {
    half_angle.push_back(theta0);
    axis_sin.push_back(std::sin(a));
    axis_cos.push_back(std::cos(a));
  }
  SlipAxis axis(std::size_t i) const { return {axis_sin[i], axis_cos[i]}; }
};

/// Uniform in theta0 and a over the quarter square, or within 1e-6 degrees of
/// the edge theta0 + a = 90 degrees where the pole crosses the contact's edge.
Points points(bool at_edge) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points result;
  for (std::size_t i = 0; i < count; ++i) {
    const double theta0 = right_angle * uniform(random);
    const double off = 1e-6 * contact::degree * (2 * uniform(random) - 1);
    const double a = right_angle * uniform(random);
    result.add(theta0, at_edge ? right_angle - theta0 + off : a);
  }
  return result;
}

template <class Method>
double largest_error(Method method) {
  double largest = 0;
  for (const auto& row : contact::test::friction_reference()) {
    const FrictionIntegrals r = method(row.half_angle, row.axis);
    for (const auto& quantity : contact::test::friction_quantities()) {
      largest =
          std::max(largest, contact::test::relative_error(
                                quantity.of(r), quantity.of(row.expected)));
    }
  }
  return largest;
}

/// Boost's K, E, Pi at the modulus and characteristic of each point.
void boost_set(benchmark::State& state) {
  using Policy = boost::math::policies::policy<
      boost::math::policies::promote_double<false>>;
  struct Arguments {
    double k, n;
  };
  std::vector<Arguments> arguments;
  const Points p = points(false);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = std::sin(p.half_angle[i]) / p.axis_cos[i];
    const double a = std::atan2(p.axis_sin[i], p.axis_cos[i]);
    const double y1 = std::sin(a + p.half_angle[i]);
    const double y2 = std::sin(a - p.half_angle[i]);
    arguments.push_back({std::min(z, 1 / z), (y1 - y2) / (1 - y2)});
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const Arguments& x = arguments[i++ % count];
    benchmark::DoNotOptimize(boost::math::ellint_1(x.k, Policy()));
    benchmark::DoNotOptimize(boost::math::ellint_2(x.k, Policy()));
    benchmark::DoNotOptimize(boost::math::ellint_3(x.k, x.n, Policy()));
  }
}

void exact(benchmark::State& state, bool at_edge) {
  const Points p = points(at_edge);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(contact::friction_integrals(
        p.half_angle[i % count], p.axis(i % count)));
    ++i;
  }
  state.counters["max_error"] = largest_error([](double theta0, SlipAxis a) {
    return contact::friction_integrals(theta0, a);
  });
}

void exact_batch(benchmark::State& state, InstructionSet set, bool at_edge) {
  if (!contact::is_supported(set)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  const contact::detail::WithInstructionSet with(set);
  const Points p = points(at_edge);
  std::array<std::vector<double>, 10> r;
  for (auto& column : r) column.resize(count);
  const contact::FrictionBatchOutput out{r[0], r[1], r[2], r[3], r[4],
                                         r[5], r[6], r[7], r[8], r[9]};
  // One iteration is one point, so that the times compare.
  while (state.KeepRunningBatch(count)) {
    contact::friction_integrals({p.half_angle, p.axis_sin, p.axis_cos}, out);
    benchmark::ClobberMemory();
  }
  state.counters["max_error"] = largest_error([&](double theta0, SlipAxis a) {
    std::array<double, 10> one;
    const auto at = [&](int k) { return std::span(&one[k], 1); };
    contact::friction_integrals(
        {std::span(&theta0, 1), std::span(&a.sin, 1), std::span(&a.cos, 1)},
        {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)});
    return FrictionIntegrals{one[0],
                             {one[1], one[2], one[3]},
                             {one[4], one[5], one[6]},
                             {one[7], one[8], one[9]}};
  });
}

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

/// GSL adaptive quadrature of the six double integrals; the time reported is
/// the median over points.
void gsl_quadrature(benchmark::State& state) {
  const Points p = points(false);
  std::size_t i = 0;
  std::vector<double> seconds;
  for (auto _ : state) {
    const double start = cpu_seconds();
    benchmark::DoNotOptimize(contact::reference::quadrature_friction_integrals(
        p.half_angle[i % count], p.axis(i % count), 1e-10));
    seconds.push_back(cpu_seconds() - start);
    ++i;
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2,
                   seconds.end());
  state.counters["median_ns"] = 1e9 * seconds[seconds.size() / 2];
}

BENCHMARK(boost_set);
BENCHMARK_CAPTURE(exact, uniform, false);
BENCHMARK_CAPTURE(exact, at_edge, true);
BENCHMARK_CAPTURE(exact_batch, baseline, InstructionSet::baseline, false);
BENCHMARK_CAPTURE(exact_batch, avx2, InstructionSet::avx2, false);
BENCHMARK_CAPTURE(exact_batch, avx512, InstructionSet::avx512, false);
BENCHMARK_CAPTURE(exact_batch, avx512_at_edge, InstructionSet::avx512, true);
BENCHMARK(gsl_quadrature)->Unit(benchmark::kMillisecond)->Iterations(64);

}  // namespace

BENCHMARK_MAIN();
