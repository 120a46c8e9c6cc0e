#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {

/// "--radius 50mm": an option and its value.
inline std::string given(std::string_view option, std::string_view text) {
  return fmt::format("{} {}", option, text.empty() ? "''" : text);
}

/// Throws contact::Error "OPTION TEXT must be RULE".
[[noreturn]] inline void refuse(std::string_view option, std::string_view text,
                                std::string_view rule) {
  throw contact::Error(contact::detail::must_be(given(option, text), rule));
}

/// Throws contact::Error "WHAT requires OTHER".
[[noreturn]] inline void refuse_without(std::string_view what,
                                        std::string_view other) {
  throw contact::Error(contact::detail::needs(what, other));
}

/// Throws contact::Error "WHAT conflicts with OTHER".
[[noreturn]] inline void refuse_beside(std::string_view what,
                                       std::string_view other) {
  throw contact::Error(contact::detail::conflicts(what, other));
}

}  // namespace cli
