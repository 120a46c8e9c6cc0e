#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/load_law/languages.hpp"

/// Formulas that are compiled here and printed in other languages, so that the
/// measured errors hold for the printed text. They are macros in the subset of
/// C++ that all languages share: `a = EXPRESSION;`, `a = CONDITION ? x : y;`,
/// `for (int i = 0; i < count; ++i) { ... }` and in it `if (CONDITION) break;`.
/// Numbers in them are integers; other numbers are named constants.
#define CONTACT_TEXT_OF(...) CONTACT_TEXT_OF_EXPANDED(__VA_ARGS__)
#define CONTACT_TEXT_OF_EXPANDED(...) #__VA_ARGS__

namespace contact::detail {

/// Names in a formula that are not variables.
struct Constants {
  std::map<std::string, double> numbers = {};
  /// Functions c0 + c1 x + ... of a variable.
  std::map<std::string, std::vector<double>> polynomials = {};
};

/// The lines of a formula in a language, after declarations of its variables.
std::string printed(std::string_view formula, const Constants& constants,
                    const Language& in);

/// A number with all its digits and a decimal point.
std::string real_text(double x);
/// `text` with each `word` replaced.
std::string replaced(std::string text, std::string_view word,
                     std::string_view by);

}  // namespace contact::detail
