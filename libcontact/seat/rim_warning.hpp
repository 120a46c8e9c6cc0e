#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Exponent l - 1 of the pressure p ~ s^(l - 1) at the distance s from a corner
/// c of a seat with a free side face under a rigid ball: Williams' wedge of
/// twice the angle, l sin 2c + sin 2 l c = 0. -1/2 at 180 deg, 0 at 90 deg; NaN
/// below, where p falls to 0.
/// @param corner  rad, (0, pi]
double corner_exponent(double corner);

/// Errors of contacts at and near rims according to finite elements with free
/// side faces: docs/explanation/seats.md, "What is neglected".
class RimWarning {
 public:
  /// Upper bounds of the increase by the free face, in per cent of the confined
  /// contact.
  struct Largest {
    double pressure;  ///< in the middle
    double approach;
  };

  /// @param cure  text on how to compute the side face, or why this is
  ///              impossible
  RimWarning(const LayeredPair& pair, const SeatZone& zone, std::string cure);

  /// Largest distance from a rim at which a warning is given, rad.
  double reach(int rim) const;

  /// None outside the range of the finite elements. Bounds all of 1,387 cups
  /// (in the median too large by factors of 1.6 for pressures and 1.8 for
  /// approaches); with corners of 100 deg and more pressures may also be up to
  /// 1.2 % smaller (seat/rim_warning_test.cpp checks 127 other cups).
  /// @param direction   polar angle of the load, rad
  /// @param half_angle  of the contact without rims, rad; NaN: unknown
  std::optional<Largest> largest(int rim, double direction,
                                 double half_angle) const;

  /// Text of the warning.
  /// @param place       "its lower rim"
  /// @param is_reached  whether the contact reaches the rim
  std::string sentence(int rim, std::string_view place, bool is_reached,
                       double direction, double half_angle) const;

 private:
  std::optional<Largest> of_cup(int rim, double direction,
                                double half_angle) const;
  std::optional<Largest> of_ring(double direction, double corner) const;

  SeatZone zone_;
  std::string cure_;
  bool is_known_;         // one layer on a rigid backing, under a bare ball
  double thickness_ = 0;  // layer over radius
  double poissons_ratio_;
  double share_;  // seat's share of the surfaces' compliance
};

}  // namespace contact::detail
