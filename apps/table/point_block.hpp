#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/line_blocks.hpp"
#include "cli/number.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "table/method.hpp"

namespace hinge_table {

inline constexpr cli::Allowed allowed_theta0{0, 120, "deg"};
inline constexpr cli::Allowed allowed_alpha{-90, 90, "deg"};

/// Columns of a file of points.
struct PointColumns {
  /// Reads a header line. Throws contact::Error if a column is missing or
  /// occurs twice.
  /// @param place  "points.csv, line 1", for messages
  PointColumns(std::string_view header, const std::string& place);

  std::size_t theta0;
  std::size_t alpha;
  std::size_t count;
  std::vector<std::string> riding;  ///< names of all others, in order
};

/// Some points on their way through the program; one for each thread, whose
/// memory is used again for the points that follow.
struct PointBlock {
  cli::LineBlock lines;  ///< for points from a file

  std::size_t size() const { return theta0_deg.size(); }
  std::vector<double> theta0_deg;  ///< NaN for a bad line
  std::vector<double> alpha_deg;
  /// Raw fields of the riding columns, point after point.
  std::vector<std::string_view> riding;
  std::string messages;  ///< of bad lines
  std::size_t bad_lines = 0;
  std::size_t inaccurate = 0;  ///< points that missed the method's tolerance

  std::vector<double> half_angle;
  std::vector<double> axis_sin;
  std::vector<double> axis_cos;
  std::array<std::vector<double>, quantities.size()> results;
  std::vector<std::string_view> fields;
  cli::Text rows;
};

/// Points number `first` to `last` - 1 of a grid, alpha running fastest.
void take_grid_points(const cli::Sweep& theta0, const cli::Sweep& alpha,
                      std::size_t first, std::size_t last, PointBlock& block);

/// Points of `block.lines`, one for each line that is not blank.
void read_points(const PointColumns& columns, PointBlock& block);

void compute(const Method& method, PointBlock& block);

/// The points and their results as rows of a table with the columns
/// theta0_deg, alpha_deg, quantities, riding ones. The row of a bad line is
/// ERROR, empty cells, and its riding columns if the line could be split.
void write_rows(const cli::Table& table, PointBlock& block);

}  // namespace hinge_table
