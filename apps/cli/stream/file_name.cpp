#include "cli/stream/file_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {

bool ends_in(std::string_view name, std::string_view ending) {
  const auto small = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  return name.size() >= ending.size() &&
         std::ranges::equal(name.substr(name.size() - ending.size()), ending,
                            {}, small, small);
}

bool is_hdf5(std::string_view name) {
  return ends_in(name, ".h5") || ends_in(name, ".hdf5");
}

bool is_page(std::string_view name) { return ends_in(name, ".html"); }

void check_ending(std::string_view option, const std::string& name,
                  const std::vector<std::string_view>& endings,
                  std::string_view words) {
  std::error_code ignored;
  const bool pipe = std::filesystem::exists(name, ignored) &&
                    !std::filesystem::is_regular_file(name, ignored);
  if (name == "-" || pipe) return;
  for (const std::string_view ending : endings) {
    if (ends_in(name, ending)) return;
  }
  throw contact::Error(
      contact::detail::must_be(fmt::format("{} {}", option, name),
                               fmt::format("a name that ends in {}", words)));
}

}  // namespace cli
