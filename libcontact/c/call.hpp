#pragma once

#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/c/float_environment.hpp"
#include "libcontact/c/status.h"
#include "libcontact/files/setting.hpp"

/// Boundary of the C interface: no C++ exception gets out, and
/// contact_last_message() describes the failure. The floating-point environment
/// is the host's again.
namespace contact::c {

/// Keeps the message of the exception that is being handled; the status.
contact_status report_exception() noexcept;

/// Calls `work` and returns its status.
template <class Work>
contact_status call(const Work& work) noexcept {
  try {
    const FloatEnvironment ours;
    return work();
  } catch (...) {
    return report_exception();
  }
}

/// Base of the objects that C holds. Builds with assertions know which of them
/// have been freed: a call with another pointer is refused, where it would end
/// the program.
class Handle {
 public:
#ifdef NDEBUG
 protected:
  Handle() = default;
  ~Handle() = default;
};
inline bool is_freed(const void* /*handle*/) { return false; }
#else
 protected:
  Handle();
  Handle(const Handle& /*other*/) : Handle() {}
  Handle& operator=(const Handle&) = delete;
  ~Handle();
};
bool is_freed(const void* handle);
#endif

/// Object that a pointer points to.
/// @param name  "contact_joint_solve: slip"
/// @throws Error if it is null, or a handle that has been freed
template <class Value>
Value& given(Value* pointer, const char* name) {
  if (!pointer) throw Error(detail::must_be(name, "other than NULL"));
  if constexpr (requires { requires std::is_base_of_v<Handle, Value>; }) {
    if (is_freed(pointer)) {
      throw Error(detail::must_be(name, "one that has not been freed"));
    }
  }
  return *pointer;
}

/// Gives a handle back; null and freed ones are left alone.
template <class Object>
void give_back(Object* handle) noexcept {
  if (handle && !is_freed(handle)) delete handle;
}

/// @throws Error if a pointer is null
KeySettings settings_of(const contact_setting* settings, std::size_t count,
                        const std::string& function);

/// Results that a refused call leaves without values: all numbers are NaN.
template <class Result>
struct Refused {
  static void write(Result* result, contact_status /*status*/) noexcept {
    static_assert(sizeof(Result) % sizeof(double) == 0);
    std::array<double, sizeof(Result) / sizeof(double)> none;
    none.fill(std::numeric_limits<double>::quiet_NaN());
    std::memcpy(result, none.data(), sizeof none);
  }
};

/// The same for a function that has results: where it is refused or fails, they
/// say so. Null pointers are left out.
template <class Work, class... Result>
contact_status call_for(const Work& work, Result*... results) noexcept {
  const contact_status status = call(work);
  if (status == CONTACT_BAD_INPUT || status == CONTACT_FAILURE) {
    ((results ? Refused<Result>::write(results, status) : void()), ...);
  }
  return status;
}

/// Puts sentences into a text of C, one per line, cut to `size` with its 0.
contact_status hand_over_notes(const std::vector<std::string>& notes,
                               char* text, std::size_t size);

/// Place of a new object: NULL until it is there.
template <class Object>
Object** emptied(Object** to, const char* name) {
  given(to, name) = nullptr;
  return to;
}

/// Hands a new object over to C.
template <class Object, class... Arguments>
contact_status hand_over(Object** to, Arguments&&... arguments) {
  *to = new Object{std::forward<Arguments>(arguments)...};
  return CONTACT_OK;
}

}  // namespace contact::c
