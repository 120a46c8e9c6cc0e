#include "programs/duty/cycle_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/file_name.hpp"

namespace hinge_duty {
namespace {

constexpr double largest_number = 1e100;
constexpr cli::Allowed any_time{-largest_number, largest_number, "s"};
constexpr cli::Allowed any_force{-largest_number, largest_number, "N"};
constexpr cli::Allowed any_rate{-largest_number, largest_number, "rad/s"};
constexpr cli::Allowed any_place{-largest_number, largest_number, "m"};
constexpr cli::Allowed any_angle{-1e6, 1e6, "deg"};

const std::array<std::string, 3> rate_names = {"w_x_rad_per_s", "w_y_rad_per_s",
                                               "w_z_rad_per_s"};

// Columns with the position of a pin, and the members for their indices.
constexpr std::pair<std::string_view, std::size_t CycleColumns::*>
    lie_columns[] = {{"tilt_x_deg", &CycleColumns::tilt_x_at},
                     {"tilt_y_deg", &CycleColumns::tilt_y_at},
                     {"load_at_m", &CycleColumns::load_at}};

bool is_lie(std::string_view name) {
  return std::ranges::any_of(lie_columns, [&](const auto& lie) {
    return cli::is_named(name, lie.first);
  });
}

void name_lies(const cli::PointColumns& columns, const std::string& place,
               CycleColumns& to) {
  for (const auto& [name, at] : lie_columns) {
    const bool is_there = std::ranges::any_of(
        columns.riding,
        [name = name](const auto& it) { return cli::is_named(it, name); });
    if (!is_there) continue;
    to.*at = to.names.size();
    to.names.emplace_back(name);
  }
  if (to.load_at != 0 && to.tilt_x_at + to.tilt_y_at != 0) {
    cli::refuse_beside(place + ": the column load_at_m",
                       "columns of the tilt, which it finds");
  }
}

// Columns of the motion; `is_angles` receives their meaning.
std::vector<std::string> motion_names(const cli::PointColumns& columns,
                                      const cli::PointHeader& header,
                                      const Options& options, bool is_pin,
                                      bool& is_angles) {
  std::vector<std::string> angles;
  std::size_t rates = 0;
  for (const std::string& name : columns.riding) {
    if (is_pin && is_lie(name)) continue;
    if (cli::ends_in(name, "_deg")) angles.push_back(name);
    rates += std::ranges::any_of(rate_names, [&name](const auto& rate) {
      return cli::is_named(name, rate);
    });
  }
  is_angles = !options.euler.empty() || rates == 0;
  if (!is_angles) return {rate_names.begin(), rate_names.end()};
  const std::size_t wanted = is_pin ? 1 : 3;
  if (angles.size() != wanted) {
    header.fail(contact::detail::needs(
        "the motion",
        is_pin ? "one column of an angle, NAME_deg, or w_x_rad_per_s, "
                 "w_y_rad_per_s and w_z_rad_per_s"
               : "three columns of angles, NAME_deg, in the order of --euler, "
                 "or w_x_rad_per_s, w_y_rad_per_s and w_z_rad_per_s"));
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

// Takes the columns of an OpenSim table named by the options.
void name_sto_columns(const Options& options, bool is_pin,
                      CycleColumns& columns) {
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
  if (!columns.sto->in_degrees.value_or(false)) columns.angle_unit = 1;
}

void name_csv_columns(const Options& options, bool is_pin,
                      CycleColumns& columns) {
  std::vector<cli::PointColumn> states;
  for (const std::string& name : columns.names) {
    states.push_back({name, any_force});
  }
  const cli::PointColumns all(columns.header, states);
  const auto motion =
      motion_names(all, columns.header, options, is_pin, columns.is_angles);
  columns.names.insert(columns.names.end(), motion.begin(), motion.end());
  columns.motion_end = columns.names.size();
  if (is_pin) name_lies(all, columns.header.place, columns);
}

}  // namespace

CycleColumns read_columns(cli::LineReader& reader, const Options& options,
                          bool is_pin) {
  check_columns_options(options);
  CycleColumns columns;
  if (is_sto(options.cycle)) {
    columns.sto = read_sto_header(reader);
    if (!columns.sto->in_degrees) {
      cli::warn("hinge-duty",
                reader.name() +
                    ": no inDegrees in its header: angles are read as radians");
    }
    columns.header = columns.sto->columns;
    name_sto_columns(options, is_pin, columns);
  } else {
    columns.header = cli::read_header(reader, options.output);
    name_csv_columns(options, is_pin, columns);
  }
  if (columns.sto) columns.motion_end = columns.names.size();
  const auto angles =
      std::span(columns.names)
          .subspan(CycleColumns::motion_at,
                   columns.motion_end - CycleColumns::motion_at);
  if (columns.is_angles && !is_pin && options.euler.empty()) {
    cli::refuse_without(
        fmt::format("{}: motion by the angles {}", columns.header.place,
                    fmt::join(angles, ", ")),
        "--euler, the sequence of their axes, such as zxy");
  }
  for (std::size_t i = 0; i < columns.names.size(); ++i) {
    columns.needed.push_back(
        {columns.names[i], i == 0                        ? any_time
                           : i < CycleColumns::motion_at ? any_force
                           : i == columns.load_at        ? any_place
                           : i >= columns.motion_end     ? cli::allowed_tilt
                           : columns.is_angles           ? any_angle
                                                         : any_rate});
  }
  return columns;
}

}  // namespace hinge_duty
