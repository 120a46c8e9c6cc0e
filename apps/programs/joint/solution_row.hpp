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

/// A joint's solution for one state.
struct Answer {
  Question question;
  std::optional<Input::Given> given;
  Eigen::Vector3d rate;  ///< Dw; at rest u times 1 rad/s
  /// |M_t| if R were the normal force, N m.
  double traditional;
  /// Its slip is the solution; its utilisation is NaN except for
  /// Question::rest.
  contact::RestSolution rest;
  double mean_pressure;     ///< Pa
  double nominal_pressure;  ///< Pa
  /// f0 of dry friction.
  double coefficient;
  /// Computed if NamedJoint::pv.
  contact::SlidingContact::Rating rating;
  /// Approach by the exact half-angle law, SI units; NaN for other laws.
  contact::ContactApproach approach;
  /// Contact patch of the joint, which must outlive it.
  std::optional<contact::ContactPatch> patch;
  /// NaN without a seat that ends.
  contact::RimContact rims = {};
  /// Empty for a level pin of unlimited length.
  std::optional<contact::PinLie> lie = {};
  double load_place;  ///< place of the load, Input::placement, m

  const contact::JointSolution& solution() const { return rest.slip; }
};

Answer answer(const NamedJoint& joint, Question question, const Input& input);

/// "sliding", "resting", "unloaded"; for Question::rest "holds" or "slips".
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
  /// A force or angle that the user gave is printed as given. Recomputed from
  /// the solution it would differ in the last digits, and a search for the
  /// given value would fail.
  double Input::Given::*given = nullptr;
  Question given_in = Question::reaction;

  double operator()(const Answer& a) const;
};

/// Columns in addition to the columns of every solution.
struct ColumnSets {
  bool rest = false;      ///< columns of Question::rest
  bool approach = false;  ///< approach by the half-angle law exact
  bool preload = false;   ///< contacts of joints without clearance
  bool friction = false;  ///< f0
  bool pv = false;        ///< p v, with NamedJoint::pv
  bool rims = false;      ///< rims of seats that end
  bool lie = false;       ///< tilt and contact ends of finite-length pins
  bool place = false;     ///< place of the load along the pin
};

/// All columns, in the order of the table.
std::vector<AnswerColumn> answer_columns(const ColumnSets& with);

/// True if the columns of joints without clearance are included, such as
/// contact_state.
bool have_preload(std::span<const AnswerColumn> columns);

}  // namespace hinge_joint
