#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/choice.hpp"
#include "cli/quantity.hpp"

namespace cli {

/// Takes the text of an option, or rejects it.
using Reader = std::function<void(const std::string&)>;
/// Several texts; the option may be repeated.
using Texts = std::vector<std::string>;
/// Several texts in one option, separated by commas.
struct List {
  Texts* texts;
  char separator = ',';  ///< 0: separate arguments
};

/// An option: a row of a table.
struct Option {
  /// "--radius"; without dashes a required argument.
  const char* flag;
  /// Receives the option's text; a bool is set to true by a flag without text.
  std::variant<std::string*, bool*, Texts*, List, Reader> target;
  const char* kind;  ///< kind of text, for --help: "LENGTH"; "" for none
  const char* meaning;
  /// Other options, at least one of which is also required, in words: "--shaft,
  /// --radius or --diameter". Several such conditions are separated by
  /// semicolons.
  std::string_view needs = {};
  /// Conflicting options, in words.
  std::string_view excludes = {};
  bool required = false;
};

/// A number of one kind within an interval, in degrees or SI units.
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

/// One of a set of words.
template <class Target, class Choices>
Reader word(const char* flag, Target& target, const Choices& choices) {
  return [flag, &target, choices](const std::string& text) {
    target = choice(flag, text, choices);
  };
}

}  // namespace cli
