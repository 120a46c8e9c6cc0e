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
     "a joint with a [seat] is in it; --without-seat for the endless one"},
    {"hinge-duty", "--in-seat",
     "a joint with a [seat] is in it, and its rows are in --states FILE; "
     "--without-seat for the endless one"},
    {"hinge-duty", "--pin-states", "--states FILE has how a pin lies"},
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
