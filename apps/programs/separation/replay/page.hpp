#pragma once

#include <string>

#include "programs/separation/replay/replay.hpp"

/// A replay as one page that needs no network.
namespace separation {

/// Parts of a page other than runs, read before the runs begin.
class PageParts {
 public:
  /// Reads three.js and dygraphs from the folders `javascript` of XDG_DATA_DIRS
  /// (else /usr/local/share and /usr/share).
  /// @param wanted  the option that needs them: "--replay FILE"
  /// @throws contact::Error "WANTED requires ..." naming the packages
  explicit PageParts(const std::string& wanted);

  /// The template with scripts, styles and this data.
  std::string page(const std::string& title, const std::string& data) const;

 private:
  std::string scripts_, style_;
};

/// A page of at most `most_page` bytes. If not all rows fit, it shows every
/// second, fourth, ... row.
struct Page {
  std::string text;
  int every;  ///< one row in `every` is shown
};
inline constexpr std::size_t most_page = 50'000'000;
Page replay_page(const Replay& replay, const PageParts& parts,
                 std::size_t most = most_page);

}  // namespace separation
