#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

/// Parts shared by the programs: options, numbers, tables, files, plots.
namespace cli {

/// Growing text written through a pointer; holds a block of rows. It keeps its
/// memory from block to block, so rows allocate nothing.
class Text {
 public:
  /// Makes room for `count` more characters and returns their place. Call
  /// `end_at` with the end of the written characters.
  char* reserve(std::size_t count) {
    if (buffer_.size() - size_ < count) grow(count);
    return buffer_.data() + size_;
  }
  void end_at(const char* end) { size_ = end - buffer_.data(); }

  void append(std::string_view text) {
    // An empty view may have a null pointer, which memcpy does not accept.
    if (text.empty()) return;
    std::memcpy(reserve(text.size()), text.data(), text.size());
    size_ += text.size();
  }
  void append(char c) { append(std::string_view(&c, 1)); }

  std::string_view view() const { return {buffer_.data(), size_}; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }

 private:
  // Out of line, so that the rest is inlined where cells are written.
  [[gnu::noinline]] void grow(std::size_t count) {
    buffer_.resize(2 * (size_ + count));
  }

  std::vector<char> buffer_ = std::vector<char>(256);
  std::size_t size_ = 0;
};

}  // namespace cli
