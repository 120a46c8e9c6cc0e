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

/// A run and one of its numbers; NaN if it failed.
struct RunValue {
  std::uint64_t run;
  double value;
};

/// Verdict on a requirement.
struct Judgement {
  std::size_t misses;   ///< including failed runs
  std::size_t missing;  ///< runs without the number; each counts as a miss
  /// Only for random runs: runs of other samplings are not independent.
  std::optional<Answer> answer;
  Bounds miss_probability;  ///< at the consumer's risk
  std::size_t needed;       ///< runs needed for "met" with these misses
  double share;             ///< percentile's: success, or 1 - success
  /// Percentile of all runs. Runs without the number count at the failing end,
  /// so the percentile or a bound can be infinite.
  Percentile percentile;
  std::vector<RunValue> worst;
};

/// Lower and upper bound of a number.
struct Range {
  double low;
  double high;
};

/// Scatter of a number: mean, deviation, low and high over the runs that have
/// it. Percentiles count all runs: `from` counts runs without the number below
/// all others, `to` above all others.
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

/// The drivers of a number, by input.
struct Driven {
  std::string quantity;
  std::vector<double> spearman;
  Regression::Answer regression;
  /// One for each source; only with Saltelli's design.
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

/// One number of all runs from run 1.
std::vector<double> column(const Study& study, const Journal& journal,
                           const std::function<double(const Row&)>& number);

/// Number of quantities whose drivers are sought.
std::size_t count_driven(const Study& study);

/// Evaluates the journal, one column at a time.
Findings find(const Study& study, const Journal& journal);

}  // namespace study
