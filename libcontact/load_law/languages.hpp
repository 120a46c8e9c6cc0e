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

/// A language that load laws are written in. NAME and F0 stand for the
/// name and the coefficient of friction.
struct Language {
  std::string_view name;
  std::string_view comment;  ///< what a line of it begins with
  std::string_view indent;
  Notation notation;
  std::string_view prelude;
  Function pin;
  bool was_run = false;  ///< whether its text is run by our tests
};

/// @throws Error for a name that is none, with those that are.
const Language& language(std::string_view name);

/// A function in a language.
std::string written(std::string_view formula, const Constants& constants,
                    const Language& in, const Function& as);

}  // namespace contact::detail
