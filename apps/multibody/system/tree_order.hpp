#pragma once

#include <vector>

namespace multibody {

/// Bodies in an order with children after parents; roots alone keep their
/// order.
/// @param parents  index of each body's parent; -1: none
/// @throws contact::Error naming the body: a missing parent, a circle (with its
///   bodies), a body that hangs on itself
std::vector<int> parents_first(const std::vector<int>& parents);

}  // namespace multibody
