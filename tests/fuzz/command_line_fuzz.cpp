// The command line of hinge-angle, which has all kinds of options: any words,
// a line each, are read, or refused by one line that names the program.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz.hpp"

// Its options, with nothing behind them.
#define main hinge_angle_main
#include "programs/angle/main.cpp"
#undef main

cli::ExitStatus hinge_angle::run(const Options& /*options*/) {
  return cli::all_good;
}

namespace {

using contact::test::check;

// Text written to the standard streams while it lives.
class Said {
 public:
  Said() : file_(memfd_create("said", 0)), out_(dup(1)), error_(dup(2)) {
    check(file_ >= 0 && out_ >= 0 && error_ >= 0);
    dup2(file_, 1);
    dup2(file_, 2);
  }
  ~Said() {
    dup2(out_, 1);
    dup2(error_, 2);
    for (const int file : {file_, out_, error_}) close(file);
  }
  Said(const Said&) = delete;
  Said& operator=(const Said&) = delete;

  std::string text() const {
    std::string text(static_cast<std::size_t>(lseek(file_, 0, SEEK_END)), ' ');
    check(pread(file_, text.data(), text.size(), 0) ==
          static_cast<ssize_t>(text.size()));
    return text;
  }

 private:
  int file_, out_, error_;
};

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> words = {"hinge-angle"};
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    // As an argument has no zero.
    words.emplace_back(text.substr(from, to - from).c_str());
    from = to + 1;
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const Said said;
  const int status =
      hinge_angle_main(static_cast<int>(words.size()), arguments.data());
  check(status == 0 || status == cli::failed);
  if (status == 0) return 0;
  const std::string message = said.text();
  check(message.starts_with("hinge-angle: "));
  check(std::ranges::count(message, '\n') == 1 && message.ends_with('\n'));
  return 0;
}
