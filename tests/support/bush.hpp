#pragma once

#include "libcontact/joint/spec.hpp"

namespace contact::test {

/// A steel pin of 40 mm in a bronze bush of 4 mm in a steel lug that is held
/// outside, 50 mm long: data/joints/relieved_bush.toml.
inline JointSpec bush_of(const FrictionLaw& friction, const Relief& relief,
                         JointBody inner) {
  const Material steel = {210e9, 0.3};
  return {.geometry = JointGeometry::pin(0.02, 2e-5, 0.05, inner),
          .inner = steel,
          .outer = {{{0.004, {110e9, 0.34}}, {0.02, steel}}, Backing::held()},
          .friction = friction,
          .relief = relief};
}

}  // namespace contact::test
