#pragma once

#include <array>
#include <string_view>

namespace contact::detail {

/// The spelling of statements; {0}, {1}, {2} are parts.
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
  /// sqrt, log, abs, exp, poly
  std::array<std::string_view, 5> functions;
};

/// A language that load laws are written in. In its texts NAME and F0 stand for
/// the name and the coefficient of friction, {MOMENT}, {FRICTION}, {HOLD} and
/// {GRADIENT} for the lines of formulas, TABLE for the coefficients of a ball,
/// DM_DR and DM_DW for the parts of derivatives, row by row, and what is
/// between two @ is left out where f is not given.
struct Language {
  std::string_view name;
  std::string_view comment;  ///< beginning of its lines
  std::string_view indent;
  Notation notation;
  std::string_view prelude;
  std::string_view pin;
  std::string_view ball;  ///< "": there are no loops and vectors
  bool was_run;           ///< whether its text is run by our tests
};

/// @throws Error for a name that is none, with those that are.
const Language& language(std::string_view name);

}  // namespace contact::detail
