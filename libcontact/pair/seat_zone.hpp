// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace contact {

/// Shape of the seat's body beyond a rim.
enum class SideFace {
  goes_on,  ///< as the laws without rims have it: only the contact ends
  free,     ///< it ends too, at a side face of SeatZone::side_angle()
};

/// How a seat is made at its rims, and how near to them pressures are reported.
struct SeatEdge {
  /// Radius of the rounding along the meridian, or of a chamfer's blend, m; 0
  /// if sharp.
  double radius = 0;
  /// Angle between the surface and the side face, in the seat's body, rad, (0,
  /// pi); SeatZone::side_angle() if left out.
  std::optional<double> angle = {};
  /// Distance of peak pressures and p v from rims, over the radius, (0, 1).
  double report_distance = 0.02;
  SideFace side_face = SideFace::goes_on;
  /// Elastic backing beside the layers if their side faces are free. `free`:
  /// the backing ends at faces that continue the side faces of the layers
  /// radially from the ball's centre.
  SideFace housing = SideFace::goes_on;

  friend bool operator==(const SeatEdge&, const SeatEdge&) = default;
};

/// Zone of a ball's seat, from <= v <= to in polar angles v from the seat's
/// axis, a surface of revolution that ends at its rims. A ring, a cup, a socket
/// with an opening; a value, validated once.
///
/// The axis is fixed in the body that has the seat, and given in its axes; z
/// unless told otherwise.
class SeatZone {
 public:
  /// Narrower zones are rejected: 1 deg.
  static constexpr double smallest_width = 0.017453292519943295;

  /// @param from, to  polar angles, rad, 0 <= from < to <= pi; at 0 and pi the
  ///                  zone goes on over the pole and has no rim there
  /// @throws Error if they are out of range or less than smallest_width apart.
  SeatZone(double from, double to);

  /// A radial bearing's ring: pi/2 -+ asin(width/(2 radius)).
  /// @param width   along the axis, m, (0, 2 radius)
  /// @param radius  rho of the ball, m
  static SeatZone ring(double width, double radius);

  /// A cup about the axis.
  /// @param half_angle  of its opening, rad, (0, pi]
  static SeatZone cup(double half_angle);

  /// The same zone about another axis.
  /// @param axis  of any length above 0, in the axes of the body that has the
  ///              seat; from the pole that polar angles are counted from
  SeatZone about(const std::array<double, 3>& axis) const;

  /// The zone with its rims moved in, which bounds the effect of a compliant
  /// side face (docs/explanation/seats.md). Only angles of side faces and areas
  /// of catalogues still refer to drawn().
  /// @param setback  rad, at least 0
  /// @throws Error if less than smallest_width is left.
  SeatZone moved_in(double setback) const;
  /// The zone before moved_in().
  SeatZone drawn() const;
  double setback() const { return setback_; }  ///< rad

  /// The same zone with other edges.
  /// @throws Error if a number is out of its interval.
  SeatZone with_edge(const SeatEdge& edge) const;
  const SeatEdge& edge() const { return edge_; }

  /// Unit vector.
  const std::array<double, 3>& axis() const { return axis_; }
  /// Whether angles from z are angles from the axis, either way round.
  bool is_about_z() const { return axis_[0] == 0 && axis_[1] == 0; }
  double from() const { return from_ + (has_lower_rim() ? setback_ : 0); }
  double to() const { return to_ - (has_upper_rim() ? setback_ : 0); }
  double width() const { return to() - from(); }
  bool has_lower_rim() const { return from_ > 0; }
  bool has_upper_rim() const;

  /// The half-angle, rad, of the largest cap inside the rims: of a contact in
  /// the middle that is about to reach one; infinite without rims.
  double reach() const;

  /// The area that catalogues put beneath a load, m^2: of a zone on both sides
  /// of its equator the ball's diameter times the width along the axis, else
  /// (cups, thrust bearings) its projection along the axis; of drawn().
  /// @param radius  rho of the ball, m
  double nominal_area(double radius) const;

  /// Whether pressures on the zone can carry a load in this direction: whether
  /// it lies inside the convex cone of the zone. A zone with points on both
  /// sides of its equator carries every load, one on a side of it only loads
  /// steeper than its outer rim.
  /// @param direction  polar angle of the load, rad, [0, pi]
  bool carries(double direction) const;

  /// How far a cap about a direction stays inside the rims, rad; below 0 it
  /// crosses one, infinite if there is none.
  /// @param direction   of the cap's middle, rad, [0, pi]
  /// @param half_angle  of the cap, rad
  double margin(double direction, double half_angle) const;

  /// The polar angle of the zone that is nearest to a direction, rad.
  double nearest(double direction) const;

  /// The angle in the seat's body between its surface and the side face at a
  /// rim, rad: the edge's own, else of a face normal to the axis, and beside an
  /// opening of less than 45 deg about it of a bore.
  /// @param rim  0 the lower, 1 the upper one
  double side_angle(int rim) const;
  /// True if side_angle() belongs to a bore unless the edge has its own.
  bool has_bore(int rim) const;

  friend bool operator==(const SeatZone&, const SeatZone&) = default;

 private:
  double from_;  // as drawn
  double to_;
  std::array<double, 3> axis_ = {0, 0, 1};
  double setback_ = 0;
  SeatEdge edge_ = {};
};

}  // namespace contact
