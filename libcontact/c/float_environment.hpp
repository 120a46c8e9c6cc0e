#pragma once

#include <cfenv>

namespace contact::c {

/// The floating-point environment of a new program while in scope, in the place
/// of a host's: no exception is trapped, numbers are rounded to nearest and
/// small ones kept. Afterwards the host has its own again, its flags too.
class FloatEnvironment {
 public:
  FloatEnvironment() noexcept;
  ~FloatEnvironment();
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  bool is_quick_ = false;
  unsigned registers_ = 0;
  std::fenv_t hosts_;
};

}  // namespace contact::c
