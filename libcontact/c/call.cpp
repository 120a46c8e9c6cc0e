#include "libcontact/c/call.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <new>
#include <set>

#include "libcontact/base/text.hpp"

namespace contact::c {
contact_status report_exception() noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return contact_report(CONTACT_BAD_INPUT, error.what());
  } catch (const std::bad_alloc&) {
    return contact_report(CONTACT_FAILURE, "out of memory");
  } catch (const std::exception& error) {
    return contact_report(CONTACT_FAILURE, error.what());
  } catch (...) {
    return contact_report(CONTACT_FAILURE, "an error that is not known");
  }
}

#ifndef NDEBUG
namespace {

std::mutex of_handles;
std::set<const void*>& handles() {
  static std::set<const void*> all;
  return all;
}

}  // namespace

Handle::Handle() {
  const std::lock_guard lock(of_handles);
  handles().insert(this);
}
Handle::~Handle() {
  const std::lock_guard lock(of_handles);
  handles().erase(this);
}
bool is_freed(const void* handle) {
  const std::lock_guard lock(of_handles);
  return !handles().contains(handle);
}
#endif

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

contact_status hand_over_notes(const std::vector<std::string>& notes,
                               char* text, std::size_t size) {
  if (size == 0) return CONTACT_OK;
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    lines.push_back(detail::printable(note, note.npos));
  }
  const std::string all = detail::joined(lines, "\n");
  const std::size_t length = std::min(all.size(), size - 1);
  std::copy_n(all.data(), length, text);
  text[length] = 0;
  return CONTACT_OK;
}

}  // namespace contact::c
