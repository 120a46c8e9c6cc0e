#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hinge_fmu {

/// Content of an FMU made from a joint or case file: the file and the files it
/// names, side by side, and its numbers.
struct Resources {
  struct Key {
    std::string name;  ///< setting: "body[1].hinge.joint[2].radius_mm"
    double value;      ///< in the key's own unit
  };

  std::map<std::string, std::string> files;  ///< file name to text
  /// Numbers of the tables, and arrays of up to three numbers.
  std::vector<Key> keys;
  bool is_joint;                   ///< else a case
  double end_time = 0;             ///< duration of a case, s
  std::vector<std::string> notes;  ///< exceeded limits of the theory
};

/// @throws contact::Error if a file cannot be read, or is neither a valid joint
///   nor a valid case
Resources read_resources(const std::filesystem::path& file);

}  // namespace hinge_fmu
