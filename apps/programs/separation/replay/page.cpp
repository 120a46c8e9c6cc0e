#include "programs/separation/replay/page.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "cli/html/markup.hpp"
#include "cli/html/page_files.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/file_text.hpp"
#include "programs/separation/replay/page_data.hpp"
#include "programs/separation/replay/page_files.hpp"

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

}  // namespace

PageParts::PageParts(const std::string& wanted) {
  for (const char* name :
       {"three/three.min.js", "three/examples/js/loaders/GLTFLoader.js",
        "three/examples/js/controls/OrbitControls.js",
        "dygraphs/dygraph.min.js"}) {
    scripts_ += find_script(wanted, name) + '\n';
  }
  scripts_ += page_script;
  style_ = find_script(wanted, "dygraphs/dygraph.min.css") + '\n';
  style_ += cli::page_style;
}

std::string PageParts::page(const std::string& title,
                            const std::string& data) const {
  const std::string nonce = cli::nonce_of(data);
  const std::string safe_title = cli::in_markup(title);
  const auto part = [&](std::string_view name) -> std::string_view {
    if (name == "nonce") return nonce;
    if (name == "title") return safe_title;
    if (name == "policy") return "";
    if (name == "style") return style_;
    if (name == "scripts") return scripts_;
    return data;
  };
  return cli::fill_template(cli::page_head, part) +
         cli::fill_template(page_body, part);
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
