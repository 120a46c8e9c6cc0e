#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/solution.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// A joint's answer to one state.
struct Answer {
  Question question;
  std::optional<Input::Given> given;
  Eigen::Vector3d rate;  ///< Dw; at rest u, with 1 rad/s
  contact::JointSolution solution;
  /// |M_t| that R would give as the normal force, N m.
  double traditional;
  /// |M_t|/(rho R).
  double moment_coefficient;
  double mean_pressure;     ///< Pa
  double nominal_pressure;  ///< Pa
  double nominal_area;      ///< m^2
  /// Of p |v| and of heat over the contact, if NamedJoint::pv.
  contact::SlidingContact::Peak pv;
  contact::SlidingContact::Peak heat;
  double pv_mean;     ///< W/m^2
  double pv_nominal;  ///< W/m^2
  double slip_coefficient;
  /// f0 of dry friction.
  double coefficient;
  /// Of Question::rest: tau, u.
  double utilisation;
  Eigen::Vector3d direction;
  /// Of the half-angle law exact, SI units; NaN of others.
  contact::ContactApproach approach;
};

Answer answer(const NamedJoint& joint, Question question, const Input& input);

/// "sliding", "resting", "unloaded"; of Question::rest "holds" or "slips".
std::string_view state_text(const Answer& a);
/// "ok", "out_of_range", "not_converged".
std::string_view status_text(contact::Status status);

/// A number of an answer: its column, and what it is.
struct Quantity {
  std::string_view name;
  std::string_view meaning;
  double (*of)(const Answer&);
};

/// All of them in the order of the columns.
/// @param rest      with those of Question::rest
/// @param approach  with those of the half-angle law exact
/// @param friction  with f0
/// @param pv        with those of NamedJoint::pv
std::vector<Quantity> quantities(bool rest, bool approach, bool friction,
                                 bool pv);

}  // namespace hinge_joint
