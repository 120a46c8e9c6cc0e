#pragma once

#include <string>
#include <string_view>

#include "libcontact/load_law/formula.hpp"

namespace contact::detail {

/// Opening and closing lines of a function.
struct Function {
  std::string_view open;
  std::string_view close;
};

/// A language that load laws are written in. NAME, F0 and TABLE stand for the
/// name, the coefficient of friction and the table of coefficients.
struct Language {
  std::string_view name;
  std::string_view comment;  ///< beginning of its lines
  std::string_view indent;
  Notation notation;
  std::string_view prelude;
  std::string_view table;  ///< defines NAME_poly; "": there are no balls
  Function pin;
  Function ball = {};
  Function hold = {};
  Function gradient = {};  ///< DM_DR and DM_DW are their parts, row by row
  bool was_run = false;    ///< whether its text is run by our tests
};

/// @throws Error for a name that is none, with those that are.
const Language& language(std::string_view name);

/// A function in a language.
std::string written(std::string_view formula, const Constants& constants,
                    const Language& in, const Function& as);

}  // namespace contact::detail
