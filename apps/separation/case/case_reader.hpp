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
///   what is allowed
/// @param settings  keys whose values are others than in the case, its joint
///   files and their materials: "body[1].hinge.joint[1].materials.inner..."
Case read_case(const std::filesystem::path& path, const JointLaws& laws = {},
               const contact::KeySettings& settings = {});
/// @param source  what messages call the text
/// @param folder  what paths in it are relative to
Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws = {},
                const contact::KeySettings& settings = {},
                const std::filesystem::path& folder = {});

/// From a file that is open, with case_keys(); `content` is left empty.
/// @param made  laws of joints, those of other cases too
Case case_of_file(const contact::TomlTable& file, const JointLaws& laws,
                  contact::SharedLaws& made);

}  // namespace separation
