#include "programs/separation/replays.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <utility>

#include "cli/program.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/file_name.hpp"
#include "libcontact/base/file_text.hpp"

namespace separation {
namespace {

// Text of the case as run: a pipe has been read, and keys may have been
// changed.
std::string text_of_case(const Case& c, const Options& options) {
  std::error_code ignored;
  std::string text = std::filesystem::is_regular_file(c.file, ignored)
                         ? contact::detail::file_text(c.file)
                         : c.content;
  for (const std::string& setting : options.settings) {
    text += "\n# --set " + setting;
  }
  return text;
}

}  // namespace

Replays::Replays(const Case& c, const Options& options) {
  for (const std::string& name : options.replays) {
    if (cli::is_page(name) && !parts_) {
      parts_.emplace(cli::given("--replay", name));
      if (!options.no_case) case_text_ = text_of_case(c, options);
    }
    files_.push_back({name, std::make_unique<cli::Output>(name)});
  }
}

bool Replays::write(const Case& c, std::vector<ShownRun> runs,
                    Warnings& warnings) {
  if (files_.empty()) return true;
  Replay replay{c, std::move(runs), {}, case_text_};
  warn_of_replay(replay, warnings);
  bool good = true;
  for (auto& [name, file] : files_) {
    try {
      file->write(cli::is_page(name) ? page(replay, name) : replay_glb(replay));
      file->commit();
    } catch (const std::exception& error) {
      cli::warn(program_name, error.what());
      good = false;
    }
    file.reset();  // and frees its disk space
  }
  return good;
}

std::string Replays::page(const Replay& replay, const std::string& name) const {
  Page page = replay_page(replay, *parts_);
  if (page.every > 1) {
    cli::note(program_name,
              fmt::format("{} shows one of {} rows, to stay below {} MB", name,
                          page.every, most_page / 1'000'000));
  }
  return std::move(page.text);
}

}  // namespace separation
