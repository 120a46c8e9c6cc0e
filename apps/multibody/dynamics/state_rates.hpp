#pragma once

#include "multibody/system/linear3.hpp"
#include "multibody/system/state_layout.hpp"

/// Derivatives of the numbers of a state.
namespace multibody {

/// Rates of a quaternion at q and an angular velocity at w, both in the state
/// and in `to`.
template <class T>
[[gnu::always_inline]] inline void turn_rates(const T* state, int q, int w,
                                              const Vec3<T>& acceleration,
                                              T* to) {
  const Quaternion<T> rate = quaternion_rate(
      Quaternion<T>{state[q], state[q + 1], state[q + 2], state[q + 3]},
      Vec3<T>{state[w], state[w + 1], state[w + 2]});
  to[q] = rate.w;
  to[q + 1] = rate.x;
  to[q + 2] = rate.y;
  to[q + 3] = rate.z;
  to[w] = acceleration.x;
  to[w + 1] = acceleration.y;
  to[w + 2] = acceleration.z;
}

/// Rates of a body in inertial axes, whose numbers begin at `at`; accelerations
/// in its own axes.
template <class T>
[[gnu::always_inline]] inline void body_rates(const T* state, int at,
                                              const Vec3<T>& linear,
                                              const Vec3<T>& gravity,
                                              const Vec3<T>& angular, T* to) {
  const int q = at + StateLayout::rotation;
  const Vec3<T> a = rotation(Quaternion<T>{state[q], state[q + 1], state[q + 2],
                                           state[q + 3]}) *
                        linear +
                    gravity;
  const int v = at + StateLayout::velocity;
  const int x = at + StateLayout::position;
  to[x] = state[v];
  to[x + 1] = state[v + 1];
  to[x + 2] = state[v + 2];
  to[v] = a.x;
  to[v + 1] = a.y;
  to[v + 2] = a.z;
  turn_rates(state, q, at + StateLayout::angular_velocity, angular, to);
}

/// Rates of a held hinge.
template <HingeKind kind, class T>
[[gnu::always_inline]] inline void put_zeros(int at, T* to) {
  constexpr int n = StateLayout::link_size(kind, JointMode::held);
  for (int k = 0; k < n; ++k) to[at + k] = T(0.0);
}

/// Accelerations of a body for its rates, in its own axes.
template <class T>
struct BodyAcceleration {
  Vec3<T> linear;  ///< acceleration of a body without a hinge
  Vec3<T> turn;    ///< relative angular acceleration
};

}  // namespace multibody
