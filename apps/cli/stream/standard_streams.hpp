#pragma once

#include <string_view>

namespace cli {

/// Opens standard input, output and error on /dev/null if they are closed.
/// Otherwise a file opened later would take their descriptor and receive the
/// table or the warnings. Reading a missing input and writing to a missing
/// output still fail.
/// @throws contact::Error if /dev/null cannot be opened
void open_missing_streams();

/// --quiet: neither notes nor progress are printed.
inline bool quiet = false;

/// Writes to standard error; if that fails, the text is lost and nothing else.
void say(std::string_view text);

}  // namespace cli
