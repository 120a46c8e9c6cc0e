#pragma once

#include <vector>

namespace multibody {

/// Bodies in an order in which children come after parents; of roots alone,
/// their own.
/// @param parents  index of the body that each hangs on; -1: on none
/// @throws contact::Error naming the body: a parent that is not there, a
///   circle (with its bodies), a body that hangs on itself
std::vector<int> parents_first(const std::vector<int>& parents);

}  // namespace multibody
