#pragma once

#include "libcontact/conforming/layer_compliance.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/temperatures.hpp"

namespace contact::detail {

/// How far the surface of a body moves from the centre, m, when it is warmed
/// throughout and touches nothing: docs/how-to/interference.md. Linear in the
/// warming; moduli and radius are those before it.
///
/// Accuracy (joint/thermal_growth_test.cpp): relative error below 1e-13
/// on the 16 rows of thermal.csv.
///
/// @param radius   rho, m
/// @param warming  K; 0 needs no thermal_expansion
/// @param axial    of a pin
/// @throws Error if a material has no thermal_expansion
double free_growth(JointKind kind, LayerCompliance::Side side,
                   const LayeredBody& body, double radius, double warming,
                   AxialGrowth axial);

/// The largest strain alpha dT in a body, in size.
double largest_free_strain(const LayeredBody& body, double warming);

}  // namespace contact::detail
