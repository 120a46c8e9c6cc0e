#pragma once

#include <algorithm>
#include <cassert>
#include <tuple>
#include <vector>

#include "multibody/axis_load.hpp"
#include "multibody/free_load.hpp"
#include "multibody/held_load.hpp"
#include "multibody/load_group.hpp"
#include "multibody/spherical_load.hpp"

namespace multibody {

/// The two-step resolution of section 1 of the paper for any scalar: each
/// load's reaction as a function of the carrier's accelerations, then the
/// carrier's own six equations, then the loads. The work is proportional to
/// the number of loads; no call but the constructor and set_mode allocates.
///
/// Programs use Dynamics (one motion in double) or Batch (many motions).
/// @tparam T, P, S  see Lanes
template <class T, class P = double, class S = T>
class TwoStep {
  using L = Lanes<T, P, S>;

 public:
  /// @param constants  Lanes::systems systems that differ in numbers only;
  ///                   they have to outlive this object
  explicit TwoStep(const SystemConstants* const* constants) {
    std::copy_n(constants, L::systems, systems_);
    const SystemConstants& first = *systems_[0];
    loads_.resize(first.size());
    for (int i = 0; i < size(); ++i) {
      loads_[i].kind = first.kind(i);
      loads_[i].mode = first.kind(i) == JointKind::none ? JointMode::released
                                                        : JointMode::turning;
    }
    for_groups([&](auto& group) { group.reserve(size()); });
    sort_loads();
  }

  int size() const { return static_cast<int>(loads_.size()); }
  JointMode mode(int load) const { return loads_[load].mode; }
  void set_mode(int load, JointMode mode) {
    assert(loads_[load].kind != JointKind::none || mode == JointMode::released);
    loads_[load].mode = mode;
    sort_loads();
  }

  /// Full evaluation. Positions, velocities of the centres of mass and the
  /// carrier's rotation do not matter here.
  /// @param state  StateLayout::size() numbers
  /// @param loads  size() of them
  void evaluate(const T* state, const CarrierLoading<T>& carrier,
                const LoadForces<T>* loads) {
    const Vec3<T> w = set_motion(state, loads);
    CarrierMatrix<S> matrix{};
    CarrierForces<S> forces{};
    for_packets([&](auto& packet) {
      packet.kernel.add_to(matrix);
      packet.kernel.add_to(forces);
    });
    CarrierMatrix<T> total = L::sum(matrix);
    total += fixed_;
    solver_ = CarrierSolver<T>(total);
    forces_.a = carrier.force + L::sum(forces.a);
    forces_.b = carrier.moment - cross(w, inertia_ * w) + L::sum(forces.b);
    carrier_ = solver_.solve(forces_);
    set_accelerations();
  }

  /// First step alone: the carrier's motion is prescribed.
  void evaluate_prescribed(const T* state, const LoadForces<T>* loads,
                           const CarrierAcceleration<T>& carrier) {
    set_motion(state, loads);
    carrier_ = carrier;
    set_accelerations();
  }

  /// After evaluate(): moments of friction changed by change[load], load axes,
  /// ignored where a joint is held or released. Motion, matrices and factors
  /// stay.
  void add_friction(const Vec3<T>* change) {
    [[maybe_unused]] static constexpr T none[3] = {};
    const T* const base = reinterpret_cast<const T*>(change);
    CarrierForces<S> forces{};
    for_packets([&](auto& packet) {
      S m[3];
      L::read(packet.load, packet.load, base, 3, none, m);
      packet.kernel.add_friction({m[0], m[1], m[2]}, forces);
    });
    forces_.a += L::sum(forces.a);
    forces_.b += L::sum(forces.b);
    carrier_ = solver_.solve(forces_);
    set_accelerations();
  }

