#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// True if a file's name has this ending, in upper or lower case.
bool ends_in(std::string_view name, std::string_view ending);

/// True for a history in HDF5.
bool is_hdf5(std::string_view name);

/// True for a replay.
bool is_page(std::string_view name);

/// Checks the name of a file given by an option.
/// @param endings  allowed endings; "-" and an existing file that is not
///                 regular are allowed too
/// @param words  the endings in words, for messages
/// @throws contact::Error "OPTION NAME must be a name that ends in WORDS"
void check_ending(std::string_view option, const std::string& name,
                  const std::vector<std::string_view>& endings,
                  std::string_view words);

}  // namespace cli
