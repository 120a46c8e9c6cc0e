// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace contact {

/// One degree in radians. Inside the library every angle is in radians;
/// degrees live in command lines, tables and plots only.
inline constexpr double degree = std::numbers::pi / 180;

/// Sine and cosine of one angle.
struct SineCosine {
  double sin;
  double cos;
};

namespace detail {

/// Sine and cosine of an angle given in degrees, both to full relative
/// accuracy: the angle is reduced exactly in degrees before it is converted,
/// so cos(90 - x) is as accurate as sin(x), and sin and cos of multiples of
/// 90 degrees are exact.
///
/// @param angle_deg  angle, degrees, any finite value; NaN gives NaN.
/// @return sine and cosine; relative error at most 4e-16 each
///         (base/units_test.cpp, against 50-digit arithmetic).
SineCosine sine_cosine_deg(double angle_deg);

}  // namespace detail
}  // namespace contact
