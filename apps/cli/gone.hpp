#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

/// Removed options, and their replacements.
namespace cli {

struct GoneOption {
  std::string_view program;
  std::string_view flag;
  std::string_view instead;
};

inline constexpr GoneOption gone_options[] = {
    {"hinge-joint", "--in-seat",
     "the [seat] of a joint file confines its contact by default; "
     "--without-seat extends the contact beyond the rims"},
    {"hinge-duty", "--in-seat",
     "the [seat] of a joint file confines its contact by default, and --states "
     "FILE has its rows; --without-seat extends the contact beyond the rims"},
    {"hinge-duty", "--pin-states", "--states FILE lists the position of a pin"},
};

/// "--in-seat is gone: ..."; "" if no word is a removed option.
inline std::string gone_option(std::string_view program,
                               std::string_view word) {
  const std::string_view flag = word.substr(0, word.find('='));
  for (const GoneOption& each : gone_options) {
    if (each.program == program && each.flag == flag) {
      return fmt::format("{} is gone: {}", each.flag, each.instead);
    }
  }
  return {};
}

}  // namespace cli
