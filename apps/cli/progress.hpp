#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>

namespace cli {

/// Reports the progress of a long run on standard error. On a terminal it
/// updates one line, beginning after a second. Elsewhere a run that counts
/// nothing prints a line every ten seconds; a run that counts rows prints
/// nothing. With --quiet nothing is printed.
class Progress {
  using Clock = std::chrono::steady_clock;

 public:
  /// @param what   "rows"
  /// @param total  number of rows, 0 if not known
  explicit Progress(std::string what = {}, std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts `count` more as done.
  void add(std::size_t count);
  /// True if a message is due.
  bool is_due() const;
  bool is_terminal() const { return terminal_; }
  /// For runs that count nothing. Where there is no terminal `text` is printed
  /// as a whole line.
  void say(const std::string& text);
  /// Erases the message, so that a line of text can be printed.
  void clear();

 private:
  void have_said();

  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_ = false;
  bool terminal_;
  Clock::time_point next_;
};

/// Reports on a terminal which share of some work is done.
class ShareDone {
 public:
  /// @param of  "the cycles"
  explicit ShareDone(std::string of) : of_(std::move(of)) {}
  void come_to(double share);

 private:
  Progress progress_;
  std::string of_;
};

}  // namespace cli
