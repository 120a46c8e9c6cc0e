#include "libcontact/base/file_text.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {
namespace {

namespace fs = std::filesystem;

std::atomic<ReadWatcher> the_watcher = nullptr;

}  // namespace

std::string file_text(const fs::path& file) {
  const auto refuse = [&file](const std::string& why) {
    constexpr std::size_t longest = 4096;
    throw Error(message("{}: cannot be read: {}",
                        printable(file.string(), longest), why));
  };
  if (has_control_characters(file.string())) {
    refuse("its name has control characters");
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) refuse(error.message());
  if (fs::is_directory(status)) refuse("a directory");
  // A device could be endless.
  if (!fs::is_regular_file(status) && !fs::is_fifo(status)) {
    refuse("not a file");
  }
  tell_reading(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  // By read(), which says of a device that fails what an iterator would throw
  // without the name of the file.
  std::string text;
  std::array<char, 1 << 16> part;
  do {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) refuse(std::strerror(errno));
  return text;
}

void watch_reading(ReadWatcher watcher) { the_watcher = watcher; }

void tell_reading(const fs::path& file) {
  if (const ReadWatcher watcher = the_watcher) watcher(file);
}

}  // namespace contact::detail
