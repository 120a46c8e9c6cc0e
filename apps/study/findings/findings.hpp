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

/// What the runs say of a requirement.
struct Judgement {
  std::size_t misses;  ///< failed runs too
  /// None unless the runs are random: others are not independent of each other.
  std::optional<Answer> answer;
  Bounds miss_probability;  ///< at the consumer's risk
  std::size_t needed;       ///< runs with so many misses for "met"
  double share;           ///< that of the percentile: success, or what is left
  Percentile percentile;  ///< of all runs that did not fail
  std::vector<RunValue> worst;
};

/// How a number scatters over the runs that have it.
struct Scatter {
  std::string quantity;
  double nominal;
  double mean;
  double deviation;
  double low, p5, median, p95, high;
  std::size_t missing;
};

/// What drives a number: of each input.
struct Driven {
  std::string quantity;
  std::vector<double> spearman;
  Regression::Answer regression;
  /// Of each source, of Saltelli's design only.
  std::vector<SobolIndex> sobol;
};

struct Findings {
  std::size_t failed;
  std::string first_failure;
  std::size_t above_limit;  ///< runs with over_limit above 1
  std::vector<Judgement> requirements;
  std::vector<Scatter> quantities;
  std::vector<Driven> driven;  ///< of requirements, then of other quantities
  std::vector<std::string> idle;
};

/// A number of each run from 1 on.
std::vector<double> column(const Study& study, const Journal& journal,
                           const std::function<double(const Row&)>& number);

/// Reads the journal a column at a time.
Findings find(const Study& study, const Journal& journal);

}  // namespace study
