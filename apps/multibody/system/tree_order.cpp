#include "multibody/system/tree_order.hpp"

#include <fmt/format.h>

#include <string>

#include "libcontact/base/error.hpp"

namespace multibody {
namespace {

void check(int i, int parent, int size) {
  if (parent == i) {
    throw contact::Error(fmt::format("bodies[{}] hangs on itself", i));
  }
  if (parent < -1 || parent >= size) {
    throw contact::Error(
        fmt::format("bodies[{}].parent = {} must be one of the {} bodies, or "
                    "-1 for a root",
                    i, parent, size));
  }
}

}  // namespace

std::vector<int> parents_first(const std::vector<int>& parents) {
  const int size = static_cast<int>(parents.size());
  for (int i = 0; i < size; ++i) check(i, parents[i], size);
  // From each body up to one that is in order, then down again.
  std::vector<int> order;
  std::vector<bool> done(parents.size(), false);
  for (int i = 0; i < size; ++i) {
    std::vector<int> up;
    for (int k = i; k >= 0 && !done[k]; k = parents[k]) {
      up.push_back(k);
      if (static_cast<int>(up.size()) <= size) continue;
      std::string circle = fmt::format("bodies[{}]", k);
      for (int j = parents[k]; j != k; j = parents[j]) {
        circle += fmt::format(" on bodies[{}]", j);
      }
      throw contact::Error(circle + fmt::format(" on bodies[{}]: a circle", k));
    }
    for (auto k = up.rbegin(); k != up.rend(); ++k) {
      done[*k] = true;
      order.push_back(*k);
    }
  }
  return order;
}

}  // namespace multibody
