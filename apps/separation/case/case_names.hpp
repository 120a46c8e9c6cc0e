#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
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
  /// The same of one text of several.
  std::vector<int> rigid_bodies_of(const contact::TomlTable& table,
                                   std::string_view key,
                                   const std::string& name) const;
  /// The bodies that one or several texts name; all if the key is missing.
  std::vector<int> bodies_of(const contact::TomlTable& table,
                             std::string_view key) const;
  /// The event named by the text of a key; -1 if the key is missing.
  /// @param except  an event that is not allowed, "" for none
  int event_of(const contact::TomlTable& table, std::string_view key,
               std::string_view except = "") const;
  /// The same of one text of several.
  int event_called(const contact::TomlTable& table, std::string_view key,
                   const std::string& name, std::string_view except = "") const;
  /// KEY_at (a time), or KEY_at_event with KEY_delay.
  Clock clock(const contact::TomlTable& table, const std::string& key,
              const Clock& otherwise) const;
  /// starts_... and ends_..., which is later as far as that is known.
  /// @param what  that begins, for messages
  std::pair<Clock, Clock> window(const contact::TomlTable& table,
                                 std::string_view what) const;
};

}  // namespace separation
