#include "cli/output_names.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/output.hpp"
#include "cli/refuse.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// Where a name leads; "" for what may have several names or readers.
std::string destination(const std::string& name) {
  if (name == "-") return name;
  std::error_code ignored;
  if (fs::exists(name, ignored) && !fs::is_regular_file(name, ignored)) {
    return {};
  }
  // Relative names of files that are not there stay relative otherwise.
  const auto path = fs::weakly_canonical(fs::absolute(name, ignored), ignored);
  return path.empty() ? name : path.string();
}

}  // namespace

void OutputNames::keep(std::string_view option, const std::string& name) {
  if (name.empty()) return;
  const std::string to = destination(name);
  if (to.empty()) return;
  const auto [place, is_new] = options_.emplace(to, option);
  if (is_new) return;
  refuse(option, name, "another file than that of " + place->second);
}

void OutputNames::add(std::string_view option, const std::string& name) {
  if (name.empty()) return;
  keep(option, name);
  Output::check(name);
}

bool same_file(const std::string& one, const std::string& other) {
  return destination(one) == destination(other);
}

}  // namespace cli
