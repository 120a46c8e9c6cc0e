#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace cli {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + std::chrono::seconds(terminal_ ? 1 : 10)) {}

Progress::~Progress() { clear(); }

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

}  // namespace cli
