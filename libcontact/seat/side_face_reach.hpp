#pragma once

#include <Eigen/Core>
#include <functional>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/side_face.hpp"

namespace contact::detail {

/// Contacts that are too far from free side faces for these to change their
/// pressures. What such a side face yields more beneath them, du, is that of a
/// shift of the ball, du = D.r, but for a rest that is small beside the
/// approach: in first order the pressure stays, and the shift grows by D.
/// From coarse elements (du to 1e-2), with a pressure of Hertz' shape.
class SideFaceReach {
 public:
  /// Largest rest, root of the mean square, over the approach: pressures change
  /// by less than the grid's error, 3e-3 (seat/side_face_test.cpp).
  static constexpr double largest_rest = 5e-4;

  /// dF/da of a half-angle, N/m; NaN where it is unknown: such contacts are
  /// near at any distance.
  using Stiffness = std::function<double(double half_angle)>;

  SideFaceReach(const LayeredPair& pair, const SeatZone& zone,
                const Stiffness& stiffness);

  /// Largest half-angle of contacts that are far, rad.
  /// @param direction  polar angle of the load, in the zone
  double half_angle(double direction) const;

  /// How much more a contact yields.
  struct More {
    Eigen::Vector2d shift;  ///< D over the load, in its plane: x, z; m/N
    double rest;            ///< the rest of du, over the load
  };
  More more(double direction, double half_angle) const;

 private:
  double unit_;  // the unit of compliances
  SideFaceCompliance compliance_;
  double from_, step_;
  Eigen::ArrayXd largest_;  // by direction
};

}  // namespace contact::detail
