// Exact conforming contact: std::tanh (the paper's law for balls) and one
// Boost set of complete elliptic integrals (K, E, Pi) are the units; beside
// every time stands the error of the method where one is known.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <cmath>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "timing.hpp"

namespace contact::bench {
namespace {

void tanh_law(benchmark::State& state) {
  const std::vector<double> load = loads();
  time_each(state, [&](std::size_t i) { return std::tanh(load[i]); });
}

void boost_set(benchmark::State& state) {
  using Policy = boost::math::policies::policy<
      boost::math::policies::promote_double<false>>;
  std::size_t i = 0;
  for (auto _ : state) {
    const double k = fraction(i++) + 0.5 / count;
    benchmark::DoNotOptimize(boost::math::ellint_1(k, Policy()));
    benchmark::DoNotOptimize(boost::math::ellint_2(k, Policy()));
    benchmark::DoNotOptimize(boost::math::ellint_3(k, 0.5, Policy()));
  }
}

void pin_closed_form_half_angle(benchmark::State& state) {
  const std::vector<double> load = loads();
  const PinClosedForm pin(0.5);
  time_each(state, [&](std::size_t i) { return pin.half_angle(load[i]); });
}

void pin_setup_and_half_angle(benchmark::State& state) {
  const std::vector<double> load = loads();
  const std::vector<ElasticPair> pair = pairs();
  time_solver(state, [&](std::size_t i) {
    return PinContact(pair[i]).half_angle(load[i]);
  });
  double largest = 0;
  for (const double lambda : load) {
    largest = std::max(
        largest,
        std::abs(
            PinContact::from_dundurs(0.5, 0).half_angle(lambda).half_angle -
            PinClosedForm(0.5).half_angle(lambda).half_angle));
  }
  state.counters["max_error_deg"] = largest / degree;
}

void pin_pressure(benchmark::State& state) {
  const std::vector<ElasticPair> pair = pairs();
  time_each(state,
            [&](std::size_t i) { return PinContact(pair[i]).pressure(1.0); });
}

// A pair not seen before; the tables of the method itself exist.
void ball_setup_and_half_angle(benchmark::State& state) {
  const std::vector<double> load = loads();
  const std::vector<ElasticPair> pair = pairs();
  time_each(state, [&](std::size_t i) {
    return BallContact(pair[i]).half_angle(load[i]);
  });
}

void ball_further_half_angle(benchmark::State& state, InnerLoading loading) {
  const std::vector<double> load = loads();
  const ElasticPair pair = ElasticPair::from_modulus_ratio(0.3, 0.2, 0.35);
  const BallContact ball(pair, loading);
  const BallContact fine(pair, loading, BallContact::max_unknowns);
  time_solver(state, [&](std::size_t i) { return ball.half_angle(load[i]); });
  double largest = 0;
  for (std::size_t k = 0; k < count; k += 8) {
    largest = std::max(largest, std::abs(ball.half_angle(load[k]).half_angle -
                                         fine.half_angle(load[k]).half_angle));
  }
  state.counters["max_error_deg"] = largest / degree;
}

void ball_pressure(benchmark::State& state) {
  const BallContact ball(ElasticPair::from_modulus_ratio(0.3, 0.2, 0.35));
  time_each(state, [&](std::size_t i) {
    return ball.pressure(0.5 + 0.9 * fraction(i));
  });
}

// A rigid inner body of radius 1 in a liner (nu = 0.4) on a rigid shell.
LayeredPair lined(double thickness) {
  return {
      1, {{}, Backing::rigid()}, {{{thickness, {1, 0.4}}}, Backing::rigid()}};
}

// The argument is the thickness over the radius in units of 1e-4; the tables
// of the method itself exist.
template <class Contact>
void walled_setup(benchmark::State& state) {
  const LayeredPair pair = lined(1e-4 * static_cast<double>(state.range(0)));
  benchmark::DoNotOptimize(Contact(pair));
  for (auto _ : state) benchmark::DoNotOptimize(Contact(pair));
}

template <class Contact>
void walled_further_half_angle(benchmark::State& state) {
  const std::vector<double> load = loads();
  const Contact contact(lined(1e-4 * static_cast<double>(state.range(0))));
  time_solver(state, [&](std::size_t i) {
    return contact.half_angle(load[i * 37 % count]);
  });
}

// The tables that joints have: thickness 0 is an infinite outer body.
ExactLaw law_of(JointKind kind, std::int64_t thickness) {
  if (thickness == 0) {
    return {kind, ElasticPair::from_modulus_ratio(0.3, 0.2, 0.35)};
  }
  return {kind, lined(1e-4 * static_cast<double>(thickness))};
}

void law_setup(benchmark::State& state, JointKind kind) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(law_of(kind, state.range(0)));
  }
}

void law_half_angle(benchmark::State& state, JointKind kind) {
  const std::vector<double> load = loads();
  const ExactLaw law = law_of(kind, state.range(0));
  time_each(state, [&](std::size_t i) {
    return law.half_angle(load[i * 37 % count]);
  });
}

void thicknesses(benchmark::internal::Benchmark* bench) {
  bench->Arg(10)->Arg(30)->Arg(100)->Arg(200)->Arg(1000)->Arg(10000)->Unit(
      benchmark::kMillisecond);
}

BENCHMARK(tanh_law);
BENCHMARK(boost_set);
BENCHMARK(pin_closed_form_half_angle);
BENCHMARK(pin_setup_and_half_angle);
BENCHMARK(pin_pressure);
BENCHMARK(ball_setup_and_half_angle);
BENCHMARK_CAPTURE(ball_further_half_angle, centre, InnerLoading::centre());
BENCHMARK_CAPTURE(ball_further_half_angle, back, InnerLoading::back(0.5));
BENCHMARK(ball_pressure);
BENCHMARK(walled_setup<BallContact>)->Apply(thicknesses);
BENCHMARK(walled_setup<PinContact>)->Apply(thicknesses);
BENCHMARK(walled_further_half_angle<BallContact>)->Apply(thicknesses);
BENCHMARK(walled_further_half_angle<PinContact>)->Apply(thicknesses);
constexpr auto ball = JointKind::ball;
constexpr auto pin = JointKind::pin;
BENCHMARK_CAPTURE(law_setup, ball, ball)->Arg(0)->Apply(thicknesses);
BENCHMARK_CAPTURE(law_setup, pin, pin)->Arg(0)->Apply(thicknesses);
BENCHMARK_CAPTURE(law_half_angle, ball, ball)->Arg(0)->Arg(30)->Arg(1000);
BENCHMARK_CAPTURE(law_half_angle, pin, pin)->Arg(0)->Arg(200)->Arg(1000);

}  // namespace
}  // namespace contact::bench

BENCHMARK_MAIN();
