#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "separation/case/case.hpp"
#include "separation/case/hinge_reader.hpp"

namespace separation {

/// Reads a case file; its keys: README.md of this folder.
/// @throws contact::Error with one line that names file, line, key, value and
///   what is allowed
Case read_case(const std::filesystem::path& path, const JointLaws& laws = {});
/// @param source  what messages call the text
Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws = {});

}  // namespace separation
