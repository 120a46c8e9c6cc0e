#pragma once

#include <algorithm>
#include <cassert>

#include "multibody/dynamics.hpp"

/// Bodies of Dynamics for any scalar.
namespace multibody {
namespace detail {

// Constants as they are, or in another number type.
template <class P, template <class> class Constants>
Constants<P> as(const Constants<double>& constants) {
  if constexpr (std::is_same_v<P, double>) {
    return constants;
  } else {
    return converted<P, Constants>(constants);
  }
}

}  // namespace detail

template <class T, class P>
Dynamics<T, P>::Dynamics(const System& system)
    : inertia_(detail::as<P>(sym3(system.carrier().inertia))),
      mass_(system.carrier().mass) {
  for (const Link& link : system.links()) {
    kinds_.push_back(link.kind);
    modes_.push_back(link.kind == JointKind::none ? JointMode::released
                                                  : JointMode::turning);
    held_.emplace_back(detail::as<P>(held_constants(link)));
    free_.emplace_back(detail::as<P>(free_constants(link)));
    slots_.push_back(-1);
    if (link.kind == JointKind::spherical) {
      slots_.back() = static_cast<int>(spherical_.size());
      spherical_.emplace_back(detail::as<P>(spherical_constants(link)));
    } else if (link.kind == JointKind::axis) {
      slots_.back() = static_cast<int>(axes_.size());
      axes_.emplace_back(detail::as<P>(axis_constants(link)));
    }
  }
  relative_.resize(kinds_.size());
  sort_loads();
}

template <class T, class P>
void Dynamics<T, P>::set_mode(int load, JointMode mode) {
  assert(kinds_[load] != JointKind::none || mode == JointMode::released);
  modes_[load] = mode;
  sort_loads();
}

template <class T, class P>
void Dynamics<T, P>::sort_loads() {
  layout_ = StateLayout(kinds_, modes_);
  turning_spherical_.clear();
  turning_axes_.clear();
  held_now_.clear();
  free_now_.clear();
  fixed_ = {};
  fixed_.a.xx = fixed_.a.yy = fixed_.a.zz = mass_;
  fixed_.f = inertia_;
  for (int i = 0; i < size(); ++i) {
    const int slot = slots_[i];
    if (modes_[i] == JointMode::released) {
      free_now_.push_back(i);
    } else if (modes_[i] == JointMode::held) {
      held_now_.push_back(i);
    } else if (kinds_[i] == JointKind::spherical) {
      turning_spherical_.push_back({i, slot});
      fixed_ += spherical_[slot].fixed_part();
    } else {
      turning_axes_.push_back({i, slot});
      fixed_ += axes_[slot].fixed_part();
    }
  }
}

template <class T, class P>
void Dynamics<T, P>::set_motion(const T* state, const Loading<T>& loading,
                                const CarrierMotion<T>& motion) {
  assert(static_cast<int>(loading.loads.size()) == size());
  const auto at = [&](int load) { return state + layout_.offset(load); };
  for (const Entry& e : turning_spherical_) {
    spherical_[e.slot].set_motion(at(e.load), motion, loading.loads[e.load]);
  }
  for (const Entry& e : turning_axes_) {
    axes_[e.slot].set_motion(at(e.load), motion, loading.loads[e.load]);
  }
  for (const int i : held_now_) {
    if (kinds_[i] == JointKind::axis) {
      held_[i].set_motion_of_axis(at(i), motion, loading.loads[i]);
    } else {
      held_[i].set_motion_of_spherical(at(i), motion, loading.loads[i]);
    }
  }
  for (const int i : free_now_) {
    const T* w = at(i) + StateLayout::angular_velocity;
    free_[i].set_motion({w[0], w[1], w[2]}, loading.loads[i]);
  }
}

template <class T, class P>
void Dynamics<T, P>::evaluate(const T* state, const Loading<T>& loading) {
  const T* const velocity = state + StateLayout::angular_velocity;
  const Vec3<T> w{velocity[0], velocity[1], velocity[2]};
  set_motion(state, loading, {w, squared_cross(w)});

  CarrierMatrix<T> matrix = detail::as<T>(fixed_);
  forces_.a = loading.carrier_force;
  forces_.b = loading.carrier_moment - cross(w, inertia_ * w);
  for (const Entry& e : turning_spherical_) {
    spherical_[e.slot].add_to(matrix);
    spherical_[e.slot].add_to(forces_);
  }
  for (const Entry& e : turning_axes_) {
    axes_[e.slot].add_to(matrix);
    axes_[e.slot].add_to(forces_);
  }
  for (const int i : held_now_) {
    held_[i].add_to(matrix);
    held_[i].add_to(forces_);
  }
  solver_ = CarrierSolver<T>(matrix);
  carrier_ = solver_.solve(forces_);
  set_accelerations();
}

template <class T, class P>
void Dynamics<T, P>::evaluate_prescribed(
    const T* state, const Loading<T>& loading,
    const CarrierAcceleration<T>& carrier) {
  const T* const velocity = state + StateLayout::angular_velocity;
  const Vec3<T> w{velocity[0], velocity[1], velocity[2]};
  set_motion(state, loading, {w, squared_cross(w)});
  carrier_ = carrier;
  set_accelerations();
}

template <class T, class P>
void Dynamics<T, P>::add_friction(std::span<const Vec3<T>> change) {
  assert(static_cast<int>(change.size()) == size());
  for (const Entry& e : turning_spherical_) {
    spherical_[e.slot].add_friction(change[e.load], forces_);
  }
  for (const Entry& e : turning_axes_) {
    axes_[e.slot].add_friction(change[e.load], forces_);
  }
  carrier_ = solver_.solve(forces_);
  set_accelerations();
}

template <class T, class P>
void Dynamics<T, P>::set_accelerations() {
  for (const Entry& e : turning_spherical_) {
    relative_[e.load] = spherical_[e.slot].relative_acceleration(carrier_);
  }
  for (const Entry& e : turning_axes_) {
    relative_[e.load] = axes_[e.slot].relative_acceleration(carrier_);
  }
  for (const int i : held_now_) relative_[i] = Vec3<T>{};
  for (const int i : free_now_) {
    relative_[i] = free_[i].angular_acceleration();
  }
}

template <class T, class P>
template <class Result, class F>
Result Dynamics<T, P>::visit(int load, const Result& released, F f) const {
  if (modes_[load] == JointMode::released) return released;
  if (modes_[load] == JointMode::held) return f(held_[load]);
  if (kinds_[load] == JointKind::axis) return f(axes_[slots_[load]]);
  return f(spherical_[slots_[load]]);
}

template <class T, class P>
Vec3<T> Dynamics<T, P>::angular_acceleration(int load) const {
  return visit(load, relative_[load], [&](const auto& joint) {
    return joint.angular_acceleration(carrier_);
  });
}

template <class T, class P>
Reaction<T> Dynamics<T, P>::reaction(int load) const {
  return visit(load, Reaction<T>{},
               [&](const auto& joint) { return joint.reaction(carrier_); });
}

template <class T, class P>
Mat3<T> Dynamics<T, P>::axes(int load) const {
  return visit(load, Mat3<T>{}, [](const auto& joint) { return joint.axes(); });
}

}  // namespace multibody
