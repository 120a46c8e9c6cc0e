#pragma once

#include <array>
#include <string_view>

namespace contact::detail {

/// The spelling of statements; {0}, {1}, {2} stand for their parts.
struct Notation {
  std::string_view whole;      ///< an integer
  std::string_view real;       ///< another number
  std::string_view declared;   ///< names; "": no declarations
  std::string_view assigned;   ///< name, expression
  std::string_view choice;     ///< condition, then, else
  std::string_view component;  ///< vector, index
  std::string_view loop;       ///< variable, count
  std::string_view end;        ///< closes a loop
  std::string_view leave;      ///< condition; "": no early exit
  /// sqrt, log, abs, exp, poly
  std::array<std::string_view, 5> functions;
};

/// A language for load laws. In its texts NAME and F0 stand for the name and
/// the coefficient of friction, {MOMENT}, {FRICTION}, {HOLD} and {GRADIENT} for
/// the lines of formulas, TABLE for the coefficients of a ball, DM_DR and DM_DW
/// for the components of derivatives, row by row. Text between two @ is omitted
/// if the law has no argument f.
struct Language {
  std::string_view name;
  std::string_view comment;  ///< beginning of its lines
  std::string_view indent;
  Notation notation;
  std::string_view prelude;
  std::string_view pin;
  std::string_view ball;  ///< "": no loops and vectors
  bool was_run;           ///< whether our tests run its text
};

/// @throws Error for an unknown name, with the known names.
const Language& language(std::string_view name);

}  // namespace contact::detail
