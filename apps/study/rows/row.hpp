#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace study {

/// Inputs and results of a run.
struct Row {
  std::uint64_t run;
  std::string failure;  ///< "" or the reason why there are no quantities
  /// Inputs and quantities. NaN for quantities of a failed run, for undefined
  /// quantities, and for the inputs of run 0, except factors on nominal values,
  /// which are 1.
  std::vector<double> numbers;

  bool operator==(const Row&) const = default;
};

}  // namespace study
