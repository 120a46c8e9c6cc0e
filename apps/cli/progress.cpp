#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/stream/standard_streams.hpp"

namespace cli {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + std::chrono::seconds(terminal_ ? 1 : 10)) {}

Progress::~Progress() { clear(); }

bool Progress::is_due() const { return !quiet && Clock::now() >= next_; }

void Progress::have_said() {
  next_ = Clock::now() + std::chrono::milliseconds(terminal_ ? 200 : 10'000);
  shown_ = terminal_;
}

void Progress::say(const std::string& text) {
  // On a terminal it overwrites the previous message, which may have been
  // longer.
  std::fprintf(stderr, terminal_ ? "\r\033[K%s " : "%s\n", text.c_str());
  have_said();
}

void Progress::add(std::size_t count) {
  done_ += count;
  if (!terminal_ || !is_due()) return;
  have_said();
  if (total_ > 0) {
    std::fprintf(stderr, "\r%zu of %zu %s (%d %%) ", done_, total_,
                 what_.c_str(),
                 static_cast<int>(100.0 * static_cast<double>(done_) /
                                  static_cast<double>(total_)));
  } else {
    std::fprintf(stderr, "\r%zu %s ", done_, what_.c_str());
  }
}

void Progress::clear() {
  // Back to the start of the line, and erase it (ECMA-48 EL).
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

void ShareDone::come_to(double share) {
  if (!progress_.is_terminal() || !progress_.is_due()) return;
  progress_.say(fmt::format("{} % of {}", static_cast<int>(100 * share), of_));
}

}  // namespace cli
