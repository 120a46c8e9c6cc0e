#pragma once

#include <span>

#include "libcontact/friction/integrals.hpp"

namespace contact::detail {

/// Friction coefficients of a ball by the harmonics of its pressure, for
/// contacts of any size, closed all round included: sums of p_n times the
/// harmonics of |r x w|, by the addition theorem (docs/how-to/interference.md).
/// The truncation error falls like n^-4.
/// @param harmonics  p_n/p_1, n = 0, 1, ...; at least two, at most
///                   max_pressure_harmonics
FrictionTriple coefficients_by_harmonics(std::span<const double> harmonics,
                                         SlipAxis axis);

/// The same for traction in proportion to the speed.
FrictionTriple viscous_by_harmonics(std::span<const double> harmonics,
                                    SlipAxis axis);

inline constexpr int max_pressure_harmonics = 240;

}  // namespace contact::detail
