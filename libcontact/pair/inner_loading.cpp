#include "libcontact/pair/inner_loading.hpp"

#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"

namespace contact {

InnerLoading InnerLoading::centre() { return {false, 0}; }

InnerLoading InnerLoading::back(double patch_half_angle) {
  detail::require(
      patch_half_angle >= 0 && patch_half_angle <= std::numbers::pi / 2,
      "loading through the back", "patch_half_angle", patch_half_angle,
      "0 to pi/2 rad");
  return {true, patch_half_angle};
}

std::string to_string(const InnerLoading& loading) {
  if (!loading.is_back()) return "centre";
  return detail::message("back:{:.6g}", loading.patch_half_angle() / degree);
}

}  // namespace contact
