#include "separation/replay/page.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

#include "cli/refuse.hpp"
#include "libcontact/base/file_text.hpp"
#include "separation/replay/page_data.hpp"
#include "separation/replay/page_files.hpp"

namespace separation {
namespace {

std::string find_script(const std::string& wanted, const std::string& name) {
  const char* folders = std::getenv("XDG_DATA_DIRS");
  std::istringstream list(folders != nullptr && *folders != '\0'
                              ? folders
                              : "/usr/local/share:/usr/share");
  for (std::string folder; std::getline(list, folder, ':');) {
    const std::filesystem::path path =
        std::filesystem::path(folder) / "javascript" / name;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
      return contact::detail::file_text(path.string());
    }
  }
  cli::refuse_without(wanted, "three.js and dygraphs (" + name +
                                  " is missing): apt install libjs-three "
                                  "libjs-dygraphs");
}

// Every {{name}} of a text; what is put in is not looked at again.
std::string fill(std::string_view text,
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

// Of the content, so that the same run gives the same page: whoever wants to
// put a script into a case's text would have to know it.
std::string nonce_of(const std::string& content) {
  return fmt::format("{:016x}", std::hash<std::string>{}(content));
}

}  // namespace

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
      default:
        result += c;
    }
  }
  return result;
}

std::string still_page(const std::string& title, const std::string& body) {
  const std::string nonce = nonce_of(body);
  const std::string safe_title = in_markup(title);
  return fill(page_head,
              [&](std::string_view name) -> std::string_view {
                if (name == "nonce") return nonce;
                if (name == "title") return safe_title;
                return page_style;
              }) +
         body + "</body>\n</html>\n";
}

PageParts::PageParts(const std::string& wanted) {
  for (const char* name :
       {"three/three.min.js", "three/examples/js/loaders/GLTFLoader.js",
        "three/examples/js/controls/OrbitControls.js",
        "dygraphs/dygraph.min.js"}) {
    scripts_ += find_script(wanted, name) + '\n';
  }
  scripts_ += page_script;
  style_ = find_script(wanted, "dygraphs/dygraph.min.css") + '\n';
  style_ += page_style;
}

std::string PageParts::page(const std::string& title,
                            const std::string& data) const {
  const std::string nonce = nonce_of(data);
  const std::string safe_title = in_markup(title);
  const auto part = [&](std::string_view name) -> std::string_view {
    if (name == "nonce") return nonce;
    if (name == "title") return safe_title;
    if (name == "style") return style_;
    if (name == "scripts") return scripts_;
    return data;
  };
  return fill(page_head, part) + fill(page_body, part);
}

Page replay_page(const Replay& replay, const PageParts& parts,
                 std::size_t most) {
  for (int every = 1;; every *= 2) {
    std::string text = parts.page(replay.c.name, page_data(replay, every));
    const std::size_t rows = replay.runs.front().outcome->memory.rows.size();
    if (text.size() <= most || static_cast<std::size_t>(every) > rows) {
      return {std::move(text), every};
    }
  }
}

}  // namespace separation
