#include "programs/separation/stop_rule.hpp"

#include <fmt/format.h>

#include <chrono>

namespace separation {

StopRule stop_rule(const cli::Interrupts& interrupts, int steps,
                   double seconds) {
  using Wall = std::chrono::steady_clock;
  return [&interrupts, steps, seconds,
          begin = Wall::now()](long done) -> std::string {
    if (const int signal = interrupts.signal(); signal != 0) {
      return signal == SIGINT ? "SIGINT" : "SIGTERM";
    }
    if (steps > 0 && done >= steps)
      return fmt::format("--step-limit {}", steps);
    using Seconds = std::chrono::duration<double>;
    if (seconds > 0 && Seconds(Wall::now() - begin).count() >= seconds) {
      return fmt::format("--time-limit {:.6g} s", seconds);
    }
    return {};
  };
}

}  // namespace separation
