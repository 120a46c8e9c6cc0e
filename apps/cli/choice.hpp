#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {

/// One of the words that an option takes, and its value.
template <class T>
struct Choice {
  std::string_view name;
  T value;
};

/// Value of `word`. Throws contact::Error with the words that are known:
/// `unknown format "xml" (csv, json, markdown, latex)`, of --format.
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
