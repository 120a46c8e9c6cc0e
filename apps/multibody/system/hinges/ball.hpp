#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>

#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// A body on a ball joint, link axes (z along r, N diagonal). With the
/// inertia about the centre of mass I = U^T diag(i_x, i_y, I_zz) U, U the unit
/// matrix but for its third row (u_x, u_y, 1), and d = i + m arm^2:
///   N = diag(m i_y/d_y, m i_x/d_x, m),
/// so nothing cancels in the limit of a point mass on a thread.
template <class P>
struct BallConstants {
  P inverse_mass;
  P arm;
  P mass_arm;      ///< m arm
  P ix, iy, spin;  ///< i_x, i_y, I_zz
  P ux, uy;        ///< I_xz/I_zz, I_yz/I_zz
  P inverse_dx, inverse_dy;
  P kx, ky;        ///< m arm/d_x, m arm/d_y
  P inverse_spin;  ///< 1/I_zz; 0 for a point mass, which has no spin
  Vec3<P> n;       ///< diagonal of N_i
  P n_xy, n_zy;    ///< n_x - n_y, n_z - n_y
  Vec3<P> hinge;   ///< r_i0
};

/// Rotation of a quaternion of any length but 0.
inline Eigen::Matrix3d rotation_at(const double* q) {
  const Mat3<double> m = rotation(Quaternion<double>{q[0], q[1], q[2], q[3]});
  Eigen::Matrix3d result;
  result << vec3(m.x), vec3(m.y), vec3(m.z);
  return result;
}

/// A ball joint: three relative turns. Its state: quaternion (link axes to
/// carrier axes), relative angular velocity (link axes).
struct BallHinge {
  static constexpr HingeTraits traits{
      .state_size = 7, .quaternion = 0, .is_axis = false, .arm_axis = 2};
  static Link link(const Body& body, const std::string& place);
  static BallConstants<double> constants(const Link& link);

  static Eigen::Matrix3d rotation(const Link&, const double* s) {
    return rotation_at(s);
  }
  static Eigen::Vector3d rate(const double* s) { return {s[4], s[5], s[6]}; }
  static void set_rate(double* s, const Eigen::Vector3d& rate) {
    Eigen::Map<Eigen::Vector3d>(s + 4) = rate;
  }
  /// Writes a start (BodyStart) into the state.
  template <class Start>
  static void put(const Start& start, const Link& link,
                  const std::string& place, double* to) {
    const Eigen::Quaterniond q(Eigen::Matrix3d(
        checked_rotation(start.rotation, place + ".rotation") * link.axes));
    Eigen::Map<Eigen::Vector4d>{to} =
        Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()).normalized();
    set_rate(to, link.axes.transpose() * start.relative_angular_velocity);
  }
  static double angle(const double*) {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace multibody
