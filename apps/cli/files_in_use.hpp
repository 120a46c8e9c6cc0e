#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// What a program reads and what it writes: no regular file is both, by
/// whatever name or link. What is read by design where it is written, a journal
/// or a checkpoint, is not noted here.
namespace cli {

/// Where a name leads, through links; the file need not be there.
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
