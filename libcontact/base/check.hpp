#pragma once

#include <string_view>

namespace contact::detail {

/// Throws contact::Error "PLACE: NAME = VALUE must be RULE" unless
/// `valid`. Write `valid` so that NaN makes it false.
void require(bool valid, std::string_view place, std::string_view name,
             double value, std::string_view rule);

}  // namespace contact::detail
