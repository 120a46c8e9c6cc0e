#include "cli/joint/shipped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_depth.hpp"
#include "libcontact/files/named_file.hpp"
#include "libcontact/files/toml_nodes.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(Shipped kind) {
  constexpr std::array<const char*, 3> names = {"joints", "materials",
                                                "backings"};
  return contact::detail::shipped_data() /
         names[static_cast<std::size_t>(kind)];
}

}  // namespace

void find_shipped() {
  std::error_code none;
  const fs::path programs =
      fs::read_symlink("/proc/self/exe", none).parent_path();
  if (none) return;
  // Relative to an installation, and to a build directory of the source tree.
  for (const char* data : {"../share/libcontact", "../../data"}) {
    if (!fs::is_directory(programs / data / "joints", none)) continue;
    contact::detail::shipped_data() = (programs / data).lexically_normal();
    return;
  }
}

std::vector<std::string> shipped_names(Shipped kind) {
  std::vector<std::string> names;
  if (contact::detail::shipped_data().empty()) return names;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(folder_of(kind), none)) {
    if (file.path().extension() == ".toml") {
      names.push_back(file.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::string shipped_file(Shipped kind, const std::string& name) {
  if (name.empty() || name.find_first_of("./\\") != name.npos) return name;
  std::error_code none;
  if (fs::exists(name, none)) return name;
  const auto all = shipped_names(kind);
  if (std::ranges::find(all, name) == all.end()) return name;
  const fs::path file = folder_of(kind) / (name + ".toml");
  const fs::path near = file.lexically_proximate(fs::current_path(none));
  return near.native().size() < file.native().size() ? near : file;
}

std::string shipped_hint(Shipped kind, std::string_view name,
                         std::vector<std::string> words) {
  const auto shipped = shipped_names(kind);
  std::ranges::copy(shipped, std::back_inserter(words));
  std::string meant = contact::detail::nearest(name, words);
  // steel of carbon_steel
  const auto part = std::ranges::find_if(
      shipped, [&](const std::string& of) { return of.find(name) != of.npos; });
  if (meant.empty() && part != shipped.end()) meant = *part;
  return contact::detail::did_you_mean(meant);
}

std::string_view kind_of_file(const std::string& file) {
  // Keys that only one kind of file has.
  constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"kind", "a joint file"},        {"body", "a case file"},
      {"carrier", "a case file"},      {"dispersion", "a study file"},
      {"requirement", "a study file"},
  };
  const std::string text = contact::detail::file_text(file);
  if (contact::detail::line_of_deep_key(text) > 0) return {};
  try {
    const toml::table root = toml::parse(text);
    for (const auto& [key, kind] : kinds) {
      if (root.contains(key)) return kind;
    }
  } catch (const toml::parse_error&) {
  }
  return {};
}

void refuse_other_file(std::string_view program, const std::string& file,
                       std::string_view wanted) {
  const std::string_view kind = kind_of_file(file);
  if (kind.empty() || kind == wanted) return;
  throw contact::Error(
      fmt::format("{} is {}; {} takes {}", file, kind, program, wanted));
}

}  // namespace cli
