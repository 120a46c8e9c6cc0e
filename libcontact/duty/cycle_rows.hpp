#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace contact {

/// The rows of a cycle as somebody measured them, before they are splines.
struct CycleRows {
  std::vector<double> times;            ///< s, ascending
  std::vector<Eigen::Vector3d> forces;  ///< N
  std::vector<Eigen::Vector3d> motion;  ///< angles or rates
  std::optional<double> period;         ///< s, if it is known
};

/// Makes one period of the rows. A last row that repeats the first (time 0 to
/// 100 %, as tables of gait have it), to 1e-9 of each column's range, is left
/// out, and its time ends the period; it stays if the period is known and
/// longer. Otherwise even steps go on by one.
///
/// @param rows  their period is set if it can be told: not for uneven steps
///              without a last row that repeats the first
/// @return a note on what was left out, or ""
std::string make_one_period(CycleRows& rows);

}  // namespace contact
