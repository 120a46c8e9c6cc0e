#pragma once

#include <csignal>

#include <array>

#include "cli/program.hpp"

namespace cli {

/// While it lives SIGINT and SIGTERM do not end the program but are
/// remembered, so that it can finish what it has begun; a second one does what
/// the first one would have done. Signals that are ignored stay so. One at a
/// time; made after the first Output, which has handlers of its own.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  /// SIGINT or SIGTERM if it has come, else 0.
  int signal() const;
  /// `status`, or the status of a signal if one has come.
  ExitStatus status(ExitStatus status) const;

 private:
  static constexpr std::array<int, 2> signals = {SIGINT, SIGTERM};
  std::array<struct sigaction, 2> before_;
};

}  // namespace cli
