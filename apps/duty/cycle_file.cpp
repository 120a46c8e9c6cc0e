#include "duty/cycle_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cli/choice.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/points.hpp"
#include "duty/sto_header.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_duty {
namespace {

using contact::JointBody;
using contact::PeriodicSpline;
using Eigen::Vector3d;

constexpr double largest = 1e100;
constexpr cli::Allowed any_time{-largest, largest, "s"};
constexpr cli::Allowed any_force{-largest, largest, "N"};
constexpr cli::Allowed any_rate{-largest, largest, "rad/s"};
constexpr cli::Allowed any_angle{-1e6, 1e6, "deg"};

const std::array<std::string, 3> rate_names = {"w_x_rad_per_s", "w_y_rad_per_s",
                                               "w_z_rad_per_s"};
constexpr std::size_t motion_at = 4;  // behind time and force

// What the columns of a file are called, and where they are.
struct Columns {
  std::vector<std::string> names = {"time_s", "R_x_N", "R_y_N", "R_z_N"};
  std::vector<cli::PointColumn> needed;
  cli::PointHeader header;
  bool is_angles = false;
  double angle_unit = contact::degree;
  std::optional<StoHeader> sto;
};

JointBody body_of(const char* option, const std::string& text,
                  JointBody otherwise) {
  constexpr std::array<cli::Choice<JointBody>, 2> bodies = {
      {{"body", JointBody::body}, {"carrier", JointBody::carrier}}};
  return text.empty() ? otherwise : cli::choice(option, text, bodies);
}

// The columns of the motion; what they are is in `is_angles`.
std::vector<std::string> motion_names(const cli::PointColumns& columns,
                                      const std::string& place,
                                      const Options& options, bool is_pin,
                                      bool& is_angles) {
  std::vector<std::string> angles;
  std::size_t rates = 0;
  for (const std::string& name : columns.riding) {
    if (name.ends_with("_deg")) angles.push_back(name);
    rates += std::ranges::count(rate_names, name);
  }
  is_angles = !options.euler.empty() || rates == 0;
  if (!is_angles) return {rate_names.begin(), rate_names.end()};
  const std::size_t wanted = is_pin ? 1 : 3;
  if (angles.size() != wanted) {
    cli::refuse_without(
        place + ": the motion",
        is_pin ? "one column of an angle, NAME_deg, or w_x_rad_per_s, "
                 "w_y_rad_per_s and w_z_rad_per_s"
               : "three columns of angles, NAME_deg, in the order of --euler, "
                 "or w_x_rad_per_s, w_y_rad_per_s and w_z_rad_per_s");
  }
  return angles;
}

std::vector<std::string> column_names(const char* option,
                                      const std::string& text,
                                      std::size_t count) {
  std::vector<std::string> names;
  for (const std::string_view name : cli::split(text, ",")) {
    names.emplace_back(name);
  }
  if (names.size() == count) return names;
  cli::refuse(option, text,
              count == 1 ? "the name of one column"
                         : "the names of three columns, with commas");
}

bool is_sto(const std::string& file) {
  return file.ends_with(".sto") || file.ends_with(".mot");
}

void check_columns_options(const Options& options) {
  for (const auto& [option, text] :
       {std::pair("--force-columns", &options.force_columns),
        {"--angle-columns", &options.angle_columns}}) {
    if (is_sto(options.cycle) && text->empty()) {
      cli::refuse_without(cli::given("--cycle", options.cycle),
                          fmt::format("{} NAMES", option));
    }
    if (!is_sto(options.cycle) && !text->empty()) {
      cli::refuse_without(cli::given(option, *text),
                          "--cycle FILE.sto or FILE.mot");
    }
  }
}

// The columns of OpenSim's table that the options name.
void name_sto_columns(const Options& options, bool is_pin, Columns& columns) {
  columns.names = column_names("--force-columns", options.force_columns, 3);
  columns.names.insert(columns.names.begin(), "time");
  const auto angles =
      column_names("--angle-columns", options.angle_columns, is_pin ? 1 : 3);
  columns.names.insert(columns.names.end(), angles.begin(), angles.end());
  for (const std::string& name : columns.names) {
    if (std::ranges::count(columns.names, name) == 1) continue;
    throw contact::Error("--force-columns and --angle-columns: " +
                         contact::detail::duplicate("column", name));
  }
  columns.is_angles = true;
  if (!columns.sto->in_degrees) columns.angle_unit = 1;
}

void name_csv_columns(const Options& options, bool is_pin, Columns& columns) {
  const auto& [line, place] = columns.header;
  std::vector<cli::PointColumn> states;
  for (const std::string& name : columns.names) {
    states.push_back({name, any_force});
  }
  const auto motion = motion_names({line, states, place}, place, options,
                                   is_pin, columns.is_angles);
  columns.names.insert(columns.names.end(), motion.begin(), motion.end());
}

Columns read_columns(cli::LineReader& reader, const Options& options,
                     bool is_pin) {
  Columns columns;
  if (is_sto(options.cycle)) {
    columns.sto = read_sto_header(reader);
    columns.header = columns.sto->columns;
    name_sto_columns(options, is_pin, columns);
  } else {
    columns.header = cli::read_header(reader);
    name_csv_columns(options, is_pin, columns);
  }
  const auto angles = std::span(columns.names).subspan(motion_at);
  if (columns.is_angles && !is_pin && options.euler.empty()) {
    cli::refuse_without(fmt::format("{}: the angles {}", columns.header.place,
                                    fmt::join(angles, ", ")),
                        "--euler: the sequence of their axes, such as zxy");
  }
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    columns.needed.push_back({columns.names[i], i == 0          ? any_time
                                                : i < motion_at ? any_force
                                                : columns.is_angles
                                                    ? any_angle
                                                    : any_rate});
  }
  return columns;
}

