#pragma once

#include <csignal>

#include <array>

#include "cli/program.hpp"

namespace cli {

/// Defers SIGINT and SIGTERM while it lives, so that the program can finish its
/// current work; a second signal has the usual effect. Ignored signals stay
/// ignored. Only one object may exist at a time; make it after the first
/// Output, which installs handlers of its own.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// The deferred SIGINT or SIGTERM, else 0.
  int signal() const;
  /// `status`, or the exit status of a deferred signal.
  ExitStatus status(ExitStatus status) const;

 private:
  static constexpr std::array<int, 2> signals = {SIGINT, SIGTERM};
  std::array<struct sigaction, 2> before_;
};

}  // namespace cli
