#pragma once

#include "multibody/friction/hinges.hpp"

namespace multibody {

/// Searches for all friction moments consistent with their reactions, if the
/// outer loop does not decide: rare, and allowed to allocate. They become the
/// evaluation's solutions, and its report counts them; a single solution is
/// written to the hinges. If the report of the loop is ok, the last moments are
/// one of the solutions.
void search(Hinges& hinges);

}  // namespace multibody
