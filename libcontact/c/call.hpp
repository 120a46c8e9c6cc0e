#pragma once

#include <string>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/c/status.h"
#include "libcontact/files/setting.hpp"

/// What every function of the C interface does: nothing of C++ gets out, and
/// contact_last_message() says what has failed.
namespace contact::c {

/// Keeps the message of the exception that is being handled; the status.
contact_status report_exception() noexcept;

/// Calls `work`, whose status is that of the function.
template <class Work>
contact_status call(const Work& work) noexcept {
  try {
    return work();
  } catch (...) {
    return report_exception();
  }
}

/// What a pointer points to.
/// @param name  "contact_joint_solve: slip"
/// @throws Error if it is null
template <class Value>
Value& given(Value* pointer, const char* name) {
  if (!pointer) throw Error(detail::must_be(name, "other than NULL"));
  return *pointer;
}

/// @throws Error if a pointer is null
KeySettings settings_of(const contact_setting* settings, std::size_t count,
                        const std::string& function);

/// Hands a new object over to C.
template <class Object, class... Arguments>
contact_status hand_over(Object** to, Arguments&&... arguments) {
  *to = new Object{std::forward<Arguments>(arguments)...};
  return CONTACT_OK;
}

}  // namespace contact::c
