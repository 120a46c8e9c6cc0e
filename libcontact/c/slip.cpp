#include "libcontact/c/slip.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/c/numbers.hpp"
#include "libcontact/joint/contact_notes.hpp"

namespace contact::c {
namespace {

using detail::message;
using Eigen::Vector3d;

Vector3d vector(const double (&from)[3]) { return Vector3d(from); }

// Row i of an array that may lie anywhere.
Vector3d vector(const double* first, std::ptrdiff_t stride, std::size_t i) {
  Vector3d v;
  std::memcpy(v.data(),
              reinterpret_cast<const char*>(first) +
                  static_cast<std::ptrdiff_t>(i) * stride,
              sizeof(double[3]));
  return v;
}

// Start of the next solution, the accurate forms of the angles, and the members
// that have a name in C++ alone.
struct Memory {
  JointSolution::Memory slip;
  SineCosine reaction;
  SineCosine friction;
  SlipAxis axis;
  double contact_state;  // a ContactState
};
static_assert(std::is_trivially_copyable_v<Memory> &&
              sizeof(Memory) == sizeof(contact_solution::memory));

Memory memory_of(const contact_solution& s) {
  Memory memory;
  std::memcpy(&memory, s.memory, sizeof memory);
  return memory;
}

contact_state state_of(JointState state) {
  switch (state) {
    case JointState::sliding:
      return CONTACT_SLIDING;
    case JointState::resting:
      return CONTACT_RESTING;
    case JointState::unloaded:
      break;
  }
  return CONTACT_UNLOADED;
}

// The numbers of a solution in both languages.
template <class C, class Cpp, class Copy>
void each_number(C& c, Cpp& s, const Copy& copy) {
  copy(c.residual, s.residual);
  copy(c.reaction, s.reaction);
  copy(c.normal, s.normal);
  copy(c.normal_force, s.normal_force);
  copy(c.friction_force, s.friction_force);
  copy(c.friction_moment, s.friction_moment);
  copy(c.textbook_moment, s.textbook_moment);
  copy(c.slip_velocity, s.slip_velocity);
  copy(c.power, s.power);
  copy(c.force_coefficient, s.force_coefficient);
  copy(c.sliding_coefficient, s.sliding_coefficient);
  copy(c.spinning_coefficient, s.spinning_coefficient);
  copy(c.adhesion_number, s.adhesion_number);
  copy(c.load_parameter, s.load_parameter);
  copy(c.half_angle, s.half_angle);
  copy(c.peak_pressure, s.peak_pressure);
  copy(c.contact_area, s.contact_area);
}

// Solution to start from.
JointSolution start_of(const contact_solution* last) {
  JointSolution s;
  if (!last) return s;
  const Memory memory = memory_of(*last);
  s.memory = memory.slip;
  s.reaction_direction = memory.reaction;
  s.friction_direction = memory.friction;
  s.slip_axis = memory.axis;
  return s;
}

// Checks that all that solve_rows() reads and writes is there.
void check(const contact_slips& slips, const contact_solution* solutions,
           std::ptrdiff_t stride) {
  constexpr const char* place = "contact_joint_solve_rows";
  detail::require(slips.tolerance >= 0, place, "tolerance", slips.tolerance,
                  "0 or above");
  if (slips.count == 0) return;
  given(slips.reaction, "contact_joint_solve_rows: reaction");
  given(slips.angular_velocity, "contact_joint_solve_rows: angular_velocity");
  given(solutions, "contact_joint_solve_rows: solutions");
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(contact_solution));
  constexpr std::ptrdiff_t unit = alignof(contact_solution);
  detail::require(std::abs(stride) >= size && stride % unit == 0, place,
                  "stride", static_cast<double>(stride),
                  message("a multiple of {}, sizeof(contact_solution) = {} or "
                          "above",
                          unit, size));
}

SolveOptions options_of(const contact_slips& slips) {
  SolveOptions options;
  if (slips.tolerance > 0) options.tolerance = slips.tolerance;
  return options;
}

contact_status solve_rows(const Joint& joint, const contact_slips& slips,
                          contact_solution* solutions, std::ptrdiff_t stride) {
  const SolveOptions options = options_of(slips);
  contact_status status = CONTACT_OK;
  std::size_t bad = 0;
  JointSolution last;
  for (std::size_t i = 0; i < slips.count; ++i) {
    Joint::Slip slip = {
        vector(slips.reaction, slips.reaction_stride, i),
        vector(slips.angular_velocity, slips.angular_velocity_stride, i)};
    if (slips.axis) slip.axis = vector(slips.axis, slips.axis_stride, i);
    JointSolution s = slips.warm ? joint.solve(slip, last, options)
                                 : joint.solve(slip, options);
    last.memory = s.memory;
    last.work = std::move(s.work);
    auto* const to = reinterpret_cast<contact_solution*>(
        reinterpret_cast<char*>(solutions) +
        static_cast<std::ptrdiff_t>(i) * stride);
    put(*to, s);
    if (status == CONTACT_OK && to->status != CONTACT_OK) {
      status = to->status;
      bad = i;
    }
  }
  return status == CONTACT_OK
             ? status
             : reported(status,
                        message("contact_joint_solve_rows: row {}", bad));
}

}  // namespace

