#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace cli {

/// Says on standard error how far a long run is: on a terminal after a second
/// and from then on in one line. Elsewhere runs that count nothing say a line
/// every ten seconds; those that count rows are silent.
class Progress {
  using Clock = std::chrono::steady_clock;

 public:
  /// @param what   "rows"
  /// @param total  number of them, 0 if not known
  explicit Progress(std::string what = {}, std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `count` more are done.
  void add(std::size_t count);
  /// Whether it is time to say something.
  bool is_due() const { return Clock::now() >= next_; }
  bool is_terminal() const { return terminal_; }
  /// For runs that count nothing: `text` is a whole line where there is no
  /// terminal.
  void say(const std::string& text);
  /// Removes the message, so that a line of text can be printed.
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

}  // namespace cli
