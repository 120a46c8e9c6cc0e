#include "cli/html/markup.hpp"

#include <fmt/format.h>

#include "cli/html/page_files.hpp"

namespace cli {

std::string in_markup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string fill_template(
    std::string_view text,
    const std::function<std::string_view(std::string_view)>& of) {
  std::string result;
  for (;;) {
    const std::size_t open = text.find("{{");
    result += text.substr(0, open);
    if (open == std::string_view::npos) return result;
    const std::size_t close = text.find("}}", open);
    result += of(text.substr(open + 2, close - open - 2));
    text.remove_prefix(close + 2);
  }
}

std::string nonce_of(const std::string& content) {
  return fmt::format("{:016x}", std::hash<std::string>{}(content));
}

std::string still_page(const std::string& title, const std::string& body) {
  const std::string nonce = nonce_of(body);
  const std::string safe_title = in_markup(title);
  const auto part = [&](std::string_view name) -> std::string_view {
    if (name == "nonce") return nonce;
    if (name == "title") return safe_title;
    if (name == "policy") return "";
    return page_style;
  };
  return fill_template(page_head, part) + body + "</body>\n</html>\n";
}

}  // namespace cli
