#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// "a after b after a" if the successors of a name lead back to it; "" if not.
/// @param next  successor of each name, -1: none
std::string circle_of(const std::vector<std::string>& names,
                      const std::vector<int>& next, int start,
                      std::string_view word);

/// Names in a case file and their bodies and events, during reading.
struct CaseNames {
  const Case& of;
  /// Turn of each body's copy: carrier axes as written to carrier axes.
  std::vector<Eigen::Matrix3d> turns;
  std::vector<std::string> events;

  /// Bodies called `name`: one, or all copies of a body.
  std::vector<int> rigid_bodies(std::string_view name) const;

  /// The bodies named by the text of a key; throws Error if there are none.
  std::vector<int> rigid_bodies_of(const contact::TomlTable& table,
                                   std::string_view key) const;
  /// The bodies named by one or several texts; all if the key is missing.
  std::vector<int> bodies_of(const contact::TomlTable& table,
                             std::string_view key) const;
  /// The event named by the text of a key; -1 if the key is missing.
  /// @param except  an event that is not allowed, "" for none
  int event_of(const contact::TomlTable& table, std::string_view key,
               std::string_view except = "") const;
};

}  // namespace separation
