#include "libcontact/c/call.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <new>

#include "libcontact/version.hpp"

namespace contact::c {
namespace {

// Without a destructor and without memory of its own, so that it can be said
// that there is none. Longer messages are cut.
thread_local std::array<char, 2048> last_message = {};

}  // namespace

contact_status report(contact_status status,
                      std::string_view message) noexcept {
  const auto part = message.substr(0, last_message.size() - 1);
  *std::copy(part.begin(), part.end(), last_message.begin()) = '\0';
  return status;
}

contact_status report_exception() noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return report(CONTACT_BAD_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return report(CONTACT_FAILURE, "out of memory");
  } catch (const std::exception& error) {
    return report(CONTACT_FAILURE, error.what());
  } catch (...) {
    return report(CONTACT_FAILURE, "an error that is not known");
  }
}

KeySettings settings_of(const contact_setting* settings, std::size_t count,
                        const std::string& function) {
  KeySettings result;
  if (count > 0) given(settings, (function + ": settings").c_str());
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name =
        function + ": settings[" + std::to_string(i) + "].";
    result.push_back({&given(settings[i].key, (name + "key").c_str()),
                      &given(settings[i].value, (name + "value").c_str())});
  }
  return result;
}

}  // namespace contact::c

const char* contact_version() { return contact::version; }

const char* contact_last_message() { return contact::c::last_message.data(); }
