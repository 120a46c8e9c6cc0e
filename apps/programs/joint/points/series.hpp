#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cli/stream/points.hpp"
#include "programs/joint/solution_row.hpp"

namespace hinge_joint {

/// Number of quantities in --summary and --plot of --points.
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
/// a column of time.
class PointSeries {
 public:
  /// @param columns  columns of the states, and those passed through
  PointSeries(Question question, const cli::PointColumns& columns);

  Question question() const { return question_; }
  const std::vector<AnswerColumn>& columns() const { return columns_; }
  /// A row; its state is counted from the beginning of the block.
  PointRow row(const Answer& a, const cli::PointLines& block,
               std::size_t point) const;
  /// @param states  number of states in the block, with or without a row
  void append(std::span<const PointRow> rows, std::size_t states);

  const std::vector<PointRow>& rows() const { return rows_; }
  std::size_t left_out() const { return states_ - rows_.size(); }
  /// True if there is a column of time that never decreases.
  bool has_time() const { return has_time_; }
  /// Why a column of time is not used, else "".
  const std::string& time_problem() const { return time_problem_; }
  /// Time from the first row to the last, s; 0 without a time.
  double duration() const;
  /// Mean of a number: by the trapezoidal rule over the time, or over the rows
  /// if there is no duration.
  double mean(std::size_t number) const;

 private:
  void check_time(const PointRow& row);

  Question question_;
  cli::CsvForm form_;
  std::vector<AnswerColumn> columns_;
  std::size_t time_at_ = 0;  // among the columns passed through
  std::string_view time_name_;
  double seconds_ = 1;  // unit of that column
  bool has_time_ = false;
  std::string time_problem_;
  std::size_t states_ = 0;
  std::vector<PointRow> rows_;
};

}  // namespace hinge_joint
