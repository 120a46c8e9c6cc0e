#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// Bounds of a probability from random runs, by counting alone (Hanson and
/// Beard, libcontact/docs/reference/references.md#hanson-2010): nothing is
/// assumed of the distribution.
namespace study {

/// Requirement on a share of runs.
struct Demand {
  double success = 0.9973;  ///< share of all possible runs that has to succeed
  double risk = 0.1;        ///< consumer's risk of a wrong "met"
};

/// Probability that at most k of n runs fail if each fails with probability p.
double at_most(std::size_t k, std::size_t n, double p);

/// Runs that are needed with so many failures among them: the fewest for which
/// at_most(failures, n, 1 - success) <= risk.
/// @throws contact::Error if there are more than 1e9
std::size_t runs_needed(std::size_t failures, const Demand& demand);

enum class Answer {
  met,      ///< but for the risk
  not_met,  ///< the share that fails is above 1 - success but for the risk
  open,     ///< more runs are needed to say
};
Answer answer(std::size_t failures, std::size_t runs, const Demand& demand);

/// Clopper and Pearson's bounds of the probability of failure, each exceeded
/// with the risk.
struct Bounds {
  double low;
  double high;
};
Bounds failure_bounds(std::size_t failures, std::size_t runs, double risk);

/// A percentile of sorted numbers: an estimate between two of them, which is
/// above the true one half of the times, and the order statistics that bound
/// that, each wrong with the risk at most; none where there are too few runs.
/// The numbers may be infinite at one of the ends.
struct Percentile {
  double value;
  std::optional<double> low;
  std::optional<double> high;
};
Percentile percentile(std::span<const double> sorted, double p, double risk);

}  // namespace study
