#include "libcontact/c/status.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "libcontact/version.hpp"

namespace {

// It has no destructor and no memory of its own, so that it can say that memory
// ran out. Longer messages are cut.
thread_local std::array<char, 2048> last_message = {};

}  // namespace

contact_status contact_report(contact_status status, const char* message) {
  const auto part = std::string_view(message ? message : "")
                        .substr(0, last_message.size() - 1);
  *std::copy(part.begin(), part.end(), last_message.begin()) = '\0';
  return status;
}

const char* contact_version() { return contact::version; }

const char* contact_last_message() { return last_message.data(); }
