// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/pair/relief.hpp"
#include "libcontact/play/force_law.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// Position of a finite-length pin in its hole, and the forces it needs.
///
/// Frame: z along the hole's axis from the middle of the contact; x and y
/// across. Forces are exerted by the pressures on the hole's surface, as the
/// shift points.
struct FinitePinState {
  Status status = Status::ok;
  int iterations = 0;
  double residual = 0;  ///< error of the load over its size

  Eigen::Vector2d shift;         ///< a of the pin's axis at z = 0, m
  Eigen::Vector2d tilt;          ///< psi, slope of the pin's axis: a + psi z
  Eigen::Vector2d force;         ///< F, N
  Eigen::Vector2d force_moment;  ///< G = sum of z F(z), N m: M_x = -G_y
  double energy;                 ///< U, J; F = dU/da, G = dU/dpsi
  /// Derivatives of F_x, F_y, G_x, G_y by a_x, a_y, psi_x, psi_y; symmetric.
  Eigen::Matrix4d stiffness;

  int pieces = 0;             ///< contacts along z: 0, 1 or more
  double low, high;           ///< their outermost ends, m; NaN without contact
  double peak_pressure;       ///< the largest p, Pa
  double peak_place;          ///< z of it, m
  double largest_half_angle;  ///< the largest theta0, rad
  double half_angle_place;    ///< z of it, m
  /// At z = -l/2 and l/2.
  std::array<double, 2> end_pressure, end_half_angle;
  /// The largest theta0 and the largest p.
  LargestContact largest() const {
    LargestContact all;
    all.add(largest_half_angle, peak_pressure);
    return all;
  }

  /// Sums for friction under turning about +z: of rho S, N m; of the area's
  /// tangents 2 rho sin(theta0) t and their z-moments, m^2 and m^3; of
  /// 2 rho^2 theta0, m^3. Sums of P t are F and G turned by 90 deg.
  double pressure_moment;
  Eigen::Vector2d area_tangent, area_tangent_moment;
  double area_moment;
};

/// A pin of finite length under a reaction, turning and sliding.
struct FinitePinSolution {
  FinitePinState contact;
  Eigen::Vector2d friction_force;  ///< R_t across the axis, N
  double axial_friction_force;     ///< on the body along the axis, N
  /// About the middle, N m: x and y of the contact with friction, z of friction
  Eigen::Vector3d moment;
};

/// A pin of finite length whose axis is shifted and tilted in its hole, with or
/// without relief of the ends: docs/how-to/finite_pin.md. Each slice obeys the
/// exact law of an endless pin (ForceLaw) with its own clearance; slices do not
/// feel each other, which is off within a length of rho sin(theta0), or the
/// wall's thickness if that is less, from where contact or pin end. The pin
/// does not bend.
///
/// A solution takes some 0.1 ms after the law, and no function but the
/// constructor throws. Several threads may share one.
///
/// Accuracy (finite_pin/finite_pin_test.cpp): all numbers within 1e-8 of
/// independent solutions, with liners thinner than 0.05 radii 5e-8.
class FinitePin {
 public:
  /// @param joint  a pin, whose laws are taken as exact
  /// @throws Error of a ball, of friction that is not dry, of a relief that
  ///   does not fit, and as ForceLaw does
  explicit FinitePin(const JointSpec& joint);
  /// The message of that Error, but for a relief; "" if there is none.
  /// @param asker  as of ForceLaw::refusal()
  static std::string refusal(const JointSpec& joint, std::string asker = {});

  /// With a shift and a tilt; out_of_range and NaN beyond the force law's end.
  FinitePinState at(const Eigen::Vector2d& shift,
                    const Eigen::Vector2d& tilt) const noexcept;
  /// Under a force, with a known tilt. Converged to 1e-12.
  FinitePinState under(const Eigen::Vector2d& force,
                       const Eigen::Vector2d& tilt) const noexcept;
  /// Under a force and its moment G: a load at z has G = z F.
  FinitePinState under_moment(const Eigen::Vector2d& force,
                              const Eigen::Vector2d& moment) const noexcept;

