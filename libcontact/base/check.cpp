#include "libcontact/base/check.hpp"

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {

void require(bool valid, std::string_view place, std::string_view name,
             double value, std::string_view rule) {
  if (valid) return;
  throw Error(must_be(message("{}: {} = {}", place, name, value), rule));
}

}  // namespace contact::detail
