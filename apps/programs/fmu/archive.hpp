#pragma once

#include <filesystem>
#include <string>

namespace hinge_fmu {

/// Writes a zip file. It stores no times, so that equal contents make equal
/// files.
class Archive {
 public:
  /// @throws contact::Error if the file cannot be made
  explicit Archive(const std::filesystem::path& file);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// @throws contact::Error if it cannot be written
  void add(const std::string& name, const std::string& content);
  void close();

 private:
  std::string file_;
  void* zip_;
};

}  // namespace hinge_fmu
