#pragma once

namespace contact {

/// sigma_Y of a ball that turns about an axis across its load, a = 0, in a seat
/// that this has worn to a steady shape. p v is proportional to cos theta then,
/// p to cos theta/w with the slip w = |Dw x r|/|Dw|, and
///
///     sigma_Y = 2 pi sin^2 theta0/(J[1] + cos theta0 I[1]),  J, I of a = 0.
///
/// WornPressure leaves w out; its sigma_Y is up to 0.41 % too large.
///
/// @param half_angle  theta0, rad, [0, pi/2]; NaN outside
/// @return 1 at 0, 4/pi at pi/2; relative error at most 1e-11
///         (duty/wear_in_test.cpp).
double worn_in_sliding_coefficient(double half_angle);

}  // namespace contact
