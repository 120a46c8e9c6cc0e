#pragma once

#include <vector>

#include "libcontact/base/vector_rows.hpp"
#include "multibody/system/linear3.hpp"

namespace multibody {

/// Loads on a body, link axes: active force and moment about the centre of
/// mass, both without gravity, and the moment of friction in its joint (the
/// opposite one acts on the carrier).
template <class T>
struct LinkForces {
  Vec3<T> force{};     ///< F_ia, N
  Vec3<T> moment{};    ///< N m
  Vec3<T> friction{};  ///< M_it, N m; ignored while the joint is held
};

/// Loads on the carrier, carrier axes, without gravity.
template <class T>
struct CarrierActiveForces {
  Vec3<T> force{};   ///< F_0a, N
  Vec3<T> moment{};  ///< about the centre of mass, N m
};

/// All given loads on the bodies, without uniform gravity, which moves all
/// bodies alike.
template <class T>
struct ActiveForces {
  CarrierActiveForces<T> carrier;
  std::vector<LinkForces<T>> bodies;
};

/// Vectors of all bodies.
using contact::VectorRows;

/// Reaction on a body in its joint, link axes.
template <class T>
struct Reaction {
  Vec3<T> force;  ///< R_i, including the friction force, N
  /// Moment about the hinge's centre, without the friction moment, N m: zero in
  /// a ball joint, normal to the axis on an axis, and in a held joint the
  /// moment that friction or a lock must hold.
  Vec3<T> moment;
};

}  // namespace multibody
