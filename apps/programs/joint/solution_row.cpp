#include "programs/joint/solution_row.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/duty/joint_rating.hpp"

namespace hinge_joint {
namespace {

using contact::Dimension;
using contact::Quantity;
using Eigen::Vector3d;

using contact::detail::nan;

// Quantities not contained in a solution; each follows one of its own.
struct Beyond {
  std::string_view behind;
  Quantity<Answer> quantity;
};
constexpr Beyond beyond_solutions[] = {
    {"reaction",
     {"angular_velocity", "w", Dimension::angular_velocity,
      "angular velocity Dw, body against carrier",
      [](const Answer& a) -> const Vector3d& { return a.rate; }}},
    {"friction_moment",
     {"M_traditional", "", Dimension::moment,
      "friction moment if R were the normal force",
      [](const Answer& a) { return a.traditional; }}},
    {"peak_pressure",
     {"p_mean", "", Dimension::stress, "mean pressure over the contact",
      [](const Answer& a) { return a.mean_pressure; }}},
    {"peak_pressure",
     {"p_nominal", "", Dimension::stress,
      "R over the area of catalogues: pi rho^2, diameter times width of a "
      "ring, or 2 rho L",
      [](const Answer& a) { return a.nominal_pressure; }}},
};

constexpr Quantity<Answer> found_friction = {
    "f0", "", Dimension::number,
    "friction coefficient of the surface, with which M_t is as measured",
    [](const Answer& a) { return a.coefficient; }};

constexpr Quantity<Answer> place_of_load = {
    "load_at", "", Dimension::length,
    "place of the reaction along the pin, from its middle",
    [](const Answer& a) { return a.load_place; }};

// Columns that --pv omits: the last three follow from others.
constexpr std::string_view not_of_pv[] = {"pv_total", "heat",
                                          "heat_flux_max_place"};

struct Given {
  std::string_view column;
  double Input::Given::*given;
  Question question;
};
constexpr Given shown_as_given[] = {
    {"R_N", &Input::Given::force, Question::reaction},
    {"b_deg", &Input::Given::angle_deg, Question::reaction},
    {"R_n_N", &Input::Given::force, Question::contact},
    {"a_deg", &Input::Given::angle_deg, Question::contact},
};

template <class T>
void add(const Quantity<T>& quantity, std::vector<AnswerColumn>& to) {
  for (auto& column : contact::columns_of(quantity)) {
    to.push_back({column.name, column.meaning, std::move(column)});
  }
}

std::vector<AnswerColumn> solution_columns() {
  std::vector<AnswerColumn> all;
  for (const auto& quantity : contact::solution_quantities()) {
    add(quantity, all);
    for (const Beyond& beyond : beyond_solutions) {
      if (beyond.behind == quantity.key) add(beyond.quantity, all);
    }
  }
  for (const Given& shown : shown_as_given) {
    AnswerColumn& column = *std::find_if(all.begin(), all.end(),
                                         [&shown](const AnswerColumn& each) {
                                           return each.name == shown.column;
                                         });
    column.given = shown.given;
    column.given_in = shown.question;
  }
  return all;
}

}  // namespace

double AnswerColumn::operator()(const Answer& a) const {
  double solved = 0;
  if (const auto* column = std::get_if<0>(&of)) {
    solved = (*column)(a.rest.slip);
  } else if (const auto* own = std::get_if<1>(&of)) {
    solved = (*own)(a);
  } else if (const auto* rated = std::get_if<2>(&of)) {
    solved = (*rated)(a.rating);
  } else if (const auto* held = std::get_if<3>(&of)) {
    solved = (*held)(a.rest);
  } else if (const auto* approached = std::get_if<4>(&of)) {
    solved = (*approached)(a.approach);
  } else if (const auto* patch = std::get_if<5>(&of)) {
    solved = (*patch)(*a.patch);
  } else if (const auto* rims = std::get_if<6>(&of)) {
    solved = (*rims)(a.rims);
  } else {
    solved = a.lie ? std::get<7>(of)(*a.lie) : nan;
  }
  const bool is_given =
      given && a.given && a.question == given_in && !std::isnan(solved);
  return is_given ? (*a.given).*given : solved;
}

namespace {

// Adds the numbers of a contact that is not axisymmetric: at a rim, or along a
// finite-length pin.
void add_ends(const NamedJoint& named, Answer& a) {
  const contact::JointSolution& s = a.solution();
  a.lie = named.joint.lie(s);
  if (a.lie && a.lie->pieces > 0) {
    // The ratio does not depend on the speed.
    const contact::ContactPv about = named.joint.pv(
        s, a.rate.isZero(0) ? Vector3d(Vector3d::UnitZ()) : a.rate);
    a.mean_pressure =
        about.total / s.contact_area * s.peak_pressure / about.largest;
  }
  const auto rims = named.joint.rims(s);
  if (!rims) return;
  a.rims = *rims;
  if (!rims->is_free) a.mean_pressure = rims->mean_pressure();
}

}  // namespace

Answer answer(const NamedJoint& named, Question question, const Input& input) {
  const contact::Joint& joint = named.joint;
  Answer a{.question = question,
           .given = input.given,
           .rate = input.turn,
           .traditional = nan,
           .rest = {},
           .mean_pressure = nan,
           .nominal_pressure = nan,
           .coefficient = nan,
           .rating = {},
           .approach = {nan, nan},
           .patch = {},
           .load_place = input.placement ? input.placement->place : nan};
  const contact::Placement* placement =
      input.placement ? &*input.placement : nullptr;
  const Vector3d axis(0, 0, placement ? 1 : 0);
  a.rest.utilisation = nan;
  switch (question) {
    case Question::reaction:
      a.rest.slip = joint.solve({input.force, input.turn, axis, placement});
      break;
    case Question::contact:
      a.rest.slip = joint.solve_contact(
          {.normal_force = input.force, .angular_velocity = input.turn});
      break;
    case Question::rest: {
      a.rest = joint.at_rest({.reaction = input.force, .moment = input.turn});
      a.rest.slip.status = a.rest.status;
      a.rate = a.rest.direction;
      break;
    }
  }
  const contact::JointSolution& s = a.solution();
  a.patch.emplace(
      contact::ContactPatch{joint.contact(), s.normal_force, s.half_angle});
  if (named.approach) a.approach = (*named.approach)(s.half_angle);
  const double force = contact::magnitude(s.reaction);
  const contact::JointSolution traditional =
      joint.solve_contact({s.reaction, a.rate, axis, placement});
  a.traditional = contact::magnitude(traditional.friction_moment);
  const bool is_pressed =
      s.normal_force != 0 || joint.contact().has_interference();
  a.mean_pressure =
      is_pressed ? joint.contact().mean_pressure(s.normal_force, s.half_angle)
                 : 0;
  a.nominal_pressure = joint.contact().geometry().nominal_pressure(force);
  if (const auto* dry =
          std::get_if<contact::FrictionLaw>(&joint.contact().friction())) {
    a.coefficient = dry->coefficient();
  }
  if (named.pv) {
    a.rating = contact::rating_of(joint, s, a.rate);
  }
  add_ends(named, a);
  return a;
}

std::string_view state_text(const Answer& a) {
  if (!std::isnan(a.rest.utilisation)) {
    return a.rest.utilisation <= 1 ? "holds" : "slips";
  }
  return to_string(a.solution().state);
}

std::string_view contact_state_text(const Answer& a) {
  return to_string(a.solution().contact_state);
}

bool have_preload(std::span<const AnswerColumn> columns) {
  const std::string first =
      contact::columns_of(contact::preload_quantities()[0])[0].name;
  return std::ranges::find(columns, first, &AnswerColumn::name) !=
         columns.end();
}

std::vector<AnswerColumn> answer_columns(const ColumnSets& with) {
  std::vector<AnswerColumn> all = solution_columns();
  const auto add_all = [&](const auto& quantities) {
    for (const auto& quantity : quantities) add(quantity, all);
  };
  if (with.rims) add_all(contact::rim_quantities());
  if (with.place) add(place_of_load, all);
  if (with.lie) add_all(contact::lie_quantities());
  if (with.approach) {
    add_all(contact::approach_quantities());
    add_all(contact::presliding_quantities());
  }
  if (with.preload) add_all(contact::preload_quantities());
  if (with.rest) {
    for (const std::string_view key : {"utilisation", "direction"}) {
      add(*find_quantity(contact::rest_quantities(), key), all);
    }
  }
  if (with.friction) add(found_friction, all);
  if (!with.pv) return all;
  for (const auto& quantity : contact::rating_quantities()) {
    const bool is_of_rims =
        with.rims && find_quantity(contact::rim_quantities(), quantity.key);
    if (!is_of_rims && std::find(std::begin(not_of_pv), std::end(not_of_pv),
                                 quantity.key) == std::end(not_of_pv)) {
      add(quantity, all);
    }
  }
  return all;
}

}  // namespace hinge_joint
