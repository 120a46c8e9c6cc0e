#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace study {

/// Inputs of a run and its results.
struct Row {
  std::uint64_t run;
  std::string failure;  ///< "" or why there are no quantities
  /// Inputs and quantities. NaN: quantities of a run that failed, what a run
  /// has not, and inputs of run 0 but for factors of nominal values, 1.
  std::vector<double> numbers;

  bool operator==(const Row&) const = default;
};

}  // namespace study
