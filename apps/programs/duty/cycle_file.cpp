#include "programs/duty/cycle_file.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/duty/duty_cycle.hpp"
#include "programs/duty/cycle_columns.hpp"

namespace hinge_duty {
namespace {

using Eigen::Vector3d;

// The values of all lines, column by column.
std::vector<std::vector<double>> read_lines(cli::LineReader& reader,
                                            const cli::PointColumns& columns) {
  std::vector<std::vector<double>> values(columns.needed.size());
  cli::read_all_points(reader, columns, [&](const cli::PointLines& block) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i].insert(values[i].end(), block.values[i].begin(),
                       block.values[i].end());
    }
  });
  return values;
}

void check_times(const contact::DutyCycle::Rows& rows, bool is_angles,
                 const std::string& name, const std::string& column) {
  const std::vector<double>& times = rows.times;
  if (times.size() < 4 && (is_angles || !rows.is_steady())) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("{}: {} row{}", name, times.size(),
                    times.size() == 1 ? "" : "s"),
        "4 or more, or alike and with angular velocities: a steady turn"));
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    throw contact::Error(contact::detail::must_be(
        fmt::format("{}: {} = {}", name, column, times[i]),
        fmt::format("above {}, the time before it", times[i - 1])));
  }
}

// Reduces the rows to one period; notes omitted rows.
void set_period(contact::DutyCycle::Rows& rows, const std::string& name,
                const Options& options) {
  if (!options.period.empty()) {
    rows.period = cli::parse_quantity(
        "--period", options.period, contact::Dimension::time, {0, 1e100, "s"});
  }
  const std::string note = rows.make_one_period();
  if (!note.empty()) cli::warn("hinge-duty", name + ": " + note);
  if (!rows.period) {
    cli::refuse_without(
        name + (rows.times.size() == 1 ? ": a cycle of one row"
                                       : ": a cycle with uneven time steps"),
        "--period, the time from the first row to its return");
  }
  const double span = rows.times.back() - rows.times.front();
  if (*rows.period > span) return;
  cli::refuse("--period", options.period,
              fmt::format("above {:.6g} s, from the first to the last row "
                          "of {}",
                          span, name));
}

// Vectors of three columns, or fewer.
std::vector<Vector3d> vectors(const std::vector<std::vector<double>>& values,
                              std::size_t first, std::size_t end, double unit) {
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    Vector3d vector = Vector3d::Zero();
    for (std::size_t k = 0; first + k < end; ++k) {
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

// The columns of a pin's position, with one row for each row of the period.
void add_lies(const CycleColumns& columns,
              const std::vector<std::vector<double>>& values, CycleFile& to) {
  if (columns.motion_end == columns.names.size()) return;
  to.lie_column = columns.names[columns.motion_end];
  const auto column = [&](std::size_t at, std::size_t row) {
    return at == 0 ? 0 : values[at][row % values[at].size()];
  };
  for (std::size_t i = 0; i < to.cycle.times().size(); ++i) {
    if (columns.load_at != 0) {
      to.places.push_back(column(columns.load_at, i));
    } else {
      to.tilts.emplace_back(contact::degree * column(columns.tilt_x_at, i),
                            contact::degree * column(columns.tilt_y_at, i));
    }
  }
}

}  // namespace

CycleFile read_cycle(const Options& options, bool is_pin) {
  if (is_pin && !options.euler.empty()) {
    cli::refuse_beside(cli::given("--euler", options.euler),
                       "a pin, which turns about Z");
  }
  const contact::DutyCycle::TurnSequence sequence(
      options.euler.empty() ? std::string("z") : options.euler);
  const contact::DutyCycle::ForceFrame frame{options.force_on,
                                             options.force_in};
  cli::LineReader reader(options.cycle);
  const CycleColumns columns = read_columns(reader, options, is_pin);
  const bool is_angles = columns.is_angles;
  const auto values = read_lines(reader, {columns.header, columns.needed});
  contact::DutyCycle::Rows rows{
      values[0],
      vectors(values, 1, CycleColumns::motion_at, 1),
      vectors(values, CycleColumns::motion_at, columns.motion_end,
              is_angles ? columns.angle_unit : 1),
      {}};
  if (columns.sto) {
    check_sto_rows(*columns.sto, rows.times.size(), reader.name());
  }
  check_times(rows, is_angles, reader.name(), columns.names[0]);
  set_period(rows, reader.name(), options);
  if (is_pin && !is_angles) check_pin_rates(rows.motion, reader.name());
  CycleFile file{is_angles ? contact::DutyCycle(rows, frame, sequence)
                           : contact::DutyCycle(rows, frame)};
  add_lies(columns, values, file);
  return file;
}

}  // namespace hinge_duty
