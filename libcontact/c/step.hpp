#pragma once

#include <algorithm>
#include <limits>

#include "libcontact/c/slip.hpp"
#include "libcontact/c/step.h"
#include "libcontact/joint/step.hpp"

namespace contact::c {

/// @param with_rest  whether it rested; else the rest that was told of stays
void tell(contact_step& to, const JointStep& step, bool with_rest);

template <>
struct Refused<contact_step> {
  static void write(contact_step* step, contact_status status) noexcept {
    step->status = status;
    step->holds = 0;
    for (double* numbers : {step->angular_velocity, step->moment}) {
      std::fill_n(numbers, 3, std::numeric_limits<double>::quiet_NaN());
    }
    Refused<contact_solution>::write(&step->solution, status);
    Refused<contact_rest>::write(&step->rest, status);
  }
};

}  // namespace contact::c
