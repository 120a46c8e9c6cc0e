// Files of the page, which has no disk: the material pairs that joint files
// name lie in the engine, and file_text() here takes the place of the
// library's.
#include <algorithm>
#include <iterator>
#include <string_view>

#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"

namespace contact::detail {
namespace {

struct Shelved {
  std::string_view path;
  std::string_view text;
};

constexpr Shelved shelf[] = {
#include "shelf.inc"
};

}  // namespace

std::string file_text(const std::filesystem::path& file) {
  const std::string path = file.lexically_normal().string();
  const auto found =
      std::find_if(std::begin(shelf), std::end(shelf),
                   [&](const auto& s) { return s.path == path; });
  if (found == std::end(shelf)) {
    constexpr std::size_t longest = 4096;
    throw Error(message("{}: cannot be read: No such file or directory",
                        printable(file.string(), longest)));
  }
  return std::string(found->text);
}

void watch_reading(ReadWatcher) {}
void tell_reading(const std::filesystem::path&) {}

}  // namespace contact::detail
