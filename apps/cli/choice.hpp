#pragma once

#include <span>
#include <string>
#include <string_view>

#include "libcontact/base/error.hpp"

namespace cli {

/// One of the words that an option takes, and what it stands for.
template <class T>
struct Choice {
  std::string_view name;
  T value;
};

/// What `word` stands for. Throws contact::Error with the allowed words:
/// "--format xml: allowed csv, json, markdown, latex".
template <class Choices>
auto choice(std::string_view option, std::string_view word,
            const Choices& choices) {
  std::string names;
  for (const auto& item : choices) {
    if (item.name == word) return item.value;
    names += names.empty() ? " " : ", ";
    names += item.name;
  }
  throw contact::Error(std::string(option) + ' ' + std::string(word) +
                       ": allowed" + names);
}

}  // namespace cli
