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

/// Converts C results to C++, bit-identically.
JointSolution solution_of(const contact_solution& solution);
Joint::Slip slip_of(const contact_slip& slip);
/// A solution with its contact: C does not keep one at a rim of the seat, which
/// is found anew.
JointSolution whole(const Joint& joint, const contact_solution& solution);
RestSolution rest_of(const contact_rest& rest);
contact_status status_of(Status status);
Status cpp_status(contact_status status);

/// Converts C++ results to C.
void put(contact_solution& to, const JointSolution& solution);
void put(contact_rest& to, const RestSolution& rest);

/// The status, with a message if it is not OK.
/// @param place  names the function, and the row where there are some
contact_status reported(contact_status status, std::string_view place);
/// The status of a solution; if there is none the joint says why.
contact_status reported(const Joint& joint, const JointSolution& solution,
                        std::string_view place);

}  // namespace contact::c