  const CarrierAcceleration<T>& carrier() const { return carrier_; }
  const Vec3<T>& relative_acceleration(int load) const {
    return loads_[load].relative;
  }
  Vec3<T> angular_acceleration(int load) const {
    return visit(load, [&](const auto& kernel) {
      return kernel.angular_acceleration(L::spread(carrier_));
    });
  }
  Mat3<T> axes(int load) const {
    const auto column = [&](auto member) {
      return visit(load,
                   [&](const auto& kernel) { return kernel.axes().*member; });
    };
    return {column(&Mat3<S>::x), column(&Mat3<S>::y), column(&Mat3<S>::z)};
  }
  /// Of all loads.
  void reactions(Reaction<T>* to) const {
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Reaction<S> r = packet.kernel.reaction(carrier);
      for (int lane = 0; lane < L::width; ++lane) {
        const int load = packet.load[lane];
        if (load >= 0) {
          to[load] = {L::at(r.force, lane), L::at(r.moment, lane)};
        }
      }
    });
  }

 private:
  template <template <class, class> class Kernel>
  using Group = LoadGroup<T, P, S, Kernel>;
  struct LoadInfo {
    JointKind kind;
    JointMode mode;
    int packet;
    int lane;
    Vec3<T> relative;
  };

  template <class F>
  [[gnu::always_inline]] void for_groups(F f) {
    std::apply([&](auto&... group) { (f(group), ...); }, groups_);
  }
  template <class F>
  [[gnu::always_inline]] void for_packets(F f) {
    for_groups([&](auto& group) {
      for (auto& packet : group.packets()) f(packet);
    });
  }
  template <class F>
  [[gnu::always_inline]] void for_packets(F f) const {
    const auto in_group = [&](const auto& group) {
      for (const auto& packet : group.packets()) f(packet);
    };
    std::apply([&](const auto&... group) { (in_group(group), ...); }, groups_);
  }
  // f(kernel) of the load's packet, in the load's lane.
  template <class F>
  Vec3<T> visit(int load, F f) const {
    const LoadInfo& info = loads_[load];
    Vec3<T> result{};
    const auto in_group = [&](const auto& group) {
      if (group.serves(info.kind, info.mode)) {
        result = L::at(f(group.packets()[info.packet].kernel), info.lane);
      }
    };
    std::apply([&](const auto&... group) { (in_group(group), ...); }, groups_);
    return result;
  }

  // Every load into the packets of what it does at the moment.
  void sort_loads() {
    for_groups([](auto& group) { group.clear(); });
    int offset = StateLayout::body_size;
    for (int i = 0; i < size(); ++i) {
      LoadInfo& info = loads_[i];
      for_groups([&](auto& group) {
        if (group.serves(info.kind, info.mode)) {
          group.add(i, offset, info.packet, info.lane);
        }
      });
      offset += StateLayout::load_size(info.kind, info.mode);
    }
    set_fixed_part();
    for_groups([&](auto& group) { group.finish(systems_); });
    for_packets([&](const auto& packet) {
      fixed_ += L::sum(packet.kernel.fixed_part());
    });
  }

  // The carrier alone.
  void set_fixed_part() {
    const auto parameter = [&](auto get) {
      if constexpr (L::systems > 1) {
        return P([&](auto lane) { return get(*systems_[lane]); });
      } else {
        return P(get(*systems_[0]));
      }
    };
    fixed_ = {};
    fixed_.a.xx = fixed_.a.yy = fixed_.a.zz =
        parameter([](const SystemConstants& s) { return s.carrier_mass(); });
    for (P Sym3<P>::*p : {&Sym3<P>::xx, &Sym3<P>::yy, &Sym3<P>::zz,
                          &Sym3<P>::xy, &Sym3<P>::xz, &Sym3<P>::yz}) {
      const std::ptrdiff_t i = &(inertia_.*p) - &inertia_.xx;
      inertia_.*p = parameter([&](const SystemConstants& s) {
        return (&s.carrier_inertia().xx)[i];
      });
    }
    fixed_.f = inertia_;
  }

  Vec3<T> set_motion(const T* state, const LoadForces<T>* loads) {
    [[maybe_unused]] static constexpr T unturned[7] = {T(1.0)};
    [[maybe_unused]] static constexpr T none[9] = {};
    const T* const w = state + StateLayout::angular_velocity;
    const Vec3<T> velocity{w[0], w[1], w[2]};
    const Vec3<S> spread = L::spread(velocity);
    const CarrierMotion<S> motion{spread, squared_cross(spread)};
    const T* const forces = reinterpret_cast<const T*>(loads);
    for_packets([&](auto& packet) {
      S s[std::remove_reference_t<decltype(packet.kernel)>::state_size];
      S f[9];
      L::read(packet.load, packet.offset, state, 1, unturned, s);
      L::read(packet.load, packet.load, forces, 9, none, f);
      packet.kernel.set_motion(
          s, motion,
          {{f[0], f[1], f[2]}, {f[3], f[4], f[5]}, {f[6], f[7], f[8]}});
    });
    return velocity;
  }

  void set_accelerations() {
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Vec3<S> a = packet.kernel.relative_acceleration(carrier);
      for (int lane = 0; lane < L::width; ++lane) {
        const int load = packet.load[lane];
        if (load >= 0) loads_[load].relative = L::at(a, lane);
      }
    });
  }

  const SystemConstants* systems_[L::systems];
  Sym3<P> inertia_;
  CarrierMatrix<P> fixed_;  ///< what does not depend on the motion
  std::vector<LoadInfo> loads_;
  std::tuple<Group<SphericalLoad>, Group<AxisLoad>, Group<HeldSpherical>,
             Group<HeldAxis>, Group<FreeLoad>>
      groups_;

  CarrierSolver<T> solver_;
  CarrierForces<T> forces_;
  CarrierAcceleration<T> carrier_;
};

}  // namespace multibody
