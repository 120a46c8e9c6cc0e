#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"

namespace hinge_joint {

/// A joint's answer to one state.
struct Answer {
  Question question;
  std::optional<Input::Given> given;
  Eigen::Vector3d rate;  ///< Dw; at rest u, with 1 rad/s
  /// |M_t| that R would give as the normal force, N m.
  double traditional;
  /// Its slip is the solution, its utilisation NaN but of Question::rest.
  contact::RestSolution rest;
  double mean_pressure;     ///< Pa
  double nominal_pressure;  ///< Pa
  /// f0 of dry friction.
  double coefficient;
  /// If NamedJoint::pv.
  contact::SlidingContact::Rating rating;
  /// Approach by the exact half-angle law, SI units; NaN of others.
  contact::ContactApproach approach;
  /// Patch of the joint that answered; it must not outlive this.
  std::optional<contact::ContactPatch> patch;
  /// NaN without a seat that ends.
  contact::RimContact rims = {};
  /// None of a pin that is level and endless.
  std::optional<contact::PinLie> lie = {};
  double load_place;  ///< place of Input::placement, m

  const contact::JointSolution& solution() const { return rest.slip; }
};

Answer answer(const NamedJoint& joint, Question question, const Input& input);

/// "sliding", "resting", "unloaded"; of Question::rest "holds" or "slips".
std::string_view state_text(const Answer& a);

/// "closed", "lifted", "zero" or "clearance".
std::string_view contact_state_text(const Answer& a);

/// A number of an answer.
struct AnswerColumn {
  std::string name;
  std::string_view meaning;
  std::variant<contact::Column<contact::JointSolution>, contact::Column<Answer>,
               contact::Column<contact::SlidingContact::Rating>,
               contact::Column<contact::RestSolution>,
               contact::Column<contact::ContactApproach>,
               contact::Column<contact::ContactPatch>,
               contact::Column<contact::RimContact>,
               contact::Column<contact::PinLie>>
      of;
  /// A force or an angle that was given is shown as it was given: what the
  /// solution says of it differs in the last digits, and rows would not be
  /// found by it.
  double Input::Given::*given = nullptr;
  Question given_in = Question::reaction;

  double operator()(const Answer& a) const;
};

/// Columns in addition to the ones of every solution.
struct ColumnSets {
  bool rest = false;      ///< columns of Question::rest
  bool approach = false;  ///< approach by the half-angle law exact
  bool preload = false;   ///< contact of joints without clearance
  bool friction = false;  ///< f0
  bool pv = false;        ///< p v, NamedJoint::pv
  bool rims = false;      ///< rims of seats that end
  bool lie = false;       ///< tilt and ends of pins that end
  bool place = false;     ///< place of the load along the pin
};

/// All of them in the order of the columns.
std::vector<AnswerColumn> answer_columns(const ColumnSets& with);

/// Whether to include the columns of joints without clearance, with the word
/// contact_state.
bool have_preload(std::span<const AnswerColumn> columns);

}  // namespace hinge_joint