void Refused<contact_solution>::write(contact_solution* s,
                                      contact_status status) noexcept {
  s->status = status;
  s->state = CONTACT_UNLOADED;
  s->evaluations = 0;
  each_number(*s, *s, ToNan());
  for (double* angle :
       {&s->reaction_angle, &s->friction_angle, &s->slip_axis_angle}) {
    ToNan()(*angle, *angle);
  }
}

void Refused<contact_rest>::write(contact_rest* rest,
                                  contact_status status) noexcept {
  rest->status = status;
  rest->solves = 0;
  ToNan()(rest->utilisation, rest->utilisation);
  ToNan()(rest->direction, rest->direction);
  Refused<contact_solution>::write(&rest->slip, status);
}

contact_status status_of(Status status) {
  switch (status) {
    case Status::ok:
      return CONTACT_OK;
    case Status::out_of_range:
      return CONTACT_OUT_OF_RANGE;
    case Status::not_converged:
      return CONTACT_NOT_CONVERGED;
    case Status::out_of_seat:
      break;
  }
  return CONTACT_OUT_OF_SEAT;
}

Status cpp_status(contact_status status) {
  for (const Status one :
       {Status::ok, Status::not_converged, Status::out_of_seat}) {
    if (status == status_of(one)) return one;
  }
  return Status::out_of_range;
}

void put(contact_solution& to, const JointSolution& s) {
  to.status = status_of(s.status);
  to.state = state_of(s.state);
  to.evaluations = s.evaluations;
  each_number(to, s, ToC());
  to.reaction_angle = s.reaction_angle();
  to.friction_angle = s.friction_angle();
  to.slip_axis_angle = s.slip_axis_angle();
  const Memory memory{s.memory, s.reaction_direction, s.friction_direction,
                      s.slip_axis, static_cast<double>(s.contact_state)};
  std::memcpy(to.memory, &memory, sizeof to.memory);
}

void put(contact_rest& to, const RestSolution& rest) {
  to.status = status_of(rest.status);
  to.solves = rest.solves;
  to.utilisation = rest.utilisation;
  ToC()(to.direction, rest.direction);
  put(to.slip, rest.slip);
}

contact_status reported(contact_status status, std::string_view place) {
  if (status == CONTACT_OK) return status;
  const std::string said = message(
      status == CONTACT_NOT_CONVERGED ? "{}: not converged"
      : status == CONTACT_OUT_OF_SEAT
          ? "{}: no pressure on the seat carries the load: the ball leaves it"
          : "{}: no solution: numbers must be finite and the contact in "
            "the range of the laws",
      place);
  return contact_report(status, said.c_str());
}

contact_status reported(const Joint& joint, const JointSolution& s,
                        std::string_view place) {
  // NaN in R or Dw leaves no work.
  if (s.status == Status::ok || s.status == Status::not_converged || !s.work) {
    return reported(status_of(s.status), place);
  }
  const std::string why = message("{}: {}", place, joint.notes(s).front());
  return contact_report(status_of(s.status), why.c_str());
}

Joint::Slip slip_of(const contact_slip& slip) {
  return {vector(slip.reaction), vector(slip.angular_velocity),
          vector(slip.axis)};
}

JointSolution whole(const Joint& joint, const contact_solution& solution) {
  JointSolution s = solution_of(solution);
  if (joint.is_endless() || s.status != Status::ok || s.normal_force == 0 ||
      !std::isnan(s.half_angle)) {
    return s;
  }
  s.work = joint
               .solve_contact({.normal_force = s.normal_force * s.normal,
                               .angular_velocity = Vector3d::Zero(),
                               .axis = s.friction_moment.stableNormalized()})
               .work;
  return s;
}

