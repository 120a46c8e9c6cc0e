#include "cli/joint/placed_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "cli/joint/joint_reports.hpp"
#include "cli/plot.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"

namespace cli {
namespace {

using contact::Dimension;
using contact::JointSolution;
using Eigen::Vector3d;

// Adds the columns of a quantity of `get`(state), a pointer; NaN if null.
template <class T, class Get>
void add_columns(const contact::Quantity<T>& quantity, const Get& get,
                 std::vector<PlacedColumn>& to) {
  for (const auto& column : contact::columns_of(quantity)) {
    to.push_back({column.name, [column, get](const PlacedState& s) {
                    const T* of = get(s);
                    return of ? column(*of)
                              : std::numeric_limits<double>::quiet_NaN();
                  }});
  }
}

// The joint of a row. For seats the axis is z and the laws are exact.
contact::Joint without_friction(const Joint& joint, bool in_seat) {
  contact::JointSpec spec = joint.spec;
  spec.friction = contact::FrictionLaw(0);
  if (in_seat) {
    const auto& zone = spec.geometry.seat();
    if (!zone) refuse_without("--direction", "a joint with a [seat]");
    spec.geometry = spec.geometry.with_seat(zone->about({0, 0, 1}));
    spec.half_angle_law = spec.pressure_law = "exact";
    spec.half_angle_options = {};
  }
  return contact::Joint(spec);
}

// How the rows of a joint are placed.
class Places {
 public:
  Places(const Joint& joint, const PlacedTable& table) {
    if (table.direction.empty()) {
      pins_.emplace(table.tilt, joint);
      has_cell_ = table.tilt.is_placed();
    } else {
      directions_.emplace("--direction", table.direction,
                          Allowed{0, 180, "deg"}, Dimension::angle);
      has_cell_ = true;
    }
  }

  struct Place {
    Vector3d load;  ///< unit vector
    double cell;
    std::optional<contact::Placement> placement = {};
  };
  std::size_t size() const {
    return pins_ ? pins_->size() : directions_->size();
  }
  Place operator[](std::size_t k) const {
    if (pins_) {
      const contact::Placement placement = (*pins_)[k];
      return {Vector3d::UnitX(), placement.place, placement};
    }
    const double at = (*directions_)[k];
    const double direction = at * contact::degree;
    return {{std::sin(direction), 0, std::cos(direction)}, at};
  }
  bool has_cell() const { return has_cell_; }
  std::string label(const Place& place) const {
    if (!place.placement) return fmt::format("{:.6g} deg", place.cell);
    if (has_cell_) return fmt::format("at {:.6g} mm", place.cell * 1e3);
    return fmt::format("tilt {:.6g} deg",
                       place.placement->tilt.x() / contact::degree);
  }

 private:
  std::optional<Placements> pins_;
  std::optional<Sweep> directions_;
  bool has_cell_;
};

// The rows of a joint.
class Rows {
 public:
  Rows(const Joint& joint, const PlacedTable& table)
      : given_(joint),
        table_(table),
        places_(joint, table),
        loads_("--load", table.loads, {0, 1e100, "N"}, Dimension::force),
        joint_(without_friction(joint, !table.direction.empty())) {}

  std::size_t size() const { return loads_.size() * places_.size(); }
  /// @return rows without a value, and that have not converged
  std::array<std::size_t, 2> write(RowWriter& row) const {
    std::array<std::size_t, 2> bad = {};
    contact::ContactNotes notes;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t k = 0; k < places_.size(); ++k) {
        const Places::Place place = places_[k];
        const double side = joint_.contact().geometry().side();
        const JointSolution s = joint_.solve_contact(
            {side * loads_[i] * place.load, Vector3d::Zero(), Vector3d::UnitZ(),
             place.placement ? &*place.placement : nullptr});
        if (s.status != contact::Status::ok) {
          ++bad[s.status == contact::Status::not_converged];
        }
        notes.add(joint_, s);
        const PlacedState state = {joint_, loads_[i], s, joint_.lie(s),
                                   joint_.rims(s)};
        write_state(state, place.cell, row);
        if (table_.show) table_.show(state, label(i, places_.label(place)));
      }
    }
    for (const std::string& note : notes.notes(joint_)) {
      warn(table_.program, said_of(given_, note));
    }
    return bad;
  }

 private:
  // Leaves out everything that all states share.
  std::string label(std::size_t load, const std::string& place) const {
    std::string text = difference_label(given_.differences);
    const auto add = [&text](const std::string& more) {
      text += (text.empty() ? "" : ", ") + more;
    };
    if (loads_.size() > 1) add(fmt::format("{:.6g} N", loads_[load]));
    if (places_.size() > 1 || text.empty()) add(place);
    return text;
  }
  void write_state(const PlacedState& state, double cell,
                   RowWriter& row) const {
    const auto begin = [&] {
      write_differences(given_.differences, row);
      row.number(state.load);
      if (places_.has_cell()) row.number(cell);
    };
    if (table_.write_map) {
      table_.write_map(state, begin, row);
      return;
    }
    begin();
    for (const PlacedColumn& column : table_.columns) {
      row.number(column.value(state) + 0.0);  // no -0
    }
    row.end();
  }

  const Joint& given_;
  const PlacedTable& table_;
  Places places_;
  Sweep loads_;
  contact::Joint joint_;
};

}  // namespace

void add_solution_column(std::string_view key, std::vector<PlacedColumn>& to) {
  add_columns(
      *find_quantity(contact::solution_quantities(), key),
      [](const PlacedState& s) { return &s.solution; }, to);
}

void add_lie_column(std::string_view key, std::vector<PlacedColumn>& to) {
  add_columns(
      *find_quantity(contact::lie_quantities(), key),
      [](const PlacedState& s) { return s.lie ? &*s.lie : nullptr; }, to);
}

void add_seat_columns(std::vector<PlacedColumn>& to) {
  for (const auto& quantity : contact::seat_quantities()) {
    add_columns(
        quantity,
        [](const PlacedState& s) { return s.rims ? &*s.rims : nullptr; }, to);
  }
}

ExitStatus write_placed(const std::vector<Joint>& joints,
                        const PlacedTable& table, const OutputOptions& output) {
  std::vector<std::string> names = {"load_N"};
  if (!table.direction.empty()) names.emplace_back("direction_deg");
  if (table.tilt.is_placed()) names.emplace_back("load_at_m");
  names.insert(names.end(), table.map_columns.begin(), table.map_columns.end());
  for (const PlacedColumn& column : table.columns) {
    if (!table.write_map) names.push_back(column.name);
  }
  std::vector<Rows> rows;
  for (const Joint& joint : joints) rows.emplace_back(joint, table);
  if (table.show) check_curves(rows.size() * rows[0].size());
  std::vector<Joint> straight = joints;  // the relief is not left out
  for (Joint& joint : straight) joint.spec = joint.spec.without_relief();
  warn_of_validity(table.program, straight);
  OutputOptions titled = output;
  titled.report.title = shared_title(joints, "");
  std::array<std::size_t, 2> bad = {};
  write_table(titled, joint_columns(joints, {names}), [&](RowWriter& row) {
    for (const Rows& of : rows) {
      const auto [none, rough] = of.write(row);
      bad[0] += none;
      bad[1] += rough;
    }
  });
  if (bad[0] + bad[1] == 0) return all_good;
  warn(table.program, fmt::format("rows without a value: {}, rows that have "
                                  "not converged: {}",
                                  bad[0], bad[1]));
  return some_bad;
}

}  // namespace cli
