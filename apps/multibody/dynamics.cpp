#include "multibody/dynamics_impl.hpp"

namespace multibody {

template class Dynamics<double>;

}  // namespace multibody
