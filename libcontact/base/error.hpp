// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace contact {

/// Bad input from a person: a file, an option, a parameter out of range. The
/// message names the place, the value and the allowed range, in one line.
/// Constructors and readers throw it; numerical kernels never throw.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// How a numerical evaluation ended. Results that are not `ok` hold NaN where
/// no value exists and the best value found where one does.
enum class Status {
  ok,
  /// The argument lies where the formula has no value (Hertz beyond x = 1).
  out_of_range,
  /// The iteration stopped at its step limit before meeting its tolerance.
  not_converged,
  /// No pressure on the seat carries the load: the ball leaves it.
  out_of_seat,
};

}  // namespace contact
