#include "libcontact/base/check.hpp"

#include <fmt/format.h>

#include "libcontact/base/error.hpp"

namespace contact::detail {

void require(bool valid, std::string_view place, std::string_view name,
             double value, std::string_view allowed) {
  if (valid) return;
  throw Error(
      fmt::format("{}: {} = {}: allowed: {}", place, name, value, allowed));
}

}  // namespace contact::detail
