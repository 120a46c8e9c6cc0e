#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cli/stream/points.hpp"
#include "programs/joint/solution_row.hpp"

namespace hinge_joint {

/// Number of quantities that --summary and --plot of --points show of a state.
inline constexpr std::size_t point_numbers = 7;

/// R_N, R_n_N, M_t_N_m, f_M, p_peak_Pa, theta0_deg, and power_W or, at rest,
/// utilisation.
std::vector<AnswerColumn> point_columns(Question question);

/// A state that has a solution.
struct PointRow {
  std::size_t state;  ///< its number in the file, from 1
  double time;        ///< s
  std::array<double, point_numbers> values;
};

/// The states of a file of points in their order: a duty cycle, if the file has
/// a column of the time.
class PointSeries {
 public:
  /// @param columns  of the states, and those beside them
  PointSeries(Question question, const cli::PointColumns& columns);

  Question question() const { return question_; }
  const std::vector<AnswerColumn>& columns() const { return columns_; }
  /// A row, its state counted from the beginning of the block.
  PointRow row(const Answer& a, const cli::PointLines& block,
               std::size_t point) const;
  /// @param states  of the block, with those that have no row
  void append(std::span<const PointRow> rows, std::size_t states);

  const std::vector<PointRow>& rows() const { return rows_; }
  std::size_t left_out() const { return states_ - rows_.size(); }
  /// Whether there is a time that never falls.
  bool has_time() const { return has_time_; }
  /// Why a column of the time is not used; "".
  const std::string& time_problem() const { return time_problem_; }
  /// From the first row to the last, s; 0 without a time.
  double duration() const;
  /// Mean of a number, by the trapezoidal rule over the time; without a
  /// duration over the rows.
  double mean(std::size_t number) const;

 private:
  void check_time(const PointRow& row);

  Question question_;
  cli::CsvForm form_;
  std::vector<AnswerColumn> columns_;
  std::size_t time_at_ = 0;  // among the riding columns
  std::string_view time_name_;
  double seconds_ = 1;  // in a unit of that column
  bool has_time_ = false;
  std::string time_problem_;
  std::size_t states_ = 0;
  std::vector<PointRow> rows_;
};

}  // namespace hinge_joint
