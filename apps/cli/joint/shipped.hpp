#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/error.hpp"

namespace cli {

/// A folder of data/ that is shipped with the programs.
enum class Shipped { joints, materials, backings };

/// Finds the folder data of the source tree or the installation, for the names
/// in options and files.
void find_shipped();

/// Sorted names of its files without endings; empty if the programs find
/// neither the source tree nor the installation.
std::vector<std::string> shipped_names(Shipped kind);

/// Path of the shipped file with such a name, in the folder data of the source
/// tree or the installation. Returns `name` itself if there is no such file, or
/// if it is already a path (with an ending or a slash).
std::string shipped_file(Shipped kind, const std::string& name);

/// `: did you mean "steel_bronze"?` for an unknown name, if a shipped name or
/// another word is similar; else "".
std::string shipped_hint(Shipped kind, std::string_view name,
                         std::vector<std::string> words = {});

/// "a joint file", "a case file" or "a study file", by its keys; "" for another
/// file and one that is not TOML, which its reader refuses.
std::string_view kind_of_file(const std::string& file);

/// Throws contact::Error if a file is of another kind than `wanted`: "FILE is a
/// joint file; PROGRAM takes WANTED".
void refuse_other_file(std::string_view program, const std::string& file,
                       std::string_view wanted);

/// What read() makes of a file; if it throws, the same refusal first, so that a
/// file that can be read is read once.
template <class Read>
auto read_as(std::string_view wanted, std::string_view program,
             const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const contact::Error&) {
    refuse_other_file(program, file, wanted);
    throw;
  }
}

}  // namespace cli
