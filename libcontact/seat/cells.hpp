#pragma once

#include <Eigen/Core>
#include <array>

#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Polar angles that a grid covers: a zone, or the part of a zone about a much
/// narrower contact, which has no rim at its other end.
struct SeatWindow {
  explicit SeatWindow(const SeatZone& zone)
      : from(zone.from()),
        to(zone.to()),
        rim{zone.has_lower_rim(), zone.has_upper_rim()},
        is_free(zone.edge().side_face == SideFace::free) {}
  double width() const { return to - from; }
  double angle(int end) const { return end == 0 ? from : to; }

  double from, to;
  std::array<bool, 2> rim;  ///< lower, upper
  bool is_free;             ///< whether the body ends at a rim too
};

/// Cells of latitude over a window of a seat, and the shape that the pressure
/// has in each (docs/internals/seat_methods.md). In cell i it is p_i w_i(v),
/// w_i = a_i g(v) with the singular shape of a punch's edge at each rim,
///
///     g = prod sqrt(1 + b/s),   s = distance from the rim, rad,
///
/// and the mean of w_i over the cell's surface is 1. If the body ends at the
/// rim too, the pressure has no singularity, and g = 1.
struct SeatCells {
  /// @param count      of even cells over the window; cells near a rim shrink
  ///                   by 1.25 from one to the next, so the grid has more cells
  /// @param thickness  of the thinner surface layer over the radius; infinite
  ///                   without layers
  SeatCells(const SeatWindow& window, int count, double thickness);

  int size() const { return static_cast<int>(mean_shape.size()); }
  /// g(v)
  double shape(double v) const;
  /// lim g sqrt(s) at the lower (0) or upper (1) rim; 0 if g = 1.
  double rim_shape(int rim) const;
  int rim_cell(int rim) const { return rim == 0 ? 0 : size() - 1; }
  /// Smallest cell, rad.
  double smallest() const;

  /// A rule for smooth functions times w_i sin v over every cell.
  struct Rule {
    Eigen::ArrayXd angle;   ///< v
    Eigen::ArrayXd weight;  ///< w_i sin v dv
    Eigen::ArrayXi cell;
  };
  /// @param degree  of the Legendre functions that the rule integrates
  Rule rule(int degree) const;

  SeatWindow window;
  double edge_width;     ///< b, rad
  Eigen::ArrayXd bound;  ///< boundaries v of the cells, size() + 1
  /// a_i, and the moments of w_i sin v: of 1, sin v, cos v.
  Eigen::ArrayXd mean_shape, unit, sine, cosine;
  /// The means of v and v^2 with the weight w_i sin v.
  Eigen::ArrayXd mean_angle, mean_square;

 private:
  Rule rule_of_shape(int degree) const;
};

}  // namespace contact::detail
