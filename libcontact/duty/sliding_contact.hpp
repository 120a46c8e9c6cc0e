// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact {
namespace detail {
class ExpandedPressure;
class PressureProfile;
}  // namespace detail

/// Quantities that bearings are rated by, over the contact of a joint that
/// slides: slip, p v, and the heat flux, which is friction stress times slip
/// and heats both bodies together. All of it is 0 at rest and without load, NaN
/// where the solution is NaN.
///
/// Places are unit vectors r from the joint's centre, of a pin normal to its
/// axis; frame and signs as in Joint. Theory: docs/how-to/duty.md.
///
/// Refers to the contact and must not outlive it. Const functions neither
/// allocate nor throw.
class SlidingContact {
 public:
  /// Largest value of a quantity over the contact, and its place.
  struct Peak {
    double value;
    double theta;           ///< from the contact's centre, rad
    Eigen::Vector3d place;  ///< unit vector from the joint's centre
  };
  /// The numbers alone, without what they refer to.
  struct Rating {
    Peak pv;                  ///< largest p |v|, W/m^2
    Peak heat_flux;           ///< largest, W/m^2
    double pv_mean;           ///< W/m^2
    double pv_nominal;        ///< W/m^2
    double nominal_area;      ///< JointGeometry's, m^2
    double pv_total;          ///< integral of p |v|, W
    double heat;              ///< W
    double slip_coefficient;  ///< L
    bool slides;              ///< else angles and places have no meaning
  };

  /// @param solution  of a joint with this contact
  /// @param angular_velocity  Dw of that solution, rad/s
  SlidingContact(const JointContact& contact, const JointSolution& solution,
                 const Eigen::Vector3d& angular_velocity);
  SlidingContact(const JointContact&&, const JointSolution&,
                 const Eigen::Vector3d&) = delete;

  /// Unit vector from the joint's centre to the contact's.
  const Eigen::Vector3d& centre() const { return centre_; }
  /// p, Pa; 0 outside of the contact.
  double pressure(const Eigen::Vector3d& place) const noexcept;
  /// Velocity of the body's surface over the carrier's, m/s.
  Eigen::Vector3d slip(const Eigen::Vector3d& place) const noexcept;
  /// p |v|, W/m^2.
  double pv(const Eigen::Vector3d& place) const noexcept;
  /// Heat that friction makes on unit area, W/m^2; 0 outside of the contact.
  double heat_flux(const Eigen::Vector3d& place) const noexcept;

  /// Both lie in the plane of n and Dw, on the side turned away from Dw, and
  /// off the centre unless a = 0. theta to 1e-12, 1e-7 where under thin walls
  /// the pressure does not fall from the centre to the edge and for the heat
  /// flux of a FrictionStress, which is taken to grow with the slip
  /// (duty/sliding_contact_test.cpp, against closed forms).
  /// Each call searches; peaks() finds both at once.
  Peak largest_pv() const noexcept { return search(true, false).pv; }
  Peak largest_heat_flux() const noexcept {
    return search(false, true).heat_flux;
  }
  struct Peaks {
    Peak pv;
    Peak heat_flux;
  };
  Peaks peaks() const noexcept { return search(true, true); }

  /// L, the mean of |v|/(rho |Dw|) with the weight p, times S: of a pin S.
  /// Infinite where interference presses without load.
  double slip_coefficient() const { return slip_coefficient_; }
  /// Integral of p |v| over the contact, W: rho |Dw| R_n L.
  double pv_total() const { return pv_total_; }
  /// pv_total() over the area of the contact, W/m^2.
  double pv_mean() const noexcept;
  /// R over the projected area of JointGeometry::nominal_pressure(), times
  /// rho |Dw|, W/m^2.
  double pv_nominal() const { return pv_nominal_; }
  /// Integral of the heat flux, W: minus the power of friction, to 1e-12
  /// (duty/sliding_contact_test.cpp).
  double heat() const { return heat_; }

  /// All numbers at once; searches for both peaks.
  Rating rating() const noexcept;

 private:
  /// A friction stress or p itself: (pressure_part p + constant_part) times
  /// |v| to some power. Not of FrictionStress.
  struct Stress {
    double pressure_part;
    double constant_part;
    int power;
  };
  using Expanded = std::optional<detail::ExpandedPressure>;
  /// On the parallel theta, where the slip is largest.
  double value(const Stress& stress, double theta) const noexcept;
  /// The peaks that are wanted.
  Peaks search(bool pv, bool heat_flux) const noexcept;
  Peak largest(const Stress& stress, const Expanded& expanded) const noexcept;
  Peak peak_at(double theta, double value) const noexcept;
  Peak largest_of_stress() const noexcept;
  double peak_angle(const Stress& stress,
                    const Expanded& expanded) const noexcept;
  void add_totals(const JointSolution& solution) noexcept;
  void add_slip(const JointSolution& solution) noexcept;
  bool is_at_work() const noexcept { return rim_speed_ > 0; }
  double share_of_speed(double theta) const noexcept;
  double pressure_at(double theta) const noexcept;

  const JointContact* contact_;
  std::shared_ptr<const detail::PressureProfile> profile_;
  Eigen::Vector3d angular_velocity_;
  Eigen::Vector3d centre_;
  double half_angle_;
  double normal_force_;
  double pressure_unit_;  // Pa
  double uniform_pressure_ = 0;
  double rim_speed_;    // rho |Dw|, m/s
  SlipAxis axis_;       // sin a >= 0
  Stress heat_stress_;  // friction stress in q
  double slip_coefficient_ = 0;
  double pv_total_ = 0;
  double heat_ = 0;
  double pv_nominal_ = 0;
};

}  // namespace contact
