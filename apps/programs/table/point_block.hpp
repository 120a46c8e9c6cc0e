#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cli/stream/points.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "programs/table/method.hpp"

namespace hinge_table {

/// Columns of points: half-angle, slip axis angle.
inline constexpr std::array<cli::PointColumn, 2> point_columns = {
    {{"theta0_deg", {0, 120, "deg"}}, {"alpha_deg", {-90, 90, "deg"}}}};

/// A block of points that the program works on.
struct PointBlock : cli::PointLines {
  const std::vector<double>& theta0_deg() const { return values[0]; }
  const std::vector<double>& alpha_deg() const { return values[1]; }
  /// True if a point is above the pressure's largest half-angle and has no
  /// values.
  bool is_beyond(std::size_t i) const { return half_angle[i] > largest; }
  double largest = 0;          ///< half-angle of the pressure, rad
  std::size_t beyond = 0;      ///< points above it
  std::size_t inaccurate = 0;  ///< points that missed the method's tolerance
  std::size_t failed = 0;      ///< points whose numbers are not all finite

  std::vector<double> half_angle;
  std::vector<double> axis_sin;
  std::vector<double> axis_cos;
  std::vector<std::vector<double>> results;  ///< one for each quantity
};

/// Sets the points from their values.
void set_points(std::vector<double> theta0_deg, std::vector<double> alpha_deg,
                PointBlock& block);

/// Sets the points of the grid in the block's rows; alpha varies fastest.
void take_grid_points(const cli::Sweep& theta0, const cli::Sweep& alpha,
                      PointBlock& block);

void compute(const Method& method, PointBlock& block);

/// Writes a number of a point; ERROR if it must exist but is not finite.
void write_quantity(const PointBlock& block, std::size_t point,
                    std::size_t quantity, cli::RowWriter& row);

/// Writes the points and their results as rows with the columns theta0_deg,
/// alpha_deg, quantities.
void write_rows(const PointBlock& block, cli::RowWriter& row);
/// As above, with the columns of a file of points that are passed through. A
/// bad line gives ERROR and empty cells, and the other columns if the line
/// could be split.
void write_rows(const cli::PointColumns& columns, const PointBlock& block,
                cli::RowWriter& row);

}  // namespace hinge_table
