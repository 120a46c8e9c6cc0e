#pragma once

#include <string_view>

namespace cli {

/// Has standard input, output and error be open, if need be on /dev/null: a
/// file that is opened later would take the place of one that is missing, and
/// get the table or the warnings. To read a missing input or to write to a
/// missing output fails as before.
/// @throws contact::Error if /dev/null cannot be opened
void open_missing_streams();

/// Writes to standard error. Where that cannot be written nothing is lost but
/// the text.
void say(std::string_view text);

}  // namespace cli
