#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cli {

/// The output files of one program, which must all differ. Messages name the
/// later of two equal files. Several outputs may share an existing file that is
/// not regular, such as /dev/null.
class OutputNames {
 public:
  /// Adds a file to write; "-" is standard output, "" is ignored. Files that
  /// are read are rejected (files_in_use.hpp).
  /// @throws contact::Error "OPTION NAME must be another file than OTHER", or
  ///   if it cannot be made
  void add(std::string_view option, const std::string& name);
  /// Adds a file that other code makes, or that is also read, such as a
  /// journal.
  /// @throws contact::Error for a shared name, as add() does
  void keep(std::string_view option, const std::string& name);

 private:
  std::map<std::string, std::string> options_;  ///< by canonical path
};

}  // namespace cli
