#pragma once

#include <cassert>
#include <tuple>
#include <vector>

#include "multibody/dynamics/axis_link.hpp"
#include "multibody/dynamics/ball_link.hpp"
#include "multibody/dynamics/free_link.hpp"
#include "multibody/dynamics/link_group.hpp"

namespace multibody {

/// The two-step resolution of section 1 of the paper for any scalar: each
/// body's reaction as a function of the carrier's accelerations, then the
/// carrier's own six equations, then the bodies. The work is proportional to
/// the number of bodies; no call but the constructor and set_mode allocates.
///
/// Programs use Dynamics.
/// @tparam T, S  see Lanes
template <class T, class S = T>
class TwoStep {
  using L = Lanes<T, S>;

 public:
  /// @param system  must outlive this object
  explicit TwoStep(const SystemConstants& system) : system_(system) {
    bodies_.resize(system.size());
    for (int i = 0; i < size(); ++i) {
      bodies_[i].kind = system.kind(i);
      bodies_[i].mode = system.kind(i) == HingeKind::none ? JointMode::released
                                                          : JointMode::turning;
    }
    for_groups([&](auto& group) { group.reserve(size()); });
    sort_bodies();
  }

  int size() const { return static_cast<int>(bodies_.size()); }
  JointMode mode(int body) const { return bodies_[body].mode; }
  void set_mode(int body, JointMode mode) {
    assert(bodies_[body].kind != HingeKind::none ||
           mode == JointMode::released);
    bodies_[body].mode = mode;
    sort_bodies();
  }

  /// Full evaluation, independent of positions, velocities of the centres of
  /// mass and the carrier's rotation.
  /// @param state  StateLayout::size() numbers
  /// @param bodies  size() times the 9 numbers of LinkForces
  void evaluate(const T* state, const CarrierActiveForces<T>& carrier,
                const T* bodies) {
    const Vec3<T> w = angular_velocity(state);
    const CarrierMotion<S> motion = spread_motion(w);
    CarrierMatrix<S> matrix = L::to_sum(fixed_);
    CarrierForces<S> forces{
        L::to_sum(carrier.force),
        L::to_sum(carrier.moment - cross(w, system_.carrier_inertia() * w))};
    // Two passes: one with everything in it runs out of registers.
    for_packets(
        [&](auto& packet) { set_motion(packet, state, motion, bodies); });
    for_packets([&](auto& packet) {
      packet.kernel.add_to(matrix);
      packet.kernel.add_to(forces);
    });
    solver_ = CarrierSolver<T>(L::sum(matrix));
    forces_ = {L::sum(forces.a), L::sum(forces.b)};
    carrier_ = solver_.solve(forces_);
  }

  /// First step alone: the carrier's motion is prescribed.
  void evaluate_prescribed(const T* state, const T* bodies,
                           const CarrierAcceleration<T>& carrier) {
    const CarrierMotion<S> motion = spread_motion(angular_velocity(state));
    for_packets(
        [&](auto& packet) { set_motion(packet, state, motion, bodies); });
    carrier_ = carrier;
  }

  /// After evaluate(): changes friction moments by `change`, link axes, 3
  /// numbers for each body, ignored for held and released joints. Motion,
  /// matrices and factors are reused.
  void add_friction(const T* change) {
    [[maybe_unused]] static constexpr double none[3] = {};
    add_changes([&](const auto& packet) {
      S m[3];
      L::read(packet.body, packet.body, change, 3, none, m);
      return Vec3<S>{m[0], m[1], m[2]};
    });
  }
  void add_friction(const VectorRows& change) {
    add_changes([&](const auto& packet) { return L::read(packet, change); });
  }

