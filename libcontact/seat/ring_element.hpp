#pragma once

#include <Eigen/Core>

#include "libcontact/pair/material.hpp"

namespace contact::detail {

/// Places of an element's nodes in a half-plane through the axis, (x, z): the
/// corners anticlockwise, then the middles of the sides 0-1, 1-2, 2-3, 3-0.
using RingElementNodes = Eigen::Matrix<double, 8, 2>;

/// Stiffness of a ring whose section is an element of eight nodes, for
/// displacements (U cos m phi, W cos m phi, V sin m phi) along x, z and around
/// the axis, node by node in this order; sums over x dx dz, without the
/// factor of the turn. Two Gauss points a side, which take materials that
/// hardly change their volume.
/// @param unit  modulus that the result is in units of, Pa
Eigen::Matrix<double, 24, 24> ring_stiffness(const RingElementNodes& nodes,
                                             int m, const Material& material,
                                             double unit);

}  // namespace contact::detail
