#include "cli/file_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace cli {

namespace fs = std::filesystem;

std::string file_text(const std::string& file) {
  const auto refuse = [&file](const std::string& why) {
    throw contact::Error(fmt::format(
        "{}: cannot be read: {}", contact::detail::printable(file, 4096), why));
  };
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) refuse(error.message());
  if (fs::is_directory(status)) refuse("a directory");
  // A device could be endless.
  if (!fs::is_regular_file(status) && !fs::is_fifo(status)) {
    refuse("not a file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) refuse(std::strerror(errno));
  return text;
}

}  // namespace cli
