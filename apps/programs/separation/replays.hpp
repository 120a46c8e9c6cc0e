#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "programs/separation/replay/page.hpp"
#include "programs/separation/run.hpp"
#include "programs/separation/warnings.hpp"

namespace separation {

/// Writes the files of --replay.
class Replays {
 public:
  /// Checks before the run that the files can be made, so that no result is
  /// lost.
  /// @throws contact::Error if a file cannot be made, or the parts of a page
  ///   are not installed
  Replays(const Case& c, const Options& options);

  /// @param runs  one, or two to compare
  /// @return false, with a warning, if a file could not be written; the other
  ///         results are still produced
  bool write(const Case& c, std::vector<ShownRun> runs, Warnings& warnings);

 private:
  std::string page(const Replay& replay, const std::string& name) const;

  struct File {
    std::string name;
    std::unique_ptr<cli::Output> output;
  };
  std::vector<File> files_;
  std::optional<PageParts> parts_;
  std::string case_text_;
};

}  // namespace separation
