#include "libcontact/base/check.hpp"

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {

void require(bool valid, std::string_view place, std::string_view name,
             double value, std::string_view allowed) {
  if (valid) return;
  throw Error(
      detail::message("{}: {} = {}: allowed: {}", place, name, value, allowed));
}

}  // namespace contact::detail
