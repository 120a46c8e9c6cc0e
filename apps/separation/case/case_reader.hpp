// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "libcontact/files/setting.hpp"
#include "separation/case/case.hpp"

namespace contact {
class SharedLaws;
class TomlTable;
}  // namespace contact

namespace separation {

/// Reads a case file; its keys: libcontact/docs/reference/case_file.md.
/// @throws contact::Error with one line that names file, line, key, value and
///   the allowed values
/// @param settings  new values of keys of the case, its joint files and their
///   materials: "body[1].hinge.joint[1].materials.inner..."
Case read_case(const std::filesystem::path& path, const JointLaws& laws = {},
               const contact::KeySettings& settings = {});
/// @param source  name of the text in messages
/// @param folder  base of relative paths in it
Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws = {},
                const contact::KeySettings& settings = {},
                const std::filesystem::path& folder = {});

struct CaseNames;
/// Appends all [[tip_off]] of a case whose bodies and events are read.
void read_tip_offs(const contact::TomlTable& file, const CaseNames& names,
                   Case& c);

/// Reads an open file with case_keys(); `content` stays empty.
/// @param made  laws of joints, also of other cases
Case case_of_file(const contact::TomlTable& file, const JointLaws& laws,
                  contact::SharedLaws& made);

}  // namespace separation
