#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Inputs and outputs of the running program: no regular file is both, by
/// whatever name or link. Journals and checkpoints, which go on in the files
/// they have read, are not noted as outputs.
namespace cli {

/// The place that a name leads to through links; no file need be there.
std::filesystem::path destination(const std::filesystem::path& name);

/// From now on every file that the libraries and programs read is noted.
void note_reading();

/// Notes a file that is to be written; "" and "-" are none.
/// @throws contact::Error "OPTION NAME must be another file than FILE, which is
///   read" now or when it is read
void will_write(std::string_view option, const std::string& name);

/// @throws contact::Error if the file of this name has been read
void check_unread(const std::filesystem::path& name);

}  // namespace cli
