#pragma once

#include "multibody/system/hinges/axis.hpp"
#include "multibody/system/hinges/ball.hpp"

namespace multibody {

/// A body without a hinge has the state of StateLayout.
struct NoHinge {
  static constexpr HingeTraits traits{
      .state_size = 13, .quaternion = 6, .is_axis = false, .arm_axis = 2};
  struct None {};
  static Link link(const Body& body, const std::string&) {
    Link link{};
    link.axes = Eigen::Matrix3d::Identity();
    link.inertia = body.inertia;
    return link;
  }
  static None constants(const Link&) { return {}; }
  static Eigen::Matrix3d rotation(const Link&, const double* s) {
    return rotation_at(s + traits.quaternion);
  }
  static Eigen::Vector3d rate(const double* s) { return {s[10], s[11], s[12]}; }
  static void set_rate(double* s, const Eigen::Vector3d& rate) {
    Eigen::Map<Eigen::Vector3d>(s + 10) = rate;
  }
  template <class Start>
  static void put(const Start&, const Link&, const std::string&, double*) {}
  static double angle(const double*) {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

/// Calls f with the type of the kind. The type defines its HingeTraits, the
/// Link of a body, the constants for its kernel (multibody/dynamics) while it
/// turns, and the meaning of its state.
template <class F>
[[gnu::always_inline]] constexpr auto with_hinge(HingeKind kind, F f) {
  switch (kind) {
    case HingeKind::ball:
      return f(BallHinge());
    case HingeKind::axis:
      return f(AxisHinge());
    case HingeKind::none:
      break;
  }
  return f(NoHinge());
}

constexpr HingeTraits hinge_traits(HingeKind kind) {
  return with_hinge(kind, [](auto hinge) { return hinge.traits; });
}

}  // namespace multibody
