#pragma once

#include <Eigen/Core>
#include <functional>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/side_face.hpp"

namespace contact::detail {

/// Contacts that are too far from free side faces for these to change their
/// pressures. The additional displacement du under such a contact equals a
/// shift of the ball, du = D.r, except for a remainder that is small compared
/// with the approach: in first order the pressure does not change, and the
/// shift grows by D. Uses coarse elements (du to 1e-2) and a pressure of Hertz'
/// shape.
class SideFaceReach {
 public:
  /// Largest remainder (root mean square) over the approach: pressures change
  /// by less than the grid's error, 3e-3 (seat/side_face_test.cpp).
  static constexpr double largest_rest = 5e-4;

  /// dF/da of a half-angle, N/m; NaN if unknown: such contacts count as near at
  /// any distance.
  using Stiffness = std::function<double(double half_angle)>;

  SideFaceReach(const LayeredPair& pair, const SeatZone& zone,
                const Stiffness& stiffness);

  /// Largest half-angle of far contacts, rad.
  /// @param direction  polar angle of the load, in the zone
  double half_angle(double direction) const;

  /// Additional displacement of a contact.
  struct More {
    Eigen::Vector2d shift;  ///< D over the load, in its plane: x, z; m/N
    double rest;            ///< remainder of du over the load
  };
  More more(double direction, double half_angle) const;

 private:
  double unit_;  // the unit of compliances
  SideFaceCompliance compliance_;
  double from_, step_;
  Eigen::ArrayXd largest_;  // by direction
};

}  // namespace contact::detail
