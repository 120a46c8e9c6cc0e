#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "libcontact/files/toml_form.hpp"
#include "libcontact/joint/spec.hpp"
#include "separation/case/case.hpp"
#include "separation/case/case_names.hpp"

namespace separation {

/// A case for repeated reading, by one thread at a time, with new numbers for
/// some keys: reads only the parts with these keys and the parts that depend on
/// them (case_parts.hpp). Results equal case_of_file().
class CaseForm {
 public:
  /// @param keys  as TomlForm's
  /// @param nominal  the unchanged case; must outlive this object
  /// @param made  laws of joints; laws that a key changes are built again
  /// @throws contact::Error for a key that has no number, or changes the number
  ///   of bodies
  CaseForm(const contact::TomlFiles& files, const std::filesystem::path& file,
           const contact::KeySettings& keys, const Case& nominal,
           const contact::SharedLaws& made);

  /// @param numbers  for each key a number, or one for each copy of its body or
  ///   of its force
  /// @throws contact::Error if they make no case
  Case with(const std::vector<std::span<const double>>& numbers);

 private:
  using Numbers = std::vector<std::span<const double>>;
  using Keys = std::vector<std::size_t>;
  /// A [[body]], a [[force]] or an [[event]], with the places of its copies.
  struct Part {
    contact::TomlTable table;
    int first;
    int count;
    Keys keys = {};
  };

  /// Number of bodies between a rigid body and the carrier.
  static int depth(const Case& of, int body);
  static std::vector<Part> parts(const contact::TomlTable& file,
                                 std::string_view key);
  Keys& keys_of(const std::string& place);
  void set(const Keys& keys, const Numbers& numbers, int copy);
  void read_bodies(const Part& part, const Numbers& numbers,
                   contact::SharedLaws& made, Case& c,
                   std::vector<Eigen::Matrix3d>& turns);
  std::vector<Force> read_forces(const Numbers& numbers, const CaseNames&);

  contact::TomlForm form_;
  const Case& nominal_;
  contact::SharedLaws made_;
  std::vector<Part> bodies_, forces_, events_;
  Keys run_, carrier_;
  std::vector<Eigen::Matrix3d> turns_;  ///< from CaseNames
  std::vector<std::string> event_names_;
};

}  // namespace separation
