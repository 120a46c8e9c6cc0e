#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// Bounds of a probability from random runs by counting (Hanson and Beard,
/// libcontact/docs/reference/references.md#hanson-2010), without an assumption
/// on the distribution.
namespace study {

/// Required share of successful runs.
struct Demand {
  double success = 0.9973;  ///< required share of all possible runs
  double risk = 0.1;        ///< consumer's risk of a wrong "met"
};

/// Probability that at most k of n runs fail if each fails with probability p.
double at_most(std::size_t k, std::size_t n, double p);

/// Smallest number of runs that can meet the demand with this number of
/// failures: at_most(failures, n, 1 - success) <= risk.
/// @throws contact::Error for more than 1e9
std::size_t runs_needed(std::size_t failures, const Demand& demand);

enum class Answer {
  met,      ///< wrong with probability `risk` at most
  not_met,  ///< the failing share exceeds 1 - success, same risk
  open,     ///< more runs are needed to decide
};
Answer answer(std::size_t failures, std::size_t runs, const Demand& demand);

/// Clopper-Pearson bounds of the probability of failure; each is exceeded with
/// probability `risk`.
struct Bounds {
  double low;
  double high;
};
Bounds failure_bounds(std::size_t failures, std::size_t runs, double risk);

/// A percentile of sorted numbers: a median-unbiased estimate between two of
/// them, and the order statistics that bound the true percentile, each wrong
/// with probability `risk` at most; none if there are too few runs. The numbers
/// at one end may be infinite.
struct Percentile {
  double value;
  std::optional<double> low;
  std::optional<double> high;
};
Percentile percentile(std::span<const double> sorted, double p, double risk);

}  // namespace study
