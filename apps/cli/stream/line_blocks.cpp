#include "cli/stream/line_blocks.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"

namespace cli {
namespace {

// Large compared with the cost of a system call and of passing a block between
// threads, but small enough for the cache: some 3,000 lines.
constexpr std::size_t block_size = 1 << 16;

int opened(const std::string& path) {
  const bool is_file = path != "-";
  contact::detail::tell_reading(is_file ? path : "/dev/stdin");
  return is_file ? open(path.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO;
}

}  // namespace

std::string_view next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

LineReader::LineReader(const std::string& path)
    : name_(path == "-" ? "standard input" : path), descriptor_(opened(path)) {
  if (descriptor_ < 0) {
    throw contact::Error(
        fmt::format("cannot open {}: {}", name_, std::strerror(errno)));
  }
}

LineReader::~LineReader() {
  if (descriptor_ > STDERR_FILENO) close(descriptor_);
}

bool LineReader::fill(std::string& text) {
  const std::size_t size = text.size();
  bytes_.resize(block_size);
  while (!at_end_ && text.size() == size) {
    ssize_t count = 0;
    do {
      count = read(descriptor_, bytes_.data(), block_size);
    } while (count < 0 && errno == EINTR);
    if (count < 0) {
      throw contact::Error(
          fmt::format("cannot read {}: {}", name_, std::strerror(errno)));
    }
    at_end_ = count == 0;
    if (at_end_) {
      decoder_.finish(text);
    } else {
      decoder_.decode({bytes_.data(), static_cast<std::size_t>(count)}, text);
    }
  }
  return text.size() > size;
}

// Fills rest_ with a whole line, the last line, or more than a line may have.
void LineReader::fetch_line() {
  while (rest_.find('\n') == std::string::npos) {
    if (rest_.size() > longest_line || !fill(rest_)) return;
  }
}

std::string_view LineReader::ahead() {
  fetch_line();
  return rest_;
}

std::optional<std::string> LineReader::line() {
  fetch_line();
  if (std::min(rest_.find('\n'), rest_.size()) > longest_line) {
    throw contact::Error(fmt::format("{}, line {}: longer than {} characters",
                                     name_, next_number_, longest_line));
  }
  if (rest_.empty()) return std::nullopt;
  std::string_view text = rest_;
  const std::string line(next_line(text));
  rest_.erase(0, rest_.size() - text.size());
  ++next_number_;
  return line;
}

// Drops the text up to the next line end; the rest becomes rest_.
void LineReader::skip_line() {
  std::size_t end = std::string::npos;
  do {
    rest_.clear();
    if (!fill(rest_)) return;
    end = rest_.find('\n');
  } while (end == std::string::npos);
  rest_.erase(0, end + 1);
}

bool LineReader::next(LineBlock& block) {
  block.first_line = next_number_;
  block.text.swap(rest_);
  rest_.clear();
  // Returns the whole lines that came with a header without waiting for more:
  // their writer may wait for the answer.
  std::size_t end = block.text.rfind('\n') + 1;
  while (end == 0 && block.text.size() <= longest_line) {
    if (!fill(block.text)) {
      end = block.text.size();
      break;
    }
    end = block.text.rfind('\n') + 1;
  }
  if (end == 0 && !block.text.empty()) {
    skip_line();
    block.text += '\n';
  } else {
    rest_.assign(block.text, end);
    block.text.resize(end);
  }
  next_number_ += static_cast<std::size_t>(
      std::count(block.text.begin(), block.text.end(), '\n'));
  return !block.text.empty();
}

}  // namespace cli
