#include "python/solved.hpp"

#include <cmath>
#include <limits>

#include "libcontact/base/constants.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact_python {
namespace {

using contact::Joint;
using contact::JointSolution;
using contact::PinLie;
using contact::RimContact;

const RimContact& no_rims() {
  static const auto& none = *new RimContact([] {
    RimContact rims;
    rims.force.setConstant(std::numeric_limits<double>::quiet_NaN());
    return rims;
  }());
  return none;
}

const PinLie& no_lie() {
  static const auto& none = *new PinLie([] {
    using contact::detail::nan;
    PinLie lie;
    for (auto* v : {&lie.tilt, &lie.shift, &lie.tilting_moment, &lie.moment}) {
      v->setConstant(nan);
    }
    lie.end_pressure = lie.end_half_angle = {nan, nan};
    lie.axial_friction_force = nan;
    return lie;
  }());
  return none;
}

const RimContact& rims_of(const Solved& s) {
  return s.ends ? s.ends->rims : no_rims();
}

const PinLie& lie_of(const Solved& s) {
  return s.ends ? s.ends->lie : no_lie();
}

EndsOf ends_of(const Joint& joint, const JointSolution& s) {
  if (joint.is_endless() && !s.work) return nullptr;
  return std::make_shared<const Ends>(
      Ends{joint.rims(s).value_or(no_rims()), joint.lie(s).value_or(no_lie())});
}

}  // namespace

Solved::Solved(const Joint& joint, const JointSolution& s)
    : JointSolution(s.without_grid()), ends(ends_of(joint, s)) {}

Held::Held(const Joint& joint, const contact::RestSolution& rest)
    : RestSolution(rest), ends(ends_of(joint, rest.slip)) {
  slip = slip.without_grid();
}

Stepped::Stepped(const Joint& joint, const contact::JointStep& step)
    : JointStep(step),
      ends(ends_of(joint, step.solution)),
      rest_ends(ends_of(joint, step.rest.slip)) {
  solution = solution.without_grid();
  rest.slip = rest.slip.without_grid();
}

const Table<Solved>& solved_table() {
  static const auto& all = *new Table<Solved>([] {
    Table<Solved> table;
    add(table, contact::solution_quantities(),
        [](const Solved& s) -> const JointSolution& { return s; });
    add(table, contact::rim_quantities(), rims_of);
    add(table, contact::lie_quantities(), lie_of);
    return table;
  }());
  return all;
}

const Table<Held>& held_table() {
  static const auto& all = *new Table<Held>([] {
    Table<Held> table;
    add(table, contact::rest_quantities(),
        [](const Held& r) -> const contact::RestSolution& { return r; });
    return table;
  }());
  return all;
}

const Table<Stepped>& stepped_table() {
  static const auto& all = *new Table<Stepped>([] {
    Table<Stepped> table;
    add(table, contact::step_quantities(),
        [](const Stepped& s) -> const contact::JointStep& { return s; });
    return table;
  }());
  return all;
}

void NearRim::keep(const Joint& joint, const JointSolution& s) {
  const bool is_at_rim =
      s.status == contact::Status::ok && s.work && std::isnan(s.half_angle);
  if (!is_at_rim) return;
  of_ = &joint;
  work_ = s.work;
}

}  // namespace contact_python
