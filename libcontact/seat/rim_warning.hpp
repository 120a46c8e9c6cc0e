#pragma once

#include <optional>
#include <string>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Exponent of the pressure at a corner c of the seat whose side face is free,
/// p ~ s^(l - 1) at the distance s, under a rigid ball: Williams' wedge of
/// twice the angle, l sin 2c + sin 2 l c = 0. -1/2 at 180 deg, 0 at 90; below,
/// where p falls to 0, NaN.
/// @param corner  rad, (0, pi]
double corner_exponent(double corner);

/// What finite elements of seats with free side faces say of contacts at rims
/// and beside them: docs/explanation/seats.md, "What is neglected".
class RimWarning {
 public:
  /// By how much the free face makes them larger, per cent of the confined
  /// contact's, at most.
  struct Largest {
    double pressure;  ///< in the middle
    double approach;
  };

  /// @param cure  how the side face is computed, or why it is not
  RimWarning(const LayeredPair& pair, const SeatZone& zone, std::string cure);

  /// Distance from a rim within which contacts are warned of, rad.
  double reach(int rim) const;

  /// None where no finite elements are. Of cups it bounds all of 1,387 of them
  /// (pressures by a factor of 1.6, approaches of 1.8 in the median), whose
  /// pressures with corners of 100 deg and more are up to 1.2 % smaller
  /// (seat/rim_warning_test.cpp has 127 others).
  /// @param direction   polar angle of the load, rad
  /// @param half_angle  of the contact that no rim confines, rad; NaN: unknown
  std::optional<Largest> largest(int rim, double direction,
                                 double half_angle) const;

  /// The warning.
  /// @param is_reached  the rim, by the contact
  std::string sentence(int rim, bool is_reached, double direction,
                       double half_angle) const;

 private:
  std::optional<Largest> of_cup(int rim, double direction,
                                double half_angle) const;
  std::optional<Largest> of_ring(double direction, double corner) const;

  SeatZone zone_;
  std::string cure_;
  bool is_known_;         // one layer on a rigid backing, under a bare ball
  double thickness_ = 0;  // of the layer, over the radius
  double poissons_ratio_;
  double share_;  // of the seat in the compliance of the surfaces
};

}  // namespace contact::detail
