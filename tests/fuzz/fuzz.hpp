#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "libcontact/base/error.hpp"

/// Helpers of the fuzz programs.
namespace contact::test {

inline void check(bool holds) {
  if (!holds) std::abort();
}

/// Calls `read`, which must return a usable result or throw contact::Error with
/// a single-line message that begins with this text.
template <class Read>
void read_or_one_line(const Read& read, const std::string& start) {
  try {
    read();
  } catch (const contact::Error& error) {
    const std::string message = error.what();
    check(message.starts_with(start));
    check(message.find_first_of("\n\r") == message.npos);
  }
}

/// A file rewritten with every input, for readers of files.
inline std::string written(std::string_view text, const std::string& ending) {
  static const std::filesystem::path folder = [] {
    std::string name =
        (std::filesystem::temp_directory_path() / "contact_fuzz_XXXXXX")
            .string();
    check(mkdtemp(name.data()) != nullptr);
    return std::filesystem::path(name);
  }();
  const std::string path = (folder / ("input" + ending)).string();
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  return path;
}

}  // namespace contact::test
