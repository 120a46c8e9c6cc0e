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

/// Some points on their way through the program.
struct PointBlock : cli::PointLines {
  const std::vector<double>& theta0_deg() const { return values[0]; }
  const std::vector<double>& alpha_deg() const { return values[1]; }
  /// Whether a point is above the pressure's largest half-angle: without
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

/// Points given by their values.
void set_points(std::vector<double> theta0_deg, std::vector<double> alpha_deg,
                PointBlock& block);

/// The points of a grid that are the block's rows, alpha running fastest.
void take_grid_points(const cli::Sweep& theta0, const cli::Sweep& alpha,
                      PointBlock& block);

void compute(const Method& method, PointBlock& block);

/// A number of a point; ERROR in the place of one that has to be there and is
/// not finite.
void write_quantity(const PointBlock& block, std::size_t point,
                    std::size_t quantity, cli::RowWriter& row);

/// The points and their results as rows of a table with the columns
/// theta0_deg, alpha_deg, quantities.
void write_rows(const PointBlock& block, cli::RowWriter& row);
/// The same with the riding columns of a file of points. The row of a bad line
/// is ERROR, empty cells, and its riding columns if the line could be split.
void write_rows(const cli::PointColumns& columns, const PointBlock& block,
                cli::RowWriter& row);

}  // namespace hinge_table