  const CarrierAcceleration<T>& carrier() const { return carrier_; }
  Vec3<T> relative_acceleration(int body) const {
    return visit(body, [&](const auto& kernel) {
      return kernel.relative_acceleration(L::spread(carrier_));
    });
  }
  /// take(body, relative_acceleration(body)) for all bodies, in any order.
  template <class F>
  [[gnu::always_inline]] void relative_accelerations(F take) const {
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Vec3<S> a = packet.kernel.relative_acceleration(carrier);
      for_lanes(packet,
                [&](int body, int lane) { take(body, L::at(a, lane)); });
    });
  }
  Vec3<T> angular_acceleration(int body) const {
    return visit(body, [&](const auto& kernel) {
      return kernel.angular_acceleration(L::spread(carrier_));
    });
  }
  Mat3<T> axes(int body) const {
    const auto column = [&](auto member) {
      return visit(body,
                   [&](const auto& kernel) { return kernel.axes().*member; });
    };
    return {column(&Mat3<S>::x), column(&Mat3<S>::y), column(&Mat3<S>::z)};
  }
  /// d(state)/dt after an evaluation of the same state.
  /// @param gravity  inertial axes
  /// @param to       to[i] = number
  void rates(const T* state, const Vec3<T>& gravity, T* to) const {
    body_rates(state, 0, carrier_.linear, gravity, carrier_.angular, to);
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Vec3<S> turn = packet.kernel.relative_acceleration(carrier);
      const Vec3<S> linear = linear_acceleration(packet.kernel);
      for_lanes(packet, [&](int body, int lane) {
        packet.kernel.put_rates(
            state, bodies_[body].offset, gravity,
            BodyAcceleration<T>{L::at(linear, lane), L::at(turn, lane)}, to);
      });
    });
  }

  /// Reactions of all bodies.
  void reactions(Reaction<T>* to) const {
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Reaction<S> r = packet.kernel.reaction(carrier);
      for_lanes(packet, [&](int body, int lane) {
        to[body] = {L::at(r.force, lane), L::at(r.moment, lane)};
      });
    });
  }
  void reactions(const VectorRows& force, const VectorRows* moment) const {
    const CarrierAcceleration<S> carrier = L::spread(carrier_);
    for_packets([&](const auto& packet) {
      const Reaction<S> r = packet.kernel.reaction(carrier);
      L::write(packet, r.force, force);
      if (moment) L::write(packet, r.moment, *moment);
    });
  }

 private:
  // change(packet): of its bodies' moments of friction.
  template <class F>
  [[gnu::always_inline]] void add_changes(F change) {
    CarrierForces<S> forces{L::to_sum(forces_.a), L::to_sum(forces_.b)};
    for_packets([&](auto& packet) {
      packet.kernel.add_friction(change(packet), forces);
    });
    forces_ = {L::sum(forces.a), L::sum(forces.b)};
    carrier_ = solver_.solve(forces_);
  }
  template <class Kernel>
  static Vec3<S> linear_acceleration(const Kernel& kernel) {
    if constexpr (requires { kernel.linear_acceleration(); }) {
      return kernel.linear_acceleration();
    } else {
      return {};
    }
  }

  template <template <class, class> class Kernel>
  using Group = LinkGroup<T, S, Kernel>;
  struct BodyInfo {
    HingeKind kind;
    JointMode mode;
    int packet;
    int lane;
    int offset;  ///< first number in the state
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
  // f(body, lane)
  template <class Packet, class F>
  [[gnu::always_inline]] static void for_lanes(const Packet& packet, F f) {
    for (int lane = 0; lane < L::width; ++lane) {
      if (packet.body[lane] >= 0) f(packet.body[lane], lane);
    }
  }
  // f(kernel) of the body's packet, in the body's lane.
  template <class F>
  Vec3<T> visit(int body, F f) const {
    const BodyInfo& info = bodies_[body];
    Vec3<T> result{};
    const auto in_group = [&](const auto& group) {
      if (group.serves(info.kind, info.mode)) {
        result = L::at(f(group.packets()[info.packet].kernel), info.lane);
      }
    };
    std::apply([&](const auto&... group) { (in_group(group), ...); }, groups_);
    return result;
  }

  // Puts every body into the packets of its present mode.
  void sort_bodies() {
    for_groups([](auto& group) { group.clear(); });
    int offset = StateLayout::body_size;
    for (int i = 0; i < size(); ++i) {
      BodyInfo& info = bodies_[i];
      info.offset = offset;
      for_groups([&](auto& group) {
        if (group.serves(info.kind, info.mode)) {
          group.add(i, offset, info.packet, info.lane);
        }
      });
      offset += StateLayout::link_size(info.kind, info.mode);
    }
    set_fixed_part();
    for_groups([&](auto& group) { group.finish(system_); });
    for_packets([&](const auto& packet) {
      fixed_ += L::sum(packet.kernel.fixed_part());
    });
  }

  // The carrier alone.
  void set_fixed_part() {
    const Sym3<double>& inertia = system_.carrier_inertia();
    fixed_ = {};
    fixed_.a.xx = fixed_.a.yy = fixed_.a.zz = system_.carrier_mass();
    fixed_.f += inertia;
  }

  static Vec3<T> angular_velocity(const T* state) {
    constexpr int w = StateLayout::angular_velocity;
    return {state[w], state[w + 1], state[w + 2]};
  }
  static CarrierMotion<S> spread_motion(const Vec3<T>& w) {
    const Vec3<S> spread = L::spread(w);
    return {spread, squared_cross(spread)};
  }
  template <class Packet>
  [[gnu::always_inline]] static void set_motion(Packet& packet, const T* state,
                                                const CarrierMotion<S>& motion,
                                                const T* bodies) {
    [[maybe_unused]] static constexpr double unturned[7] = {1};
    [[maybe_unused]] static constexpr double none[9] = {};
    S s[decltype(packet.kernel)::state_size];
    S f[9];
    L::read(packet.body, packet.offset, state, 1, unturned, s);
    L::read(packet.body, packet.body, bodies, 9, none, f);
    packet.kernel.set_motion(
        s, motion,
        {{f[0], f[1], f[2]}, {f[3], f[4], f[5]}, {f[6], f[7], f[8]}});
  }

  const SystemConstants& system_;
  CarrierMatrix<T> fixed_;  ///< the part that does not depend on the motion
  std::vector<BodyInfo> bodies_;
  /// The kernels of all kinds of hinges, turning and held.
  std::tuple<Group<BallLink>, Group<AxisLink>, Group<HeldBall>, Group<HeldAxis>,
             Group<FreeLink>>
      groups_;

  CarrierSolver<T> solver_;
  CarrierForces<T> forces_;
  CarrierAcceleration<T> carrier_;
};

}  // namespace multibody
