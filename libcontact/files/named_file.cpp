#include "libcontact/files/named_file.hpp"

#include <system_error>

namespace contact::detail {

namespace fs = std::filesystem;

fs::path& shipped_data() {
  static fs::path& folder = *new fs::path;
  return folder;
}

fs::path named_file(const fs::path& folder, std::string_view key,
                    const std::string& name) {
  const fs::path file = folder / name;
  std::error_code none;
  if (name.find_first_of("./\\") != name.npos || shipped_data().empty() ||
      fs::exists(file, none)) {
    return file;
  }
  const fs::path shipped = shipped_data() /
                           (key == "pair" ? "materials" : "joints") /
                           (name + ".toml");
  return fs::exists(shipped, none) ? shipped : file;
}

}  // namespace contact::detail
