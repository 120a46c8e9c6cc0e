#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Inputs and outputs of the running program. No regular file may be both,
/// under any name or link. Journals and checkpoints are read and then
/// continued; they are not noted as outputs.
namespace cli {

/// Resolves the links of a name; the file need not exist.
std::filesystem::path destination(const std::filesystem::path& name);

/// Notes every file that the libraries and programs read from now on.
void note_reading();

/// Notes a file that will be written; "" and "-" are no files.
/// @throws contact::Error "OPTION NAME must be another file than FILE, which is
///   read", immediately or when FILE is read
void will_write(std::string_view option, const std::string& name);

/// @throws contact::Error if the file of this name has been read
void check_unread(const std::filesystem::path& name);

}  // namespace cli
