#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Formulas that are compiled here and printed in other languages, so that what
/// is measured is what is printed. They are macros, in the part of C++ that all
/// languages have: `Real a, b;` then `a = EXPRESSION;`, `a = CONDITION ? x :
/// y;`, `for (int i = 0; i < count; ++i) { ... }` and in it `if (CONDITION)
/// break;`. Numbers in them are whole ones; others are constants with a name.
#define CONTACT_TEXT_OF(...) CONTACT_TEXT_OF_EXPANDED(__VA_ARGS__)
#define CONTACT_TEXT_OF_EXPANDED(...) #__VA_ARGS__

namespace contact::detail {

/// The spelling of a language; {0}, {1}, {2} are parts.
struct Notation {
  std::string_view whole;      ///< a whole number
  std::string_view real;       ///< another one
  std::string_view declared;   ///< names, "" where that is not done
  std::string_view assigned;   ///< name, expression
  std::string_view choice;     ///< condition, if so, else
  std::string_view component;  ///< vector, index
  std::string_view loop;       ///< variable, count
  std::string_view end;        ///< closes a loop
  std::string_view leave;      ///< condition; "": all rounds are run
  std::array<std::string_view, 4> functions;  ///< sqrt, log, abs, exp
};

/// Names of a formula that are no variables.
struct Constants {
  std::map<std::string, double, std::less<>> numbers = {};
  /// Functions c0 + c1 x + ... of a variable.
  std::map<std::string, std::vector<double>, std::less<>> polynomials = {};
};

/// The lines of a formula in a language.
std::string printed(std::string_view formula, const Constants& constants,
                    const Notation& in, std::string_view indent);

/// A number with all its digits and a point.
std::string real_text(double x);
/// `text` with each `word` replaced.
std::string replaced(std::string text, std::string_view word,
                     std::string_view by);

template <class Real>
Real horner(const std::vector<double>& c, Real x) {
  Real sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + Real(c[i]);
  return sum;
}

}  // namespace contact::detail
