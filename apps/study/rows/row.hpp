#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace study {

/// What a run was given and what came of it.
struct Row {
  std::uint64_t run;
  std::string failure;  ///< "" or why there are no quantities
  /// Inputs and quantities. NaN: quantities of a run that failed, what a run
  /// has not, and inputs of run 0 but for factors of nominal values, 1.
  std::vector<double> numbers;

  bool operator==(const Row&) const = default;
};

/// A row as bytes with a checksum, alike on all machines of one byte order,
/// and back.
std::string to_bytes(const Row& row);
/// Takes a row off the front.
/// @throws contact::Error if the bytes are no row of so many numbers
Row take_row(std::string_view& bytes, std::size_t numbers);
/// Whether a row ends in these bytes: one that a writer was killed at does not.
/// @throws contact::Error if it has a size that no row of so many numbers has
bool has_whole_row(std::string_view bytes, std::size_t numbers);
/// Of a failure's text; what is longer is cut.
inline constexpr std::size_t longest_failure = 1000;

}  // namespace study
