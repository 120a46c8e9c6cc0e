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

/// The files of --replay.
class Replays {
 public:
  /// Before the run: what cannot be made should not cost its result.
  /// @throws contact::Error if a file cannot be made, and for a page if what it
  ///   is made of is not installed
  Replays(const Case& c, const Options& options);

  /// @param runs  one, or two to compare
  /// @return false if a file could not be written, of which it warns: that
  ///   costs the others nothing
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
