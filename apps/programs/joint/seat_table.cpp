#include "programs/joint/seat_table.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "programs/joint/input.hpp"

namespace hinge_joint {
namespace {

using contact::RestSolution;
using contact::SeatJointSolution;
using contact::SeatState;

// The columns, in their order.
struct Columns {
  explicit Columns(bool with_rest) {
    if (!with_rest) return;
    for (const std::string_view key : {"utilisation", "direction"}) {
      std::ranges::move(
          columns_of(*find_quantity(contact::rest_quantities(), key)),
          std::back_inserter(rest));
    }
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all = {"status"};
    const auto take = [&](const auto& columns) {
      for (const auto& column : columns) all.push_back(column.name);
    };
    take(joint);
    take(state);
    take(rest);
    return all;
  }

  std::vector<contact::Column<SeatJointSolution>> joint =
      columns_of(contact::seat_joint_quantities());
  std::vector<contact::Column<SeatState>> state =
      columns_of(contact::seat_quantities());
  std::vector<contact::Column<RestSolution>> rest;
};

// The rows of a joint; what is to be said of them.
class Rows {
 public:
  Rows(const Options& options, const cli::Joint& joint)
      : given_(joint), joint_(with_friction(options, joint)) {}

  cli::ExitStatus write(const Inputs& inputs, const Columns& columns,
                        cli::RowWriter& row) const {
    contact::LargestContact largest;
    std::set<std::string> notes;
    SeatJointSolution s;
    cli::ExitStatus status = cli::all_good;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      RestSolution rest;
      s = solved(inputs, i, s, rest);
      cli::write_differences(given_.differences, row);
      row.text(to_string(s.contact.status));
      for (const auto& column : columns.joint) row.number(column(s) + 0.0);
      for (const auto& column : columns.state) {
        row.number(column(s.contact) + 0.0);
      }
      for (const auto& column : columns.rest) row.number(column(rest) + 0.0);
      row.end();
      largest.add(0, s.contact.peak_pressure);
      for (const auto& note : joint_.notes(s)) notes.insert(note);
      if (s.contact.status != contact::SeatStatus::ok) status = cli::some_bad;
    }
    const contact::ContactLimits limits(*given_.laws[0].law, given_.pair);
    for (const auto& note : limits.notes(largest)) notes.insert(note);
    for (const auto& note : notes) cli::warn("hinge-joint", note);
    return status;
  }

 private:
  static contact::JointSpec with_friction(const Options& options,
                                          const cli::Joint& joint) {
    if (!joint.spec.geometry.seat()) {
      cli::refuse_without("--in-seat", "a joint with a [seat]");
    }
    contact::JointSpec spec = joint.spec;
    spec.friction =
        cli::make_friction(options.friction, spec.friction, options.joint);
    return spec;
  }

  SeatJointSolution solved(const Inputs& inputs, std::size_t i,
                           const SeatJointSolution& last,
                           RestSolution& rest) const {
    const Input input = inputs[i];
    if (inputs.question() == Question::reaction) {
      return joint_.solve(
          {.reaction = input.force, .angular_velocity = input.turn}, last);
    }
    const contact::SeatRestSolution held =
        joint_.at_rest({.reaction = input.force, .moment = input.turn});
    rest.utilisation = held.utilisation;
    rest.direction = held.direction;
    return held.slip;
  }

  const cli::Joint& given_;
  contact::SeatJoint joint_;
};

}  // namespace

cli::ExitStatus run_in_seat(const Options& options) {
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  const Inputs inputs(options, joints[0].is_pin());
  const Columns columns(inputs.question() == Question::rest);
  warn_of_validity("hinge-joint", joints);
  cli::ExitStatus status = cli::all_good;
  cli::write_table(
      options.output, cli::joint_columns(joints, {columns.names()}),
      [&](cli::RowWriter& row) {
        for (const cli::Joint& joint : joints) {
          const Rows rows(options, joint);
          status = std::max(status, rows.write(inputs, columns, row));
        }
      });
  return status;
}

}  // namespace hinge_joint
