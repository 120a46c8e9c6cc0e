#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "libcontact/pair/material.hpp"

/// Timing for all benchmarks.
namespace contact::bench {

/// Number of inputs that fits the cache.
inline constexpr std::size_t count = 256;

/// (i mod count)/count.
inline double fraction(std::size_t i) {
  return static_cast<double>(i % count) / count;
}

/// Loads from 1e-3 to 1e3, evenly spaced in the logarithm.
inline std::vector<double> loads() {
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(std::pow(10, -3 + 6 * fraction(i)));
  }
  return result;
}

/// Pairs of unequal materials, all different.
inline std::vector<ElasticPair> pairs() {
  std::vector<ElasticPair> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(ElasticPair::from_modulus_ratio(
        std::pow(10, -2 + 4 * fraction(i)), 0.2 + 0.25 * fraction(i), 0.3));
  }
  return result;
}

/// Times call(i) for i from 0 to count - 1, repeatedly.
template <class Call>
void time_each(benchmark::State& state, const Call& call,
               std::size_t inputs = count) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(call(i));
    if (++i == inputs) i = 0;
  }
}

/// As above, for functions that count their evaluations; shows their mean.
template <class Call>
void time_solver(benchmark::State& state, const Call& call) {
  double evaluations = 0;
  time_each(state, [&](std::size_t i) {
    const auto result = call(i);
    evaluations += result.evaluations;
    return result;
  });
  state.counters["evaluations"] =
      evaluations / static_cast<double>(state.iterations());
}

}  // namespace contact::bench
