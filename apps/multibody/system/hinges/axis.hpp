#pragma once

#include <Eigen/Geometry>
#include <string>

#include "multibody/system/linear3.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// A body on an axis, link axes (z along the axis, hinge at (arm, 0, 0)).
/// x, y, z: the body's axes at angle zero in carrier axes; at the angle t its
/// x is cos t x + sin t y. Per unit rate about its axis the body has the
/// linear momentum -m arm y(t) and, about the carrier's centre of mass, the
/// angular momentum p(t) = p_1 + p_c cos t + p_s sin t.
template <class P>
struct AxisConstants {
  P mass, arm, mass_arm;
  P inverse_jzz;    ///< 1/(I_zz + m arm^2)
  P k;              ///< m arm/J_zz
  Sym3<P> inertia;  ///< about the centre of mass
  Mat3<P> zero;     ///< x, y, z
  Vec3<P> hinge;    ///< foot of the perpendicular, carrier axes
  Vec3<P> p_1, p_cos, p_sin;
  /// The body's part of F, (1.7): f_1 + f_c cos t + f_s sin t + ...
  Sym3<P> f_1, f_cos, f_sin, f_cos2, f_sin2;
  P pole_offset;
};

/// An axis node: one turn about the common axis of its joints. Its state:
/// angle, rate.
struct AxisHinge {
  static constexpr HingeTraits traits{
      .state_size = 2, .quaternion = -1, .is_axis = true, .arm_axis = 0};
  static Link link(const Body& body, const std::string& place);
  static AxisConstants<double> constants(const Link& link);

  static Eigen::Matrix3d rotation(const Link& link, const double* s) {
    return link.axes_to_carrier_zero *
           Eigen::AngleAxisd(s[0], Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  static Eigen::Vector3d rate(const double* s) { return {0, 0, s[1]}; }
  static void set_rate(double* s, const Eigen::Vector3d& rate) {
    s[1] = rate.z();
  }
  /// Writes a start (BodyStart) into the state.
  template <class Start>
  static void put(const Start& start, const Link&, const std::string&,
                  double* to) {
    to[0] = start.angle;
    to[1] = start.angle_rate;
  }
  static double angle(const double* s) { return s[0]; }
};

}  // namespace multibody
