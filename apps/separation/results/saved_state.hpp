#pragma once

#include <string>
#include <string_view>

#include "separation/results/run.hpp"

namespace separation {

/// Text that is equal for equal runs: the content of the case file, the numbers
/// of its joints, which may come from other files, and the options.
std::string identity_of(const Case& c, const RunOptions& options);

/// An unfinished run as bytes, for storage elsewhere than in the files of a
/// CheckpointWriter, which costs less late in a run.
/// @param identity  of the run: identity_of()
std::string saved_bytes(const RunState& state, const std::string& identity);
/// @throws contact::Error if they are no state of a run, damaged, or of another
///   version or run
RunState saved_state(std::string_view bytes, const std::string& identity);

}  // namespace separation
