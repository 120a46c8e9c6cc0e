#include "libcontact/base/complaint.hpp"

#include "libcontact/base/text.hpp"

namespace contact::detail {

std::string must_be(std::string_view what, std::string_view rule) {
  return message("{} must be {}", what, rule);
}

std::string unknown(std::string_view kind, std::string_view word,
                    std::span<const std::string> known) {
  return unknown(kind, printable(word), nearest(word, known), known);
}

std::string unknown(std::string_view kind, std::string_view shown,
                    std::string_view near, std::span<const std::string> known) {
  const std::string text =
      message("unknown {} \"{}\"{}", kind, shown, did_you_mean(near));
  return known.empty() ? text : message("{} ({})", text, joined(known, ", "));
}

std::string did_you_mean(std::string_view near) {
  return near.empty() ? "" : message(": did you mean \"{}\"?", near);
}

std::string either(std::span<const std::string> words) {
  return words.size() < 2
             ? joined(words, "")
             : message("{} or {}", joined(words.first(words.size() - 1), ", "),
                       words.back());
}

std::string needs(std::string_view what, std::string_view other) {
  return message("{} requires {}", what, other);
}

std::string conflicts(std::string_view what, std::string_view other, int line) {
  return line > 0 ? message("{} conflicts with {} (line {})", what, other, line)
                  : message("{} conflicts with {}", what, other);
}

std::string duplicate(std::string_view kind, std::string_view what,
                      int first_line, int second_line) {
  return first_line > 0 ? message("duplicate {} {} (lines {} and {})", kind,
                                  what, first_line, second_line)
                        : message("duplicate {} {}", kind, what);
}

}  // namespace contact::detail
