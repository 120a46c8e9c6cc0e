#include "multibody/dynamics_impl.hpp"

namespace multibody {

StateLayout::StateLayout(const std::vector<JointKind>& kinds,
                         const std::vector<JointMode>& modes) {
  offsets_.reserve(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    offsets_.push_back(size_);
    size_ += modes[i] == JointMode::released ? body_size
             : kinds[i] == JointKind::axis   ? 2
                                             : 7;
  }
}

template class Dynamics<double>;

}  // namespace multibody
