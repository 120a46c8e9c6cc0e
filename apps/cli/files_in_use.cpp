#include "cli/files_in_use.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>

#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// File names keyed by canonical path.
using Names = std::map<fs::path, std::string>;

struct FilesInUse {
  std::mutex mutex;  // threads of a program read files
  Names inputs;
  Names outputs;  // with their options
};

FilesInUse& files() {
  static FilesInUse all;
  return all;
}

// Finds the same file among others; null if there is none.
const std::string* find(const fs::path& file, const Names& others) {
  for (const auto& [path, name] : others) {
    std::error_code ignored;
    if (path == file || fs::equivalent(path, file, ignored)) return &name;
  }
  return nullptr;
}

void refuse(const std::string& output, const std::string& input) {
  throw contact::Error(contact::detail::must_be(
      output, fmt::format("another file than {}, which is read", input)));
}

void note_input(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return;
  const fs::path input = destination(file);
  const std::string name =
      file == "/dev/stdin" ? "standard input" : file.string();
  const std::lock_guard lock(files().mutex);
  if (const auto* output = find(input, files().outputs)) {
    refuse(*output, name);
  }
  files().inputs.emplace(input, name);
}

}  // namespace

fs::path destination(const fs::path& name) {
  std::error_code ignored;
  // Relative names of missing files would otherwise stay relative.
  const fs::path path =
      fs::weakly_canonical(fs::absolute(name, ignored), ignored);
  return path.empty() ? name : path;
}

void note_reading() { contact::detail::watch_reading(note_input); }

void will_write(std::string_view option, const std::string& name) {
  if (name.empty() || name == "-") return;
  const fs::path output = destination(name);
  const std::string shown = given(option, name);
  const std::lock_guard lock(files().mutex);
  if (const auto* input = find(output, files().inputs)) refuse(shown, *input);
  files().outputs.emplace(output, shown);
}

void check_unread(const fs::path& name) {
  const fs::path output = destination(name);
  const std::lock_guard lock(files().mutex);
  if (const auto* input = find(output, files().inputs)) {
    refuse(name.string(), *input);
  }
}

}  // namespace cli
