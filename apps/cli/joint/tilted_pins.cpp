#include "cli/joint/tilted_pins.hpp"

#include <fmt/format.h>

#include <limits>
#include <variant>

#include "cli/joint/joint_reports.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/tables.hpp"

namespace cli {

using contact::Dimension;
using contact::JointSolution;
using contact::PinLie;
using Eigen::Vector3d;

void add_tilt_options(Program& program, TiltOptions& o, std::string_view needs,
                      std::string_view excludes) {
  program.add_check([&program] {
    if (program.has("--tilt") && program.has("--load-at")) {
      refuse_beside("--tilt", "--load-at");
    }
  });
  program.add(
      "Tilt",
      {{"--tilt", &o.tilt, "ANGLES",
        "tilt of a pin that ends in the plane of the load, deg, -10 to 10",
        needs, excludes},
       {"--twist", number("--twist", o.twist, Dimension::angle, allowed_tilt),
        "ANGLE", "tilt across that plane, deg; default 0", "--tilt"},
       {"--load-at", &o.load_at, "VALUES",
        "place of the load along a pin, m from its middle", needs, excludes}});
}

namespace {

const Joint& checked(const Joint& joint, const char* flag) {
  if (!joint.has_size) refuse_without(flag, "--radius and --clearance");
  if (joint.is_pin() && !joint.has_length) refuse_without(flag, "--length");
  const std::string why = contact::FinitePin::refusal(joint.spec);
  if (!why.empty()) throw contact::Error(said_of(joint, why));
  return joint;
}

Sweep sweep_of(const TiltOptions& options, const Joint& joint) {
  const double half = joint.spec.geometry.length() / 2;
  if (!options.is_placed()) {
    return {"--tilt", options.tilt, allowed_tilt, Dimension::angle};
  }
  return {"--load-at", options.load_at, {-half, half, "m"}, Dimension::length};
}

}  // namespace

Placements::Placements(const TiltOptions& options, const Joint& joint)
    : is_placed_(options.is_placed()),
      twist_(options.twist.value_or(0) * contact::degree),
      sweep_(sweep_of(options, checked(joint, options.flag()))) {}

contact::Placement Placements::operator[](std::size_t index) const {
  contact::Placement placement;
  if (is_placed_) {
    placement.place = sweep_[index];
  } else {
    placement.tilt = Vector3d(contact::degree * sweep_[index], twist_, 0);
  }
  return placement;
}

namespace {

using Column =
    std::variant<contact::Column<JointSolution>, contact::Column<PinLie>>;

std::vector<Column> columns_of(const TiltedTable& table) {
  std::vector<Column> columns;
  if (table.write) return columns;
  const auto add = [&](const auto& all) {
    columns.insert(columns.end(), all.begin(), all.end());
  };
  for (const std::string_view key : table.columns) {
    if (const auto* lie = find_quantity(contact::lie_quantities(), key)) {
      add(contact::columns_of(*lie));
    } else {
      add(contact::columns_of(
          *find_quantity(contact::solution_quantities(), key)));
    }
  }
  return columns;
}

// The rows of a joint.
class Rows {
 public:
  Rows(const Joint& joint, const TiltOptions& options, const TiltedTable& table)
      : joint_(joint),
        table_(table),
        placements_(options, joint),
        loads_("--load", table.loads, {0, 1e100, "N"}, Dimension::force),
        pin_([&] {
          contact::JointSpec smooth = joint.spec;
          smooth.friction = contact::FrictionLaw(0);
          return contact::Joint(smooth);
        }()) {}

  /// @return rows without a value, and that have not converged
  std::array<std::size_t, 2> write(const std::vector<Column>& columns,
                                   RowWriter& row) const {
    std::array<std::size_t, 2> bad = {};
    contact::ContactNotes notes;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t k = 0; k < placements_.size(); ++k) {
        const contact::Placement placement = placements_[k];
        const double side = pin_.contact().geometry().side();
        const JointSolution s = pin_.solve_contact(
            {side * loads_[i] * Vector3d::UnitX(), Vector3d::Zero(),
             Vector3d::UnitZ(), &placement});
        if (s.status != contact::Status::ok) {
          ++bad[s.status == contact::Status::not_converged];
        }
        notes.add(pin_, s);
        const auto begin = [&] {
          write_differences(joint_.differences, row);
          row.number(loads_[i]);
          if (!std::isnan(placement.place)) row.number(placement.place);
        };
        if (table_.write) {
          table_.write(pin_, s, begin, row);
          continue;
        }
        begin();
        write_row(columns, s, row);
      }
    }
    for (const std::string& note :
         pin_.contact().limits().notes(notes.largest())) {
      warn(table_.program, said_of(joint_, note));
    }
    return bad;
  }

 private:
  void write_row(const std::vector<Column>& columns, const JointSolution& s,
                 RowWriter& row) const {
    const auto lie = pin_.lie(s);
    for (const Column& column : columns) {
      const auto* of_lie = std::get_if<1>(&column);
      const double value = !of_lie ? std::get<0>(column)(s)
                           : lie   ? (*of_lie)(*lie)
                                   : std::numeric_limits<double>::quiet_NaN();
      row.number(value + 0.0);  // no -0
    }
    row.end();
  }

  const Joint& joint_;
  const TiltedTable& table_;
  Placements placements_;
  Sweep loads_;
  contact::Joint pin_;
};

}  // namespace

ExitStatus write_tilted(const std::vector<Joint>& joints,
                        const TiltOptions& options, const TiltedTable& table,
                        const OutputOptions& output) {
  const std::vector<Column> columns = columns_of(table);
  std::vector<std::string> names = {"load_N"};
  if (options.is_placed()) names.emplace_back("load_at_m");
  if (table.write) {
    names.insert(names.end(), table.columns.begin(), table.columns.end());
  }
  for (const Column& column : columns) {
    names.push_back(std::visit([](const auto& c) { return c.name; }, column));
  }
  std::vector<Rows> rows;
  for (const Joint& joint : joints) rows.emplace_back(joint, options, table);
  std::vector<Joint> straight = joints;  // the relief is not left out
  for (Joint& joint : straight) joint.spec = joint.spec.without_relief();
  warn_of_validity(table.program, straight);
  std::array<std::size_t, 2> bad = {};
  write_table(output, joint_columns(joints, {names}), [&](RowWriter& row) {
    for (const Rows& of : rows) {
      const auto [none, rough] = of.write(columns, row);
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
