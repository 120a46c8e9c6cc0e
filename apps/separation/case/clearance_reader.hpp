#pragma once

#include <array>
#include <string>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_names.hpp"

namespace separation {

/// All [[clearance]]; without any, all pairs of bodies with shapes.
std::vector<WatchedPair> read_clearance(const contact::TomlTable& file,
                                        const CaseNames& names);
/// All pairs of two bodies with shapes, or of their copies.
/// @param keys  whose texts name them; one key has both
std::vector<WatchedPair> pairs_of(const contact::TomlTable& table,
                                  const std::array<std::string, 2>& bodies,
                                  const std::array<std::string, 2>& keys,
                                  const CaseNames& names);

}  // namespace separation
