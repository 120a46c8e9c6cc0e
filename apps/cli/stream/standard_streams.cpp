#include "cli/stream/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "libcontact/base/error.hpp"

namespace cli {

void open_missing_streams() {
  // Standard input is opened write-only, output read-only, so that their use
  // fails.
  constexpr std::array<std::pair<int, int>, 3> streams = {
      {{STDIN_FILENO, O_WRONLY},
       {STDOUT_FILENO, O_RDONLY},
       {STDERR_FILENO, O_WRONLY}}};
  for (const auto& [descriptor, mode] : streams) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    // open() returns the lowest free descriptor, which is this one.
    if (open("/dev/null", mode) >= 0) continue;
    throw contact::Error(
        fmt::format("cannot open /dev/null: {}", std::strerror(errno)));
  }
}

void say(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace cli
