#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/load_law/languages.hpp"

/// Formulas that are compiled here and printed in other languages, so that what
/// is measured is what is printed. They are macros, in the part of C++ that all
/// languages have: `a = EXPRESSION;`, `a = CONDITION ? x : y;`,
/// `for (int i = 0; i < count; ++i) { ... }` and in it `if (CONDITION) break;`.
/// Numbers in them are whole ones; others are constants with a name.
#define CONTACT_TEXT_OF(...) CONTACT_TEXT_OF_EXPANDED(__VA_ARGS__)
#define CONTACT_TEXT_OF_EXPANDED(...) #__VA_ARGS__

namespace contact::detail {

/// Names of a formula that are no variables.
struct Constants {
  std::map<std::string, double> numbers = {};
  /// Functions c0 + c1 x + ... of a variable.
  std::map<std::string, std::vector<double>> polynomials = {};
};

/// The lines of a formula in a language, after declarations of its variables.
std::string printed(std::string_view formula, const Constants& constants,
                    const Language& in);

/// A number with all its digits and a point.
std::string real_text(double x);
/// `text` with each `word` replaced.
std::string replaced(std::string text, std::string_view word,
                     std::string_view by);

}  // namespace contact::detail
