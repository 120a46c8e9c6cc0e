#pragma once

#include "libcontact/joint/spec.hpp"
#include "support/wall.hpp"

namespace contact::test {

/// The joint of a row of data/reference/play/{force_law,impact}.csv.
inline JointSpec reference_joint(const ReferenceTable::Row& row) {
  const ReferenceBodies bodies = reference_bodies(row);
  const double rho = row.value("rho");
  const double clearance = row.value("clearance");
  return {
      .geometry = row.text("kind") == "ball"
                      ? JointGeometry::ball(rho, clearance)
                      : JointGeometry::pin(rho, clearance, row.value("length")),
      .inner = bodies.inner,
      .outer = bodies.outer};
}

/// A steel pin of 9.5 mm in a steel ring of the same thickness, play 0.5 mm, as
/// in slider_crank.csv.
inline JointSpec slider_crank_joint() {
  const Material steel = {207e9, 0.3};
  return {.geometry = JointGeometry::pin(0.0095, 0.0005, 0.02),
          .inner = steel,
          .outer = {{{0.0095, steel}}, Backing::held()}};
}

/// A steel ball of 12.5 mm in an unbounded steel seat, play 0.1 mm.
inline JointSpec steel_ball() {
  const Material steel = {207e9, 0.3};
  return {.geometry = JointGeometry::ball(0.0125, 1e-4),
          .inner = steel,
          .outer = steel};
}

}  // namespace contact::test
