#pragma once

#include <Eigen/Core>
#include <array>

#include "libcontact/seat/table.hpp"

/// Parts of a SeatTable.
namespace contact {
namespace detail {

/// Steps of the largest squares; they may be halved this many times.
inline constexpr int table_halvings = 6;
inline constexpr int largest_square = 3 << table_halvings;

/// Numbers of a state; pressures over load/rho^2.
enum SeatNumber {
  shift_x,  // over the clearance and load/(E rho)
  shift_z,
  sum,   // S
  area,  // over rho^2
  inner_peak,
  inner_angle,
  rim_peak,                  // lower and upper rim, near and far longitude
  intensity = rim_peak + 4,  // over load/rho^1.5
  arc = intensity + 2,
  lower_end = arc + 2,
  upper_end,
  count
};

}  // namespace detail

struct SeatTable::Node {
  static_assert(int(Numbers::SizeAtCompileTime) == int(detail::count));
  Numbers numbers;
  Eigen::ArrayXf pressure, area;  // harmonics, over the load and rho^2
};

// States (i + size/3 k, j + size/3 l), in steps from the lowest place.
struct SeatTable::Square {
  int i, j, size;
  std::array<int, 16> nodes = {};  // k runs fastest
  int halves = -1;                 // the first of four
  int is_used = 0;                 // no padding: its bytes are kept
};

struct SeatTable::Place {
  Eigen::Array2d at;  // in steps
  double load;
  bool is_mirrored;
};

}  // namespace contact
