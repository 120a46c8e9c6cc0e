#pragma once

#include <cmath>
#include <string_view>

namespace contact::detail {

/// Throws contact::Error "PLACE: NAME = VALUE must be RULE" unless
/// `valid`. Write `valid` so that NaN makes it false.
void require(bool valid, std::string_view place, std::string_view name,
             double value, std::string_view rule);

/// 0 or above, not infinite.
inline bool is_not_negative(double x) { return x >= 0 && std::isfinite(x); }
/// Above 0, not infinite.
inline bool is_above_zero(double x) { return x > 0 && std::isfinite(x); }

}  // namespace contact::detail