// The values of all lines, column by column.
std::vector<std::vector<double>> read_lines(cli::LineReader& reader,
                                            const cli::PointColumns& columns,
                                            bool is_sto) {
  std::vector<std::vector<double>> values(columns.needed.size());
  cli::PointLines block;
  while (reader.next(block.lines)) {
    if (is_sto) std::ranges::replace(block.lines.text, '\t', ',');
    cli::read_points(columns, block);
    if (block.bad_lines > 0) {
      std::string_view message = block.messages;
      message = message.substr(0, message.find('\n'));
      message.remove_prefix(std::string_view("ERROR: ").size());
      throw contact::Error(fmt::format("{}, {}", reader.name(), message));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i].insert(values[i].end(), block.values[i].begin(),
                       block.values[i].end());
    }
  }
  return values;
}

void check_times(const std::vector<double>& times, const std::string& name,
                 const std::string& column) {
  if (times.size() < 4) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("{}: {} rows", name, times.size()), "4 or more"));
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    throw contact::Error(contact::detail::must_be(
        fmt::format("{}: {} = {}", name, column, times[i]),
        fmt::format("above {}, the time before it", times[i - 1])));
  }
}

double period_of(const std::vector<double>& times, const std::string& name,
                 const Options& options) {
  const double span = times.back() - times.front();
  if (!options.period.empty()) {
    const double period =
        cli::parse_quantity("--period", options.period,
                            contact::Dimension::time, {0, largest, "s"});
    if (period > span) return period;
    cli::refuse("--period", options.period,
                fmt::format("above {:.6g} s, from the first to the last row "
                            "of {}",
                            span, name));
  }
  const double step = span / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    // Of times that were rounded to some digits.
    if (std::abs(times[i] - times[i - 1] - step) <= 1e-3 * step) continue;
    cli::refuse_without(name + ": times with uneven steps",
                        "--period: the time from the first row to its return");
  }
  return span + step;
}

std::vector<Vector3d> vectors(const std::vector<std::vector<double>>& values,
                              std::size_t first, double unit) {
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    Vector3d vector = Vector3d::Zero();
    for (std::size_t k = 0; k < 3 && first + k < values.size(); ++k) {
      vector[static_cast<int>(k)] = unit * values[first + k][i];
    }
    all.push_back(vector);
  }
  return all;
}

void check_pin_rates(const std::vector<Vector3d>& rates,
                     const std::string& name) {
  for (const Vector3d& rate : rates) {
    if (rate.x() == 0 && rate.y() == 0) continue;
    throw contact::Error(contact::detail::must_be(
        name + ": w_x_rad_per_s and w_y_rad_per_s of a pin",
        "0: its axis is Z"));
  }
}

}  // namespace

contact::DutyCycle read_cycle(const Options& options, bool is_pin) {
  if (is_pin && !options.euler.empty()) {
    cli::refuse_beside(cli::given("--euler", options.euler),
                       "a pin, which turns about Z");
  }
  const contact::TurnSequence sequence(options.euler.empty() ? std::string("z")
                                                             : options.euler);
  const contact::ForceFrame frame{
      body_of("--force-on", options.force_on, JointBody::body),
      body_of("--force-in", options.force_in, JointBody::carrier)};
  check_columns_options(options);
  cli::LineReader reader(options.cycle);
  const Columns columns = read_columns(reader, options, is_pin);
  const bool is_angles = columns.is_angles;
  const auto& [line, place] = columns.header;
  const auto values = read_lines(reader, {line, columns.needed, place},
                                 columns.sto.has_value());
  const std::vector<double>& times = values[0];
  if (columns.sto) check_sto_rows(*columns.sto, times.size(), reader.name());
  check_times(times, reader.name(), columns.names[0]);
  const double period = period_of(times, reader.name(), options);
  PeriodicSpline forces(times, period, vectors(values, 1, 1));
  const std::vector<Vector3d> motion =
      vectors(values, motion_at, is_angles ? columns.angle_unit : 1);
  if (is_pin && !is_angles) check_pin_rates(motion, reader.name());
  PeriodicSpline spline(times, period, motion);
  if (!is_angles) return {std::move(forces), frame, std::move(spline)};
  return {std::move(forces), frame, std::move(spline), sequence};
}

}  // namespace hinge_duty
