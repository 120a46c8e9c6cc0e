#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "libcontact/pair/joint_geometry.hpp"

namespace contact::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr JointKind kinds[] = {JointKind::ball, JointKind::pin};

/// True if all numbers are NaN; else it reports the first other one.
inline testing::AssertionResult all_nan(std::initializer_list<double> numbers) {
  int place = 0;
  for (const double number : numbers) {
    ++place;
    if (!std::isnan(number)) {
      return testing::AssertionFailure()
             << "number " << place << " is " << number;
    }
  }
  return testing::AssertionSuccess();
}

}  // namespace contact::test
