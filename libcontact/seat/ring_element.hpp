#pragma once

#include <Eigen/Core>

#include "libcontact/pair/material.hpp"

namespace contact::detail {

/// Nodes of an element in a half-plane through the axis, (x, z): the corners
/// anticlockwise, then the middles of the sides 0-1, 1-2, 2-3, 3-0.
using RingElementNodes = Eigen::Matrix<double, 8, 2>;

/// Stiffness of a ring whose section is an element of eight nodes, for
/// displacements (U cos m phi, W cos m phi, V sin m phi) along x, z and around
/// the axis, node by node in this order; integrated over x dx dz, without the
/// factor of the integral over phi. Two Gauss points a side avoid locking in
/// nearly incompressible materials.
/// @param unit  modulus that is the unit of the result, Pa
Eigen::Matrix<double, 24, 24> ring_stiffness(const RingElementNodes& nodes,
                                             int m, const Material& material,
                                             double unit);

}  // namespace contact::detail
