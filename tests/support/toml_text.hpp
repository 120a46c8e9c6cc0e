#pragma once

#include <cstddef>
#include <string>

namespace contact::test {

/// TOML with several lines in one: "; " ends a line like a newline, so that a
/// case fits on a line and messages still count lines of TOML.
inline std::string operator""_toml(const char* text, std::size_t size) {
  std::string lines(text, size);
  for (auto at = lines.find("; "); at != lines.npos; at = lines.find("; ")) {
    lines.replace(at, 2, "\n");
  }
  return lines;
}

}  // namespace contact::test
