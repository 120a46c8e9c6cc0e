#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/text.hpp"

namespace cli {

/// Closed interval of the values an option or a column allows.
struct Allowed {
  double min;
  double max;
  /// Unit as messages print it, "" for a pure number.
  std::string_view unit;

  /// False for NaN.
  bool contains(double value) const { return value >= min && value <= max; }
  /// "0 to 120 deg"
  std::string text() const;
  /// Rule for a text that is no such number: "0 to 120 deg", or "a number, 0 to
  /// 120 deg".
  std::string rule(bool is_number) const {
    return is_number ? text() : "a number, " + text();
  }
};

/// The number that `text` holds and nothing else: decimal or scientific, with
/// any sign, also inf and nan; blanks around it are skipped. No value if it
/// is not a number or does not fit a double.
std::optional<double> parse_number(std::string_view text);

/// The number that `text` begins with, blanks and sign as above, which is taken
/// off it; no value if there is none.
std::optional<double> take_number(std::string_view& text);

/// Characters that `write_number` may need.
inline constexpr std::size_t longest_number = 32;

/// Writes the shortest decimal text that reads back as the same double (at
/// most 17 significant digits); returns the end of the text.
char* write_number(char* to, double value);

/// The same as a string, for messages.
std::string number_text(double value);

/// `value` rounded to `digits` significant digits as printed tables give it,
/// trailing zeros kept: 0.8000, 12.35, 1.234e-07; "-" for NaN.
std::string rounded_text(double value, int digits);

}  // namespace cli
