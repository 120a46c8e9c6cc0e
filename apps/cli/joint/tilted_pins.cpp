#include "cli/joint/tilted_pins.hpp"

#include <fmt/format.h>

#include "cli/joint/joint_reports.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/finite_pin.hpp"

namespace cli {

using contact::Dimension;
using contact::FinitePin;
using contact::FinitePinSolution;
using Eigen::Vector2d;

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

FinitePinSolution PinLie::solve(
    const FinitePin& pin, const Vector2d& reaction,
    const FinitePin::Motion& motion) const noexcept {
  return place ? pin.solve_at(reaction, *place, motion)
               : pin.solve(reaction, tilt, motion);
}

FinitePinSolution PinLie::under(const FinitePin& pin,
                                const Vector2d& force) const noexcept {
  FinitePinSolution s = {};
  s.contact =
      place ? pin.under_moment(force, *place * force) : pin.under(force, tilt);
  s.friction_force.setZero();
  s.moment = {-s.contact.force_moment.y(), s.contact.force_moment.x(), 0};
  return s;
}

PinLies::PinLies(const TiltOptions& options,
                 const contact::JointGeometry& geometry)
    : is_placed_(options.is_placed()),
      twist_(options.twist.value_or(0)),
      sweep_(options.flag(), is_placed_ ? options.load_at : options.tilt,
             is_placed_
                 ? Allowed{-geometry.length() / 2, geometry.length() / 2, "m"}
                 : allowed_tilt,
             is_placed_ ? Dimension::length : Dimension::angle) {}

PinLie PinLies::operator[](std::size_t index) const {
  if (is_placed_) return {.place = sweep_[index]};
  return {.tilt = contact::degree * Vector2d(sweep_[index], twist_)};
}

FinitePin make_finite_pin(const Joint& joint, const char* flag) {
  if (!joint.has_size) refuse_without(flag, "--radius and --clearance");
  if (joint.is_pin() && !joint.has_length) refuse_without(flag, "--length");
  return made_of(joint, [&] { return FinitePin(joint.spec); });
}

namespace {

struct Problems {
  std::size_t out_of_range = 0;
  std::size_t not_converged = 0;

  void add(contact::Status status) {
    if (status == contact::Status::not_converged) {
      ++not_converged;
    } else if (status != contact::Status::ok) {
      ++out_of_range;
    }
  }
};

// The rows of a joint.
class Rows {
 public:
  Rows(const Joint& joint, const TiltOptions& options, const TiltedTable& table)
      : joint_(joint),
        table_(table),
        pin_(make_finite_pin(joint, options.flag())),
        loads_(table.load_flag, table.loads, {0, 1e100, "N"}, Dimension::force),
        lies_(options, joint.spec.geometry) {}

  void write(RowWriter& row, Problems& problems) const {
    contact::LargestContact largest;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t k = 0; k < lies_.size(); ++k) {
        const PinLie lie = lies_[k];
        const Vector2d load(loads_[i], 0);
        const FinitePinSolution s = table_.motion
                                        ? lie.solve(pin_, load, *table_.motion)
                                        : lie.under(pin_, load);
        problems.add(s.contact.status);
        largest.add(s.contact.largest());
        const auto begin = [&] {
          write_differences(joint_.differences, row);
          row.number(loads_[i]);
          if (lie.place) row.number(*lie.place);
        };
        if (table_.write) {
          table_.write(pin_, s, begin, row);
          continue;
        }
        begin();
        for (const PinColumn& column : table_.columns) {
          row.number(column.of(pin_, s));
        }
        row.end();
      }
    }
    const contact::ContactLimits limits(*joint_.laws[0].law, joint_.pair,
                                        joint_.spec.geometry);
    for (const std::string& note : limits.notes(largest)) {
      warn(table_.program, said_of(joint_, note));
    }
  }

 private:
  const Joint& joint_;
  const TiltedTable& table_;
  FinitePin pin_;
  Sweep loads_;
  PinLies lies_;
};

}  // namespace

ExitStatus write_tilted(const std::vector<Joint>& joints,
                        const TiltOptions& options, const TiltedTable& table,
                        const OutputOptions& output) {
  std::vector<std::string> names = {table.load_column};
  if (options.is_placed()) names.emplace_back("load_at_m");
  for (const PinColumn& column : table.columns) names.push_back(column.name);
  std::vector<Rows> rows;
  for (const Joint& joint : joints) rows.emplace_back(joint, options, table);
  // All but that the relief is left out.
  std::vector<Joint> level = joints;
  for (Joint& joint : level) joint.spec.relief = contact::Relief::none();
  warn_of_validity(table.program, level);
  Problems problems;
  write_table(output, joint_columns(joints, {names}), [&](RowWriter& row) {
    for (const Rows& of : rows) of.write(row, problems);
  });
  if (problems.out_of_range + problems.not_converged == 0) return all_good;
  warn(table.program,
       fmt::format("rows without a value: {}, rows that have "
                   "not converged: {}",
                   problems.out_of_range, problems.not_converged));
  return some_bad;
}

std::vector<PinColumn> pin_columns(const std::vector<std::string_view>& keys) {
  std::vector<PinColumn> columns;
  const auto add = [&](const auto& all) {
    for (const auto& column : all) {
      columns.push_back({column.name, [column](const FinitePin& /*pin*/,
                                               const FinitePinSolution& s) {
                           return column(s) + 0.0;  // no -0
                         }});
    }
  };
  const auto all = contact::finite_pin_quantities();
  if (keys.empty()) add(columns_of(all));
  for (const std::string_view key : keys) {
    add(columns_of(*find_quantity(all, key)));
  }
  return columns;
}

}  // namespace cli
