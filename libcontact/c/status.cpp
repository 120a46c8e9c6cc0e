#include "libcontact/c/status.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "libcontact/base/text.hpp"
#include "libcontact/version.hpp"

namespace {

// It has no destructor and no memory of its own, so that it can say that memory
// ran out. Longer messages are cut.
thread_local std::array<char, 2048> last_message = {};

void keep(std::string_view message) {
  const auto part = message.substr(0, last_message.size() - 1);
  *std::copy(part.begin(), part.end(), last_message.begin()) = '\0';
}

}  // namespace

// Files name bodies by any characters: none of them speaks to a terminal.
contact_status contact_report(contact_status status, const char* message) {
  const std::string_view text = message ? message : "";
  if (!contact::detail::has_control_characters(text)) {
    keep(text);
    return status;
  }
  try {
    keep(contact::detail::printable(text, text.npos));
  } catch (const std::exception&) {
    keep("out of memory");
  }
  return status;
}

const char* contact_version() { return contact::version; }

const char* contact_last_message() { return last_message.data(); }
