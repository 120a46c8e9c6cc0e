#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/choice.hpp"
#include "cli/quantity.hpp"

namespace cli {

/// Takes the text of an option, or refuses it.
using Reader = std::function<void(const std::string&)>;
/// Several texts, the option given once for each.
using Texts = std::vector<std::string>;
/// The same of one option: with commas between them.
struct List {
  Texts* texts;
  char separator = ',';  ///< 0: arguments of their own
};

/// An option: a row of a table.
struct Option {
  /// "--radius"; without -- an argument, which has to be there.
  const char* flag;
  /// Target of the option's text; true for a flag, which has none.
  std::variant<std::string*, bool*, Texts*, List, Reader> target;
  const char* kind;  ///< kind of text, for --help: "LENGTH"; "" for none
  const char* meaning;
  /// Options, at least one of them required too, in words: "--shaft", "--radius
  /// or --diameter"; several such conditions have a ; between them.
  std::string_view needs = {};
  /// Options with which it conflicts, in words.
  std::string_view excludes = {};
  bool required = false;
};

/// A number of a kind and an interval, in degrees or SI units.
template <class Target>
Reader number(const char* flag, Target& target, contact::Dimension dimension,
              const Allowed& allowed) {
  return [flag, &target, dimension, allowed](const std::string& text) {
    target = parse_quantity(flag, text, dimension, allowed);
  };
}

/// A whole number.
template <class Target>
Reader count(const char* flag, Target& target, int min, int max) {
  return [flag, &target, min, max](const std::string& text) {
    target = parse_count(flag, text, min, max);
  };
}

/// One of some words.
template <class Target, class Choices>
Reader word(const char* flag, Target& target, const Choices& choices) {
  return [flag, &target, choices](const std::string& text) {
    target = choice(flag, text, choices);
  };
}

}  // namespace cli
