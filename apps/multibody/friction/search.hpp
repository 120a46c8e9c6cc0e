#pragma once

#include <vector>

#include "multibody/friction/hinges.hpp"

namespace multibody {

/// All friction moments that fit the reactions they cause, where the outer
/// loop does not settle the matter: rare, and allowed to allocate. If there is
/// one alone the hinges get it.
/// @param report  of the loop, with the last moments in the hinges if it is
///                ok; says then how many there are
std::vector<CoupledSolution> search(Hinges& hinges, CoupledReport& report);

}  // namespace multibody
