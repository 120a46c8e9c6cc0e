#pragma once

#include <cstddef>

namespace contact {

/// Vectors of many joints or bodies in the form that lanes over them read and
/// write at once: packets of 8, in each a row of 8 numbers for every component,
/// padded.
struct VectorRows {
  static constexpr int lanes = 8;
  double* first;          ///< x of number 0
  std::ptrdiff_t packet;  ///< numbers from a packet to the next
  /// x of number i; y and z are `lanes` and 2 `lanes` further.
  double* at(int i) const { return first + i / lanes * packet + i % lanes; }
};

}  // namespace contact
