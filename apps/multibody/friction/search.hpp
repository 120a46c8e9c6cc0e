#pragma once

#include "multibody/friction/hinges.hpp"

namespace multibody {

/// All friction moments that fit the reactions they cause, where the outer
/// loop does not settle the matter: rare, and allowed to allocate. They become
/// the evaluation's solutions, and its report says how many there are; if there
/// is one alone the hinges get it. Where the report of the loop is ok the last
/// moments are one of them.
void search(Hinges& hinges);

}  // namespace multibody
