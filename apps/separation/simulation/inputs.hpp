// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"

namespace separation {

struct History;

/// A load from outside the case, as of a controller or a wheel: one component
/// of a force on a body at its centre of mass or of a moment, in the body's
/// axes, or the moment of a hinge on its body, about the axis, with the
/// opposite one on the body that carries the hinge, until that breaks.
struct Input {
  enum class Kind { force, moment, hinge_moment };
  int body;  ///< rigid body
  Kind kind;
  int component;     ///< 0 for the moment of a hinge
  std::string name;  ///< "NAME.applied_force_x_N"
};

/// All inputs of a case, in its order. None for a carrier that is fixed or
/// driven, on which loads do nothing; the moment of a hinge on axes only.
std::vector<Input> inputs_of(const Case& c);

/// Loads by the inputs of a history, constant until that changes.
class GivenLoads {
 public:
  /// @param c  must outlive this object
  GivenLoads(const Case& c, const History& history);
  void add_forces(std::span<const multibody::BodyMotion> bodies,
                  std::span<multibody::BodyForce> forces) const;

 private:
  struct Load {
    int body;
    Input::Kind kind;
    Eigen::Vector3d value;  ///< body's axes; of a hinge those of its parent
  };
  const Case& case_;
  std::vector<Load> loads_;  // other than 0
};

}  // namespace separation
