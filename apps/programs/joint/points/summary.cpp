#include "programs/joint/points/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/output.hpp"

namespace hinge_joint {
namespace {

// The row with the largest number, its sign left out; null without rows.
const PointRow* peak(const std::vector<PointRow>& rows, std::size_t number) {
  const auto found = std::ranges::max_element(
      rows, {},
      [number](const PointRow& row) { return std::abs(row.values[number]); });
  return found == rows.end() ? nullptr : &*found;
}

// Writes the table line by line.
class Lines {
 public:
  Lines(const cli::Table& table, bool time)
      : row_(table, text_), has_time_(time) {}

  void text(std::string_view name, std::string_view value,
            std::string_view meaning) {
    row_.text(name);
    row_.text(value);
    end(nullptr, meaning);
  }
  void count(std::string_view name, std::size_t value,
             std::string_view meaning) {
    row_.text(name);
    row_.count(value);
    end(nullptr, meaning);
  }
  // `at`: where the value is from; null if it is from all rows.
  void number(std::string_view name, double value, const PointRow* at,
              std::string_view meaning) {
    row_.text(name);
    row_.number(value + 0.0);  // no -0
    end(at, meaning);
  }
  std::string_view view() const { return text_.view(); }

 private:
  void end(const PointRow* at, std::string_view meaning) {
    if (at == nullptr) {
      row_.empty();
    } else {
      row_.count(at->state);
    }
    if (has_time_ && at == nullptr) row_.empty();
    if (has_time_ && at != nullptr) row_.number(at->time);
    row_.text(meaning);
    row_.end();
  }

  cli::Text text_;
  cli::RowWriter row_;
  bool has_time_;
};

void write_numbers(Lines& to, const PointSeries& series) {
  const bool over_time = series.duration() > 0;
  for (std::size_t i = 0; i < point_numbers; ++i) {
    const Quantity& quantity = series.quantities()[i];
    const PointRow* at = peak(series.rows(), i);
    to.number(fmt::format("largest_{}", quantity.name),
              at == nullptr ? std::numeric_limits<double>::quiet_NaN()
                            : at->values[i],
              at, quantity.meaning);
    to.number(
        fmt::format("mean_{}", quantity.name), series.mean(i), nullptr,
        over_time ? "its mean over the time" : "its mean over the states");
  }
  if (!over_time) return;
  to.number("duration_s", series.duration(), nullptr,
            "from the first state to the last");
  if (series.question() == Question::rest) return;
  // The power is the last number.
  to.number("dissipated_energy_J",
            -series.mean(point_numbers - 1) * series.duration(), nullptr,
            "by friction, over the duration: minus the work of M_t");
}

}  // namespace

void write_point_summary(const NamedJoint& joint, const PointSeries& series,
                         const cli::OutputOptions& options) {
  std::vector<std::string> columns = {"quantity", "value", "at_state"};
  if (series.has_time()) columns.emplace_back("at_time_s");
  columns.emplace_back("meaning");
  cli::Output output(options.output);
  const cli::Table table(options, columns);
  Lines lines(table, series.has_time());
  lines.text("law", joint.law, "half-angle law");
  lines.text("pressure", joint.pressure, "pressure law");
  lines.count("states", series.rows().size(), "that have a solution");
  lines.count("left_out", series.left_out(),
              "bad lines and states without a solution");
  write_numbers(lines, series);
  cli::TableWriter writer(output, table);
  writer.write(lines.view());
  writer.finish();
  output.commit();
}

}  // namespace hinge_joint
