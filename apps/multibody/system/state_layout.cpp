#include "multibody/system/state_layout.hpp"

namespace multibody {
namespace {

std::vector<JointKind> kinds_of(const System& system) {
  std::vector<JointKind> kinds;
  for (const Link& link : system.links()) kinds.push_back(link.kind);
  return kinds;
}

}  // namespace

StateLayout::StateLayout(const std::vector<JointKind>& kinds,
                         const std::vector<JointMode>& modes) {
  offsets_.reserve(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    offsets_.push_back(size_);
    size_ += load_size(kinds[i], modes[i]);
  }
}

StateLayout::StateLayout(const System& system,
                         const std::vector<JointMode>& modes)
    : StateLayout(kinds_of(system), modes) {}

}  // namespace multibody