  /// Motion of the body relative to the carrier: about +z, rad/s, and along
  /// it, m/s. Of dry friction its direction counts alone.
  struct Motion {
    double rate = 0;
    double axial_velocity = 0;
  };
  /// Under a reaction R across the axis on the body, with a known tilt:
  /// R = s F + R_t, s = 1 if the carrier has the pin, else -1. A force on the
  /// axis balances friction along it.
  FinitePinSolution solve(const Eigen::Vector2d& reaction,
                          const Eigen::Vector2d& tilt,
                          const Motion& motion) const noexcept;
  FinitePinSolution solve(const Eigen::Vector2d& reaction,
                          const Eigen::Vector2d& tilt,
                          double rate) const noexcept {
    return solve(reaction, tilt, Motion{rate});
  }
  /// The same of a reaction that acts at z = place, m: the tilt is found.
  FinitePinSolution solve_at(const Eigen::Vector2d& reaction, double place,
                             const Motion& motion) const noexcept;
  FinitePinSolution solve_at(const Eigen::Vector2d& reaction, double place,
                             double rate) const noexcept {
    return solve_at(reaction, place, Motion{rate});
  }

  /// Friction of a contact that is known.
  FinitePinSolution friction(const FinitePinState& contact,
                             const Motion& motion) const noexcept;

  /// Speed of the surfaces on each other, the same everywhere, m/s.
  double slip_speed(const Motion& motion) const noexcept;
  /// p v: the largest pressure times the slip speed, W/m^2.
  double largest_pv(const FinitePinState& state,
                    const Motion& motion) const noexcept;
  double largest_pv(const FinitePinState& state, double rate) const noexcept {
    return largest_pv(state, Motion{rate});
  }

  /// The contact at one place along the pin, forces per length.
  struct Slice {
    Eigen::Vector2d direction;  ///< c of the force, a unit vector
    double distance;            ///< |a + psi z|, m
    double force;               ///< N/m; 0 without contact
    double slope;               ///< d force/d distance, N/m^2
    double energy;              ///< J/m
    double half_angle;          ///< theta0, rad
    double force_ratio;         ///< S
    double peak;                ///< the largest p, Pa
  };
  /// @param z  m, [-l/2, l/2]; there is no contact outside
  Slice slice(const FinitePinState& state, double z) const noexcept;
  /// p, Pa; 0 outside of the contact.
  /// @param theta  about +z from x, rad: a place of the hole, wherever the
  ///               contact's middle, the direction of the slice, is
  double pressure(const FinitePinState& state, double z,
                  double theta) const noexcept;
  /// The same at many angles, ten times as fast.
  void pressures(const FinitePinState& state, double z,
                 std::span<const double> theta,
                 std::span<double> out) const noexcept;

  const ForceLaw& force_law() const noexcept { return law_; }

 private:
  struct Interval;
  class Peaks;
  struct Sums;
  struct Polynomials;
  Polynomials polynomials(const Eigen::Vector4d& place,
                          const Relief::Piece& piece) const noexcept;
  Slice slice(const Eigen::Vector4d& place, double z,
              const Relief::Piece& piece) const noexcept;
  Slice slice_without_peak(const FinitePinState& state,
                           double z) const noexcept;
  double peak(const Slice& slice) const noexcept;
  const Relief::Piece& piece_at(double z) const noexcept;
  void find_peak(const Eigen::Vector4d& place,
                 const std::vector<Interval>& contacts,
                 FinitePinState& state) const noexcept;
  std::vector<Interval> intervals(const Eigen::Vector4d& place) const noexcept;
  Sums sums(const Eigen::Vector4d& place) const noexcept;
  FinitePinState state(const Eigen::Vector4d& place,
                       const Sums& all) const noexcept;
  Eigen::Vector4d start(const Eigen::Vector2d& force,
                        const Eigen::Vector2d& tilt) const noexcept;
  FinitePinState solved(const Eigen::Vector4d& load, bool tilts,
                        const Eigen::Vector2d& tilt) const noexcept;
  struct Slip;
  Slip slip(const Motion& motion) const noexcept;
  FinitePinSolution sliding(const Eigen::Vector4d& load, bool tilts,
                            const Eigen::Vector2d& tilt,
                            const Motion& motion) const noexcept;
  std::vector<double> summits(const Eigen::Vector4d& place,
                              const Interval& interval) const noexcept;

  JointSpec joint_;
  ForceLaw law_;
  std::shared_ptr<const PressureLaw> pressure_;
  std::vector<Relief::Piece> pieces_;
  double clearance_, half_length_;
  std::shared_ptr<const Peaks> peaks_;
};

}  // namespace contact
