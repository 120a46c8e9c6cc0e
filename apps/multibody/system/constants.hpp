#pragma once

#include <cstddef>
#include <vector>

#include "multibody/system/linear3.hpp"
#include "multibody/system/system.hpp"

/// What never changes during a motion, worked out once per body. P is the
/// type of the parameters: double, or lanes if they differ between them.
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
BallConstants<double> ball_constants(const Link& link);

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
AxisConstants<double> axis_constants(const Link& link);

/// A body that does not turn in its joint, link axes; r is the hinge (axis:
/// the foot) from the centre of mass.
template <class P>
struct HeldConstants {
  P mass;
  Sym3<P> inertia;
  Vec3<P> r;
  Vec3<P> hinge;
  Mat3<P> zero;  ///< axis only: as in AxisConstants
  P pole_offset;
};
HeldConstants<double> held_constants(const Link& link);

/// A body of its own, link axes.
template <class P>
struct FreeConstants {
  P inverse_mass;
  Sym3<P> inertia;
  Sym3<P> inverse_inertia;  ///< 0 in directions without inertia
};
FreeConstants<double> free_constants(const Link& link);

/// All constants of a system.
class SystemConstants {
 public:
  explicit SystemConstants(const System& system);

  int size() const;
  double carrier_mass() const;
  const Sym3<double>& carrier_inertia() const;
  HingeKind kind(int body) const;
  /// Of a body of that kind.
  const BallConstants<double>& ball(int body) const;
  const AxisConstants<double>& axis(int body) const;
  /// Of any body.
  const HeldConstants<double>& held(int body) const;
  const FreeConstants<double>& free(int body) const;

 private:
  struct LinkConstants {
    HingeKind kind;
    BallConstants<double> ball;
    AxisConstants<double> axis;
    HeldConstants<double> held;
    FreeConstants<double> free;
  };
  double carrier_mass_;
  Sym3<double> carrier_inertia_;
  std::vector<LinkConstants> bodies_;
};

/// The constants of a body are a row of numbers of one type.
template <class Constants>
double number_of(const Constants& constants, std::size_t i) {
  return reinterpret_cast<const double*>(&constants)[i];
}
/// Sets them one by one: the i-th to number(i).
template <class P, template <class> class Constants, class F>
void set_numbers(Constants<P>& constants, F number) {
  static_assert(sizeof(constants) % sizeof(P) == 0);
  P* const to = reinterpret_cast<P*>(&constants);
  for (std::size_t i = 0; i < sizeof(constants) / sizeof(P); ++i) {
    to[i] = number(i);
  }
}

}  // namespace multibody
