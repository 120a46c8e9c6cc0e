#include "cli/interrupts.hpp"

namespace cli {
namespace {

// Variables that a handler may touch.
volatile std::sig_atomic_t came = 0;
std::array<struct sigaction, 2> restored;

extern "C" void remember_signal(int signal) {
  came = signal;
  sigaction(SIGINT, &restored[0], nullptr);
  sigaction(SIGTERM, &restored[1], nullptr);
}

}  // namespace

Interrupts::Interrupts() {
  came = 0;
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before_[i]);
  }
  restored = before_;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (before_[i].sa_handler == SIG_IGN) continue;
    sigaction(signals[i], &action, nullptr);
  }
}

Interrupts::~Interrupts() {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], &before_[i], nullptr);
  }
}

int Interrupts::signal() const { return came; }

ExitStatus Interrupts::status(ExitStatus status) const {
  if (came == 0) return status;
  return came == SIGINT ? interrupted : terminated;
}

}  // namespace cli
