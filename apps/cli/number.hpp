#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/text.hpp"

namespace cli {

/// Closed interval of the values that an option or a column allows.
struct Allowed {
  double min;
  double max;
  /// Unit as messages print it, "" for a pure number.
  std::string_view unit;

  /// False for NaN.
  bool contains(double value) const { return value >= min && value <= max; }
  /// "0 to 120 deg"
  std::string text() const;
  /// Rule for messages: "0 to 120 deg" for a number out of range, "a number, 0
  /// to 120 deg" for other text.
  std::string rule(bool is_number) const {
    return is_number ? text() : "a number, " + text();
  }
};

/// Parses a text that is one number: decimal or scientific, signed, also inf
/// and nan; surrounding blanks are skipped. Returns no value for other text and
/// for numbers that exceed the range of double.
std::optional<double> parse_number(std::string_view text);

/// Parses a number at the beginning of `text`, as above, and removes it from
/// the text; returns no value if there is none.
std::optional<double> take_number(std::string_view& text);

/// Largest number of characters that `write_number` writes.
inline constexpr std::size_t longest_number = 32;

/// Writes the shortest decimal text that reads back as the same double (at
/// most 17 significant digits); returns the end of the text.
char* write_number(char* to, double value);

/// As above, as a string for messages.
std::string number_text(double value);

/// Rounds `value` to `digits` significant digits as printed tables do, with
/// trailing zeros: 0.8000, 12.35, 1.234e-07; "-" for NaN.
std::string rounded_text(double value, int digits);

}  // namespace cli
