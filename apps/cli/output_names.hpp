#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cli {

/// The files of one program, all different: in the order in which they are
/// named here, so that messages name the later one. An existing file that is
/// not regular, such as /dev/null, may have several writers.
class OutputNames {
 public:
  /// A file to write, "-" for standard output; nothing if empty. No file that
  /// is read may be it, see files_in_use.hpp.
  /// @throws contact::Error "OPTION NAME must be another file than OTHER", or
  /// if it cannot be made
  void add(std::string_view option, const std::string& name);
  /// A file that others make, or that is read as well, as a journal is.
  /// @throws contact::Error as add() does of a shared name
  void keep(std::string_view option, const std::string& name);

 private:
  std::map<std::string, std::string> options_;  ///< by where their names lead
};

}  // namespace cli
