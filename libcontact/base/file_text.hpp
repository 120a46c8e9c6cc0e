#pragma once

#include <filesystem>
#include <string>

namespace contact::detail {

/// The bytes of a file or pipe.
/// @throws Error "FILE: cannot be read: REASON"
std::string file_text(const std::filesystem::path& file);

/// A program that watches what it reads, so that it does not write over it, is
/// told of each file before its first byte is read. It may throw.
using ReadWatcher = void (*)(const std::filesystem::path& file);
void watch_reading(ReadWatcher watcher);

/// Tells the watcher, if there is one; file_text() does so itself.
void tell_reading(const std::filesystem::path& file);

}  // namespace contact::detail
