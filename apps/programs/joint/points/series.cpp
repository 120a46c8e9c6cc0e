#include "programs/joint/points/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/stream/csv.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"

namespace hinge_joint {
namespace {

using contact::detail::nan;

// Possible names of a column of time; the first one found is used.
struct TimeColumn {
  std::string_view name;
  double seconds;
};
constexpr TimeColumn time_columns[] = {{"time_s", 1},     {"t_s", 1},
                                       {"time", 1},       {"t", 1},
                                       {"time_ms", 1e-3}, {"t_ms", 1e-3}};

}  // namespace

std::vector<AnswerColumn> point_columns(Question question) {
  const bool rest = question == Question::rest;
  const std::array<std::string_view, point_numbers> names = {
      "R_N",
      "R_n_N",
      "M_t_N_m",
      "f_M",
      "p_peak_Pa",
      "theta0_deg",
      rest ? "utilisation" : "power_W"};
  const std::vector<AnswerColumn> all = answer_columns({.rest = rest});
  std::vector<AnswerColumn> found;
  for (const std::string_view name : names) {
    found.push_back(*std::ranges::find(all, name, &AnswerColumn::name));
  }
  return found;
}

PointSeries::PointSeries(Question question, const cli::PointColumns& columns)
    : question_(question),
      form_(columns.form),
      columns_(point_columns(question)) {
  const std::vector<std::string>& riding = columns.riding;
  for (const TimeColumn& column : time_columns) {
    const auto found = std::ranges::find_if(
        riding, [&](const auto& it) { return cli::is_named(it, column.name); });
    if (found == riding.end()) continue;
    has_time_ = true;
    time_at_ = static_cast<std::size_t>(found - riding.begin());
    time_name_ = column.name;
    seconds_ = column.seconds;
    return;
  }
}

PointRow PointSeries::row(const Answer& a, const cli::PointLines& block,
                          std::size_t point) const {
  PointRow row = {point + 1, nan, {}};
  if (!time_name_.empty()) {
    const std::size_t riding = block.riding.size() / block.size();
    const auto time = cli::parse_number(
        cli::field_value(block.riding[point * riding + time_at_], form_));
    row.time = seconds_ * time.value_or(nan);
  }
  std::ranges::transform(columns_, row.values.begin(),
                         [&](const AnswerColumn& column) { return column(a); });
  return row;
}

void PointSeries::append(std::span<const PointRow> rows, std::size_t states) {
  for (const PointRow& row : rows) {
    rows_.push_back(row);
    rows_.back().state += states_;
    if (has_time_) check_time(rows_.back());
  }
  states_ += states;
}

// Call for the last row.
void PointSeries::check_time(const PointRow& row) {
  const bool first = rows_.size() == 1;
  if (std::isfinite(row.time) &&
      (first || row.time >= rows_[rows_.size() - 2].time)) {
    return;
  }
  has_time_ = false;
  time_problem_ = contact::detail::must_be(
      fmt::format("{} of state {}", time_name_, row.state),
      first ? "a number" : "a number that is not below the one before it");
}

double PointSeries::duration() const {
  return has_time_ && !rows_.empty() ? rows_.back().time - rows_.front().time
                                     : 0;
}

double PointSeries::mean(std::size_t number) const {
  double sum = 0;
  if (duration() > 0) {
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const PointRow& a = rows_[i - 1];
      const PointRow& b = rows_[i];
      sum += (a.values[number] + b.values[number]) / 2 * (b.time - a.time);
    }
    return sum / duration();
  }
  for (const PointRow& row : rows_) sum += row.values[number];
  return sum / static_cast<double>(rows_.size());  // NaN without rows
}

}  // namespace hinge_joint
