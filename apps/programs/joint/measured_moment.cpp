#include "programs/joint/measured_moment.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "cli/number.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/root_finding.hpp"

namespace hinge_joint {
namespace {

constexpr const char* measured_option = "--measured-moment";

// The joint with another f0.
contact::Joint with_friction(const contact::Joint& joint, double coefficient) {
  const contact::JointContact& contact = joint.contact();
  const auto& friction = std::get<contact::FrictionLaw>(contact.friction());
  return contact::Joint(contact.with_friction(
      contact::FrictionLaw(coefficient, friction.adhesion())));
}

// |M_t|; NaN without a solution.
double moment_of(const contact::Joint& joint, Question question,
                 const Input& input) {
  const contact::JointSolution solution =
      question == Question::contact
          ? joint.solve_contact(
                {.normal_force = input.force, .angular_velocity = input.turn})
          : joint.solve(
                {.reaction = input.force, .angular_velocity = input.turn});
  return solution.status == contact::Status::ok
             ? contact::magnitude(solution.friction_moment)
             : std::numeric_limits<double>::quiet_NaN();
}

double found_coefficient(const NamedJoint& joint, double measured,
                         Question question, const Input& input) {
  const auto moment = [&](double coefficient) {
    return moment_of(with_friction(joint.joint, coefficient), question, input);
  };
  const auto beyond = [&](double f0) { return moment(f0) - measured; };
  const double low = beyond(0);
  const double high = beyond(largest_measured_friction);
  const std::string laws =
      fmt::format("law {}, pressure {}", joint.law, joint.pressure);
  if (std::isnan(low) || std::isnan(high)) {
    cli::refuse_without(measured_option,
                        "a state that has a solution with " + laws);
  }
  if (low == 0) return 0;
  if (!(low < 0 && high >= 0)) {
    cli::refuse(
        measured_option, cli::number_text(measured),
        fmt::format("{:.6g} to {:.6g} N m, |M_t| for f0 from 0 to {} ({})",
                    moment(0), moment(largest_measured_friction),
                    largest_measured_friction, laws));
  }
  constexpr int all_bits = 53;
  return contact::shrink_bracket(beyond, 0, largest_measured_friction, low,
                                 high, all_bits)
      .middle();
}

}  // namespace

void find_friction(double moment, const Inputs& inputs, Setup& setup) {
  if (inputs.size() != 1) cli::refuse_without(measured_option, "one state");
  const Input input = inputs[0];
  if (input.force.isZero(0) || input.turn.isZero(0)) {
    cli::refuse_without(measured_option, "a force and a rate that are not 0");
  }
  for (NamedJoint& joint : setup.joints) {
    joint.joint = with_friction(
        joint.joint,
        found_coefficient(joint, moment, inputs.question(), input));
  }
  setup.friction_found = true;
}

}  // namespace hinge_joint
