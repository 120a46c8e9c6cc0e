#include "programs/joint/points/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/stream/report.hpp"

namespace hinge_joint {
namespace {

// The row with the number of largest magnitude; null without rows.
const PointRow* peak(const std::vector<PointRow>& rows, std::size_t number) {
  const auto found = std::ranges::max_element(
      rows, {},
      [number](const PointRow& row) { return std::abs(row.values[number]); });
  return found == rows.end() ? nullptr : &*found;
}

void add_numbers(const PointSeries& series, cli::Report& to) {
  const bool over_time = series.duration() > 0;
  for (std::size_t i = 0; i < point_numbers; ++i) {
    const AnswerColumn& column = series.columns()[i];
    const PointRow* at = peak(series.rows(), i);
    std::vector<cli::Cell> where;
    if (at != nullptr) where = {at->state};
    if (at != nullptr && series.has_time()) where.emplace_back(at->time);
    to.add("largest_" + column.name,
           at == nullptr ? std::numeric_limits<double>::quiet_NaN()
                         : at->values[i],
           column.meaning, where);
    to.add("mean_" + column.name, series.mean(i),
           over_time ? "its mean over the time" : "its mean over the states");
  }
  if (!over_time) return;
  to.add("duration_s", series.duration(), "from the first state to the last");
  if (series.question() == Question::rest) return;
  // The power is the last number.
  to.add("dissipated_energy_J",
         -series.mean(point_numbers - 1) * series.duration(),
         "by friction, over the duration: minus the work of M_t");
}

}  // namespace

void write_point_summary(const NamedJoint& joint, const PointSeries& series,
                         const cli::OutputOptions& options) {
  std::vector<cli::Report::Beside> beside = {{"at_state"}};
  if (series.has_time()) beside.push_back({"at_time_s"});
  cli::Output output(options.output);
  cli::Report report(beside);
  report.add("law", joint.law, "half-angle law");
  report.add("pressure", joint.pressure, "pressure law");
  report.add("states", series.rows().size(), "that have a solution");
  report.add("left_out", series.left_out(),
             "bad lines and states without a solution");
  add_numbers(series, report);
  report.write(output, options);
  output.commit();
}

}  // namespace hinge_joint
