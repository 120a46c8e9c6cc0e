#include "multibody/system/state_layout.hpp"

namespace multibody {
namespace {

std::vector<HingeKind> kinds_of(const System& system) {
  std::vector<HingeKind> kinds;
  for (const Link& link : system.links()) kinds.push_back(link.kind);
  return kinds;
}

}  // namespace

StateLayout::StateLayout(const std::vector<HingeKind>& kinds,
                         const std::vector<JointMode>& modes) {
  offsets_.reserve(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    offsets_.push_back(size_);
    size_ += link_size(kinds[i], modes[i]);
  }
}

StateLayout::StateLayout(const System& system,
                         const std::vector<JointMode>& modes)
    : StateLayout(kinds_of(system), modes) {}

}  // namespace multibody
