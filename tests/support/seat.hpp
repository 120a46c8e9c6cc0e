#pragma once

#include <Eigen/Core>

#include "libcontact/base/units.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// Rows of data/reference/edges/edges_ball.csv.
namespace contact::test {

inline JointSpec joint_of(const ReferenceTable::Row& row) {
  const ReferenceBodies bodies = reference_bodies(row);
  return {
      .geometry = JointGeometry::ball(row.value("rho"), row.value("clearance")),
      .inner = bodies.inner,
      .outer = bodies.outer};
}

inline SeatZone with_side_face(const SeatZone& zone, SideFace side_face) {
  SeatEdge edge = zone.edge();
  edge.side_face = side_face;
  return zone.with_edge(edge);
}

inline SeatZone zone_of(const ReferenceTable::Row& row) {
  return {row.value("v1_deg") * degree, row.value("v2_deg") * degree};
}

inline Eigen::Vector3d force_of(const ReferenceTable::Row& row) {
  const SineCosine at = detail::sine_cosine_deg(row.value("dir_deg"));
  return row.value("load") * Eigen::Vector3d(at.sin, 0, at.cos);
}

// The reference truncated the contact of this row at 82 deg, the end of its
// window of latitudes: v_high_deg is 82.000. Seat.TheCutRow tests it.
inline bool is_cut(const ReferenceTable::Row& row) {
  return row.text("id") == "ge50_steel" && row.text("load") == "300000" &&
         row.text("dir_deg") == "60";
}

}  // namespace contact::test
