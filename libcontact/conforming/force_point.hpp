#pragma once

#include "libcontact/pair/inner_loading.hpp"

namespace contact {

/// One point of a contact's force law, by one solution.
struct ForcePoint {
  double reciprocal_load;  ///< 1/mu (ball) or 1/lambda (pin)
  ContactApproach approach;
  /// S - 1: the sum of the pressures over the load less 1. It keeps a relative
  /// accuracy of its own where theta0 is small.
  double excess;
};

}  // namespace contact
