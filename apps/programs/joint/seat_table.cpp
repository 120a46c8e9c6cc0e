#include "programs/joint/seat_table.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/seat.hpp"
#include "programs/joint/input.hpp"

namespace hinge_joint {
namespace {

using contact::SeatJointSolution;
using contact::SeatRestSolution;

const SeatJointSolution& slip_of(const SeatJointSolution& s) { return s; }
const SeatJointSolution& slip_of(const SeatRestSolution& s) { return s.slip; }

template <class Answer>
using Columns = std::vector<contact::Column<Answer>>;

// The rows of a joint; what is to be said of them.
template <class Answer>
class Rows {
 public:
  Rows(const Options& options, const cli::Joint& joint)
      : given_(joint), joint_(with_friction(options, joint)) {}

  cli::ExitStatus write(const Inputs& inputs, const Columns<Answer>& columns,
                        cli::RowWriter& row) const {
    contact::LargestContact largest;
    std::set<std::string> notes;
    Answer answer;
    cli::ExitStatus status = cli::all_good;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      solve(inputs[i], answer);
      const SeatJointSolution& s = slip_of(answer);
      cli::write_differences(given_.differences, row);
      row.text(to_string(s.contact.status));
      for (const auto& column : columns) row.number(column(answer) + 0.0);
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

  void solve(const Input& input, SeatJointSolution& s) const {
    s = joint_.solve({.reaction = input.force, .angular_velocity = input.turn},
                     s);
  }
  void solve(const Input& input, SeatRestSolution& s) const {
    s = joint_.at_rest({.reaction = input.force, .moment = input.turn});
  }

  const cli::Joint& given_;
  contact::SeatJoint joint_;
};

template <class Answer>
cli::ExitStatus write(const Options& options,
                      const std::vector<cli::Joint>& joints,
                      const Inputs& inputs, const Columns<Answer>& columns) {
  std::vector<std::string> names = {"status"};
  for (const auto& column : columns) names.push_back(column.name);
  cli::ExitStatus status = cli::all_good;
  cli::write_table(options.output, cli::joint_columns(joints, {names}),
                   [&](cli::RowWriter& row) {
                     for (const cli::Joint& joint : joints) {
                       const Rows<Answer> rows(options, joint);
                       status =
                           std::max(status, rows.write(inputs, columns, row));
                     }
                   });
  return status;
}

// Angles from z say where a reaction points on seats about z only.
void check_angles(const std::vector<cli::Joint>& joints, const Inputs& inputs) {
  for (const cli::Joint& joint : joints) {
    const auto& seat = joint.spec.geometry.seat();
    if (!inputs.forces() || !seat || is_about_z(*seat)) continue;
    cli::refuse_without("--reaction with a seat about another axis than z",
                        "--reaction-xyz");
  }
}

}  // namespace

cli::ExitStatus run_in_seat(const Options& options) {
  const std::vector<cli::Joint> joints = make_joints(options.joint);
  const Inputs inputs(options, joints[0].is_pin());
  check_angles(joints, inputs);
  warn_of_validity("hinge-joint", joints);
  return inputs.question() == Question::rest
             ? write(options, joints, inputs,
                     columns_of(contact::seat_rest_quantities()))
             : write(options, joints, inputs,
                     columns_of(contact::seat_joint_quantities()));
}

}  // namespace hinge_joint
