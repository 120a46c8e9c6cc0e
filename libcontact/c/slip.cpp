#include "libcontact/c/slip.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>

#include "libcontact/base/check.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"

namespace contact::c {
namespace {

using detail::message;
using Eigen::Vector3d;

// Vectors and memories go between the languages as bytes.
void put(double (&to)[3], const Vector3d& from) {
  std::copy_n(from.data(), 3, to);
}

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

// What the next solution starts from: of the reaction angle the accurate form.
struct Memory {
  JointSolution::Memory slip;
  SineCosine reaction;
};
static_assert(std::is_trivially_copyable_v<Memory> &&
              sizeof(Memory) == sizeof(contact_solution::memory));

Memory memory_of(const contact_solution& s) {
  Memory memory;
  std::memcpy(&memory, s.memory, sizeof memory);
  return memory;
}

contact_status status_of(Status status) {
  switch (status) {
    case Status::ok:
      return CONTACT_OK;
    case Status::out_of_range:
      return CONTACT_OUT_OF_RANGE;
    case Status::not_converged:
      break;
  }
  return CONTACT_NOT_CONVERGED;
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

void put(contact_solution& to, const JointSolution& s) {
  to.status = status_of(s.status);
  to.state = state_of(s.state);
  to.evaluations = s.evaluations;
  to.residual = s.residual;
  put(to.reaction, s.reaction);
  put(to.normal, s.normal);
  to.normal_force = s.normal_force;
  put(to.friction_force, s.friction_force);
  put(to.friction_moment, s.friction_moment);
  put(to.slip_velocity, s.slip_velocity);
  to.power = s.power;
  to.reaction_angle = s.reaction_angle();
  to.friction_angle = s.friction_angle();
  to.slip_axis_angle = s.slip_axis_angle();
  to.force_coefficient = s.force_coefficient;
  to.sliding_coefficient = s.sliding_coefficient;
  to.spinning_coefficient = s.spinning_coefficient;
  to.adhesion_number = s.adhesion_number;
  to.load_parameter = s.load_parameter;
  to.half_angle = s.half_angle;
  to.peak_pressure = s.peak_pressure;
  to.contact_area = s.contact_area;
  const Memory memory{s.memory, s.reaction_direction};
  std::memcpy(to.memory, &memory, sizeof to.memory);
}

// What a solution starts from.
JointSolution start_of(const contact_solution* last) {
  JointSolution s;
  if (!last) return s;
  const Memory memory = memory_of(*last);
  s.memory = memory.slip;
  s.reaction_direction = memory.reaction;
  return s;
}

Joint::Slip slip_of(const contact_slip& slip) {
  return {vector(slip.reaction), vector(slip.angular_velocity),
          vector(slip.axis)};
}

// The status; `place` names the function, and the row where there are some.
contact_status reported(contact_status status, std::string_view place) {
  if (status == CONTACT_OK) return status;
  const std::string said = message(
      status == CONTACT_OUT_OF_RANGE
          ? "{}: no solution: numbers must be finite and the contact in "
            "the range of the laws"
          : "{}: not converged",
      place);
  return contact_report(status, said.c_str());
}

// Of solve_rows(): what it reads and writes is there.
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
    const JointSolution s = slips.warm ? joint.solve(slip, last, options)
                                       : joint.solve(slip, options);
    last.memory = s.memory;
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

RestSolution start_of(const contact_rest& last) {
  RestSolution rest;
  rest.utilisation = last.utilisation;
  rest.slip = start_of(&last.slip);
  rest.slip.status =
      last.slip.status == CONTACT_OK ? Status::ok : Status::not_converged;
  return rest;
}

}  // namespace
}  // namespace contact::c

using contact::Joint;
using contact::RestSolution;
using contact::c::call;
using contact::c::given;
using contact::c::put;
using contact::c::reported;
using contact::c::slip_of;
using contact::c::start_of;
using contact::c::vector;

contact_status contact_joint_solve(const contact_joint* joint,
                                   const contact_slip* slip,
                                   const contact_solution* last,
                                   contact_solution* solution) {
  return call([=] {
    const Joint& j = given(joint, "contact_joint_solve: joint").joint;
    const Joint::Slip s = slip_of(given(slip, "contact_joint_solve: slip"));
    put(given(solution, "contact_joint_solve: solution"),
        j.solve(s, start_of(last)));
    return reported(solution->status, "contact_joint_solve");
  });
}

contact_status contact_joint_solve_contact(const contact_joint* joint,
                                           const contact_slip* known,
                                           contact_solution* solution) {
  return call([=] {
    const Joint& j = given(joint, "contact_joint_solve_contact: joint").joint;
    const Joint::Slip s =
        slip_of(given(known, "contact_joint_solve_contact: known"));
    put(given(solution, "contact_joint_solve_contact: solution"),
        j.solve_contact({s.reaction, s.angular_velocity, s.axis}));
    return reported(solution->status, "contact_joint_solve_contact");
  });
}

contact_status contact_joint_solve_rows(const contact_joint* joint,
                                        const contact_slips* slips,
                                        contact_solution* solutions,
                                        std::ptrdiff_t stride) {
  return call([=] {
    const Joint& j = given(joint, "contact_joint_solve_rows: joint").joint;
    contact::c::check(given(slips, "contact_joint_solve_rows: slips"),
                      solutions, stride);
    return contact::c::solve_rows(j, *slips, solutions, stride);
  });
}

contact_status contact_joint_at_rest(const contact_joint* joint,
                                     const contact_hold* hold,
                                     const contact_rest* last,
                                     contact_rest* rest) {
  return call([=] {
    const Joint& j = given(joint, "contact_joint_at_rest: joint").joint;
    const contact_hold& h = given(hold, "contact_joint_at_rest: hold");
    contact_rest& to = given(rest, "contact_joint_at_rest: rest");
    const Joint::Hold holds = {vector(h.reaction), vector(h.moment),
                               vector(h.axis)};
    const RestSolution found =
        last ? j.at_rest(holds, start_of(*last)) : j.at_rest(holds);
    to.status = contact::c::status_of(found.status);
    to.solves = found.solves;
    to.utilisation = found.utilisation;
    put(to.direction, found.direction);
    put(to.slip, found.slip);
    return reported(to.status, "contact_joint_at_rest");
  });
}
