#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/joint/tilted_pins.hpp"
#include "libcontact/joint/joint.hpp"

/// Tables of joints with contacts that end, under normal forces and without
/// friction: pins with a position, balls in their seats.
namespace cli {

/// A joint of such a table under one load. Pins are loaded along x, seats in
/// the plane of x and z, the seat's axis.
struct PlacedState {
  const contact::Joint& joint;
  double load;  ///< N
  const contact::JointSolution& solution;
  std::optional<contact::PinLie> lie = {};
  std::optional<contact::RimContact> rims = {};
};

struct PlacedColumn {
  std::string name;
  std::function<double(const PlacedState&)> value;
};
/// Add the columns of a quantity of the solution, of the pin's position, or of
/// everything about the seat.
void add_solution_column(std::string_view key, std::vector<PlacedColumn>& to);
void add_lie_column(std::string_view key, std::vector<PlacedColumn>& to);
void add_seat_columns(std::vector<PlacedColumn>& to);

struct PlacedTable {
  std::string_view program;
  std::string loads;  ///< sweep of --load
  TiltOptions tilt = {};
  std::string direction = {};  ///< sweep of --direction, replaces the tilt
  std::vector<PlacedColumn> columns = {};
  /// Maps: names of their columns, and the function that writes their rows;
  /// `begin` writes the cells of the load at the start of each row.
  std::vector<std::string> map_columns = {};
  std::function<void(const PlacedState&, const std::function<void()>& begin,
                     RowWriter&)>
      write_map = {};
  /// Called with every state and its label, for pictures: "2000 N, 45 deg".
  std::function<void(const PlacedState&, const std::string& label)> show = {};
};

/// Writes a row for each load and placement. Warns where the theory does not
/// hold; returns some_bad if rows have no value.
ExitStatus write_placed(const std::vector<Joint>& joints,
                        const PlacedTable& table, const OutputOptions& output);

}  // namespace cli
