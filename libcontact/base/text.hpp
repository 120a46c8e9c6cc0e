#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace contact::detail {

/// A word or a number in a message.
class MessagePart {
 public:
  MessagePart(std::string_view word) : value_(word) {}
  MessagePart(const std::string& word) : value_(word) {}
  MessagePart(const char* word) : value_(word) {}
  MessagePart(double number) : value_(number) {}
  MessagePart(std::integral auto number)
      : value_(static_cast<long long>(number)) {}

 private:
  friend std::string filled(std::string_view form,
                            std::initializer_list<MessagePart> parts);
  std::variant<std::string_view, double, long long> value_;
};

/// See message().
std::string filled(std::string_view form,
                   std::initializer_list<MessagePart> parts);

/// `form` with its {} filled in, as by fmt::format, which is compiled in one
/// place only: it would take seconds in each file that makes a message.
template <class... Parts>
std::string message(std::string_view form, const Parts&... parts) {
  return filled(form, {MessagePart(parts)...});
}

/// "A, B, C".
std::string joined(std::span<const std::string> words,
                   std::string_view separator);

/// `text` without such characters at its ends.
std::string_view trimmed(std::string_view text, std::string_view of = " \t");

/// Whether a character of `text` is a control character, which could end a
/// line or speak to a terminal, or a mark of direction (U+202E and its like).
bool has_control_characters(std::string_view text);

/// `text` on one line: control characters, marks of direction and bytes that
/// are not UTF-8 as \xNN, cut to some `longest` bytes.
std::string printable(std::string_view text, std::size_t longest = 60);

/// The candidate that is at most two slips (a letter more, less, other, or two
/// exchanged) from `word`, fewer than half of its letters; empty if none is.
std::string nearest(std::string_view word,
                    std::span<const std::string> candidates);

}  // namespace contact::detail
