#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hinge_fmu {

/// Content of a joint or case file for an FMU: the file and those that it
/// names, side by side, and its numbers.
struct Resources {
  struct Key {
    std::string name;  ///< as in settings: "body[1].hinge.joint[2].radius_mm"
    double value;      ///< in the key's own unit
  };

  std::map<std::string, std::string> files;  ///< texts by names
  /// Numbers of the tables and of arrays of up to three numbers.
  std::vector<Key> keys;
  bool is_joint;                   ///< else a case
  double end_time = 0;             ///< duration of a case, s
  std::vector<std::string> notes;  ///< limits of the theory that it exceeds
};

/// @throws contact::Error if a file cannot be read, or is neither a joint nor
///   a case that is good
Resources read_resources(const std::filesystem::path& file);

}  // namespace hinge_fmu
