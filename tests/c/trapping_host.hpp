#pragma once

#include <cfenv>

namespace contact::test {

/// Simulates a host compiled with Fortran's -ffpe-trap=invalid,zero,overflow
/// that rounds upward. Its own arithmetic is not exact.
class TrappingHost {
 public:
  TrappingHost() {
    std::feholdexcept(&before_);
    std::fesetround(FE_UPWARD);
    std::feraiseexcept(flags);
    feenableexcept(traps);
  }
  ~TrappingHost() { std::fesetenv(&before_); }
  bool is_kept() const {
    return fegetexcept() == traps && std::fegetround() == FE_UPWARD &&
           std::fetestexcept(FE_ALL_EXCEPT) == flags;
  }

 private:
  static constexpr int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  static constexpr int flags = FE_UNDERFLOW | FE_INEXACT;
  std::fenv_t before_;
};

}  // namespace contact::test