JointSolution solution_of(const contact_solution& solution) {
  JointSolution s = start_of(&solution);
  s.status = cpp_status(solution.status);
  s.state = static_cast<JointState>(solution.state);
  // A refused solution has none.
  const double state = memory_of(solution).contact_state;
  if (state >= 0 && state <= static_cast<double>(ContactState::clearance)) {
    s.contact_state = static_cast<ContactState>(state);
  }
  s.evaluations = solution.evaluations;
  each_number(solution, s, FromC());
  return s;
}

RestSolution rest_of(const contact_rest& rest) {
  return {.status = cpp_status(rest.status),
          .utilisation = rest.utilisation,
          .direction = vector(rest.direction),
          .slip = solution_of(rest.slip),
          .solves = rest.solves};
}

}  // namespace contact::c

using contact::Joint;
using contact::RestSolution;
using contact::c::call_for;
using contact::c::given;
using contact::c::put;
using contact::c::reported;
using contact::c::slip_of;
using contact::c::start_of;
using contact::c::vector;

std::size_t contact_solution_size() { return sizeof(contact_solution); }

contact_status contact_joint_solve(const contact_joint* joint,
                                   const contact_slip* slip,
                                   const contact_solution* last,
                                   contact_solution* solution) {
  return call_for(
      [=] {
        const Joint& j = given(joint, "contact_joint_solve: joint").joint;
        const Joint::Slip s = slip_of(given(slip, "contact_joint_solve: slip"));
        const contact::JointSolution found = j.solve(s, start_of(last));
        put(given(solution, "contact_joint_solve: solution"), found);
        return reported(j, found, "contact_joint_solve");
      },
      solution);
}

contact_status contact_joint_solve_contact(const contact_joint* joint,
                                           const contact_slip* known,
                                           contact_solution* solution) {
  return call_for(
      [=] {
        const Joint& j =
            given(joint, "contact_joint_solve_contact: joint").joint;
        const Joint::Slip s =
            slip_of(given(known, "contact_joint_solve_contact: known"));
        const contact::JointSolution found =
            j.solve_contact({s.reaction, s.angular_velocity, s.axis});
        put(given(solution, "contact_joint_solve_contact: solution"), found);
        return reported(j, found, "contact_joint_solve_contact");
      },
      solution);
}

contact_status contact_joint_solution_notes(const contact_joint* joint,
                                            const contact_solution* solution,
                                            char* text, std::size_t size) {
  return contact::c::call([=] {
    const Joint& j = given(joint, "contact_joint_solution_notes: joint").joint;
    const auto& s = given(solution, "contact_joint_solution_notes: solution");
    if (size > 0) given(text, "contact_joint_solution_notes: text");
    std::vector<std::string> notes;
    if (s.status == CONTACT_OK && s.normal_force > 0) {
      const contact::JointSolution found = contact::c::whole(j, s);
      contact::LargestContact beyond;
      const auto lie = j.lie(found);
      beyond.add(lie ? lie->largest_half_angle : 0, 0,
                 contact::rim_overlap(j.contact(), found));
      notes = j.contact().limits().notes(beyond);
      for (auto& note : j.notes(found)) notes.push_back(std::move(note));
    }
    return contact::c::hand_over_notes(notes, text, size);
  });
}

contact_status contact_joint_solve_rows(const contact_joint* joint,
                                        const contact_slips* slips,
                                        contact_solution* solutions,
                                        std::ptrdiff_t stride) {
  return call_for(
      [=] {
        const Joint& j = given(joint, "contact_joint_solve_rows: joint").joint;
        contact::c::check(given(slips, "contact_joint_solve_rows: slips"),
                          solutions, stride);
        return contact::c::solve_rows(j, *slips, solutions, stride);
      },
      slips && slips->count > 0 ? solutions : nullptr);
}

contact_status contact_joint_at_rest(const contact_joint* joint,
                                     const contact_hold* hold,
                                     const contact_rest* last,
                                     contact_rest* rest) {
  return call_for(
      [=] {
        const Joint& j = given(joint, "contact_joint_at_rest: joint").joint;
        const contact_hold& h = given(hold, "contact_joint_at_rest: hold");
        contact_rest& to = given(rest, "contact_joint_at_rest: rest");
        const Joint::Hold holds = {vector(h.reaction), vector(h.moment),
                                   vector(h.axis)};
        const RestSolution found =
            last ? j.at_rest(holds, contact::c::rest_of(*last))
                 : j.at_rest(holds);
        put(to, found);
        return found.status == contact::Status::out_of_seat
                   ? reported(j, found.slip, "contact_joint_at_rest")
                   : reported(to.status, "contact_joint_at_rest");
      },
      rest);
}
