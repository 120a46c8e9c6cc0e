#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

#include "separation/case/force_kind.hpp"

/// Forces given by tables.
namespace separation {

/// Values over a variable, linear between the rows and constant outside. Two
/// rows at one place are a jump from the first value to the second, which holds
/// at the place itself.
template <class Value>
struct Table {
  std::vector<double> at;  ///< increasing; a single row is a constant
  std::vector<Value> values;

  /// @param origin  zero of the rows
  Value operator()(double x, double origin = 0) const {
    const double from_origin = x - origin;
    // A jump is at origin + at[i], like the break of the forces, so that
    // rounding of the difference does not move x across it.
    const auto rows = std::views::iota(0, static_cast<int>(at.size()));
    const auto is_passed = [&](int row) {
      return jumps(row) ? origin + at[row] <= x : at[row] <= from_origin;
    };
    const auto i = static_cast<std::size_t>(
        std::ranges::partition_point(rows, is_passed) - rows.begin());
    if (i == 0) return values.front();
    if (i == at.size()) return values.back();
    const double part = (from_origin - at[i - 1]) / (at[i] - at[i - 1]);
    return values[i - 1] + part * (values[i] - values[i - 1]);
  }
  bool jumps(std::size_t i) const {
    return (i > 0 && at[i - 1] == at[i]) ||
           (i + 1 < at.size() && at[i] == at[i + 1]);
  }
  /// Times of its kinks and jumps, as ForceLaw::add_breaks().
  void add_breaks(double begin, std::vector<double>& breaks) const {
    for (const double x : at) breaks.push_back(begin + x);
  }
};

/// A table with its integral.
struct IntegratedTable : Table<double> {
  IntegratedTable() = default;
  IntegratedTable(std::vector<double> rows, std::vector<double> numbers);
  /// From the first row to x.
  double integral(double x) const;

 private:
  std::vector<double> sums_;  // to each row
};

/// Variable of a force's tables: time since the force began, or the angle of
/// the body's hinge.
enum class Variable { none, time, angle };

/// Rows over the keys `time` or `angle`; none if both are missing.
struct RowsOver {
  Variable variable = Variable::none;
  std::vector<double> at;
};
RowsOver read_variable(const ForceTable& from);

/// Appends rows over the hinge's angle, and the angle.
void add_kinks(Variable over, const std::vector<double>& rows,
               const ForceInstant& at,
               std::vector<multibody::KinkedVariable>& to);

/// Point at which a table is read, and the origin of its rows.
struct TablePlace {
  double x;
  double origin;
};
TablePlace place_in(Variable over, const ForceInstant& at);

}  // namespace separation
