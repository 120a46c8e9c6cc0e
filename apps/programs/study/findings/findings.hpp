#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/rows/journal.hpp"
#include "study/statistics/drivers.hpp"
#include "study/statistics/verdict.hpp"
#include "study/study.hpp"

namespace study {

/// A run and a number of it; NaN if it failed.
struct RunValue {
  std::uint64_t run;
  double value;
};

/// Verdict of the runs on a requirement.
struct Judgement {
  std::size_t misses;   ///< failed runs too
  std::size_t missing;  ///< runs without the number, each of them a miss
  /// None unless the runs are random: others are not independent of each other.
  std::optional<Answer> answer;
  Bounds miss_probability;  ///< at the consumer's risk
  std::size_t needed;       ///< runs with so many misses for "met"
  double share;             ///< share of the percentile: success, or the rest
  /// Percentile of all runs. Those without the number are at the end that
  /// misses, so that the percentile or a bound is infinite where it is one of
  /// them.
  Percentile percentile;
  std::vector<RunValue> worst;
};

/// Bounds of a number.
struct Range {
  double low;
  double high;
};

/// How a number scatters: mean, deviation, low and high over the runs that have
/// it. Percentiles are of all runs: from where they are if those without the
/// number are below all others, to where if they are above.
struct Scatter {
  std::string quantity;
  double nominal;
  double mean;
  double deviation;
  double low;
  Range p5, median, p95;
  double high;
  std::size_t missing;
};

/// Drivers of a number, by input.
struct Driven {
  std::string quantity;
  std::vector<double> spearman;
  Regression::Answer regression;
  /// One for each source, with Saltelli's design only.
  std::vector<SobolIndex> sobol;
};

struct Findings {
  std::size_t failed;
  std::string first_failure;
  std::size_t above_limit;  ///< runs with over_limit above 1
  std::vector<Judgement> requirements;
  std::vector<Scatter> quantities;
  std::vector<Driven> driven;  ///< requirements, then other quantities
  std::vector<std::string> idle;
};

/// A number of each run from 1 on.
std::vector<double> column(const Study& study, const Journal& journal,
                           const std::function<double(const Row&)>& number);

/// Numbers that are asked what drives them.
std::size_t count_driven(const Study& study);

/// Reads the journal a column at a time.
Findings find(const Study& study, const Journal& journal);

}  // namespace study
