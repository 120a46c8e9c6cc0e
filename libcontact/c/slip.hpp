#pragma once

#include <string_view>

#include "libcontact/c/call.hpp"
#include "libcontact/c/slip.h"
#include "libcontact/joint/joint.hpp"

namespace contact::c {

template <>
struct Refused<contact_solution> {
  static void write(contact_solution* s, contact_status status) noexcept;
};
template <>
struct Refused<contact_rest> {
  static void write(contact_rest* rest, contact_status status) noexcept;
};

/// C++ results from those of C, to the last bit.
JointSolution solution_of(const contact_solution& solution);
Joint::Slip slip_of(const contact_slip& slip);
/// The solution of a joint with the contact at a rim of its seat, which C does
/// not keep, found anew.
JointSolution whole(const Joint& joint, const contact_solution& solution);
RestSolution rest_of(const contact_rest& rest);
contact_status status_of(Status status);
Status cpp_status(contact_status status);

/// C results from those of C++.
void put(contact_solution& to, const JointSolution& solution);
void put(contact_rest& to, const RestSolution& rest);

/// The status, with a message if it is not OK.
/// @param place  names the function, and the row where there are some
contact_status reported(contact_status status, std::string_view place);
/// The same of a solution, whose joint knows why there is none.
contact_status reported(const Joint& joint, const JointSolution& solution,
                        std::string_view place);

}  // namespace contact::c
