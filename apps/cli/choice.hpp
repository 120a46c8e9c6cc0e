#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {

/// A word that an option accepts, and its value.
template <class T>
struct Choice {
  std::string_view name;
  T value;
};

/// Value of `word`. Throws contact::Error with the accepted words: `unknown
/// format "xml" (csv, json, markdown, latex)` for --format.
template <class Choices>
auto choice(std::string_view option, std::string_view word,
            const Choices& choices) {
  std::vector<std::string> names;
  for (const auto& item : choices) {
    if (item.name == word) return item.value;
    names.emplace_back(item.name);
  }
  throw contact::Error(contact::detail::unknown(option.substr(2), word, names));
}

}  // namespace cli
