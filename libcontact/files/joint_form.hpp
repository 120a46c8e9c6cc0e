#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "libcontact/files/toml_form.hpp"
#include "libcontact/joint/spec.hpp"

namespace contact {

/// Joints of one text with other numbers of some keys, by one thread at a time.
/// The text is parsed and the keys are looked up once; with SharedLaws a joint
/// is ready in some 16 us.
class JointForm {
 public:
  /// @param settings  of other keys
  /// @param keys      that are given numbers, in their own units
  /// @throws Error as parse_joint()
  JointForm(std::string text, std::string source, std::filesystem::path folder,
            KeySettings settings, std::vector<std::string> keys);

  /// @param numbers  of the keys
  /// @throws Error as parse_joint() with settings that say so
  JointSpec with(std::span<const double> numbers);

 private:
  KeySettings settings_of(std::span<const double> numbers) const;

  std::string text_;
  std::string source_;
  std::filesystem::path folder_;
  KeySettings settings_;
  std::vector<std::string> keys_;
  TomlForm form_;
};

}  // namespace contact
