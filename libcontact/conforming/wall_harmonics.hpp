#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// Contribution of both bodies' walls to the equations of a contact, in units
/// of 4 rho/E.
struct WallHarmonics {
  /// @throws Error for layers so thin and nearly incompressible that the
  ///         solvers would lose all digits.
  WallHarmonics(JointKind kind, const LayeredPair& pair);

  /// Dc_n of both bodies together, n = 0, 1, ...; 0 at n = 1.
  std::vector<double> correction;
  /// c_0 of both bodies.
  double mean;
  /// c_1 of both bodies; NaN where it has no value.
  double first;
};

/// Thickness over the radius of an outer body that is free outside; infinite if
/// it has a backing.
double free_ring_thickness(const LayeredPair& pair);

/// Unknowns that the solvers of walled contacts need for 1e-6 of the load:
/// the edge of the contact has a layer as wide as the wall is thick, under a
/// ring that is free outside a fifth of that.
int walled_unknowns(const LayeredPair& pair);

/// Says where walls are too thin for the most unknowns to resolve their
/// pressure; "" otherwise.
std::string unresolved_note(const LayeredPair& pair);

/// Unknowns that the solutions by the gap (PinGap, BallGap) need for 1e-9.
int gap_unknowns(const LayeredPair& pair);

/// Whether the bodies can be pressed together all round, c_0 > 0: all but an
/// incompressible layer or body between rigid ones.
bool can_have_interference(JointKind kind, const LayeredPair& pair);

/// A pair of homogeneous bodies as one without layers.
LayeredPair without_layers(const ElasticPair& pair);

/// @throws Error for a coated inner body loaded through the back.
void require_uncoated(const LayeredPair& pair, const InnerLoading& loading);

}  // namespace contact::detail
