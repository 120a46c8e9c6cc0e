#include "cli/output_names.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/files_in_use.hpp"
#include "cli/output.hpp"
#include "cli/refuse.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// Canonical path of a file; "" if it may have several writers.
std::string place_of(const std::string& name) {
  std::error_code ignored;
  if (name == "-") {
    constexpr const char* standard = "/dev/stdout";
    return fs::is_regular_file(standard, ignored)
               ? destination(standard).string()
               : name;
  }
  if (fs::exists(name, ignored) && !fs::is_regular_file(name, ignored)) {
    return {};
  }
  return destination(name).string();
}

}  // namespace

void OutputNames::keep(std::string_view option, const std::string& name) {
  if (name.empty()) return;
  const std::string to = place_of(name);
  if (to.empty()) return;
  const auto [place, is_new] = options_.emplace(to, option);
  if (is_new) return;
  refuse(option, name, "another file than " + place->second);
}

void OutputNames::add(std::string_view option, const std::string& name) {
  if (name.empty()) return;
  keep(option, name);
  will_write(option, name);
  Output::check(name);
}

}  // namespace cli
