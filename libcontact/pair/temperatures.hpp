// SPDX-License-Identifier: MIT
#pragma once

namespace contact {

/// How a pin and the body around it grow along their axis.
enum class AxialGrowth {
  free,  ///< as the body behind the layers, or the outermost one
  held,  ///< not at all: plane strain
};

/// Temperatures of the two bodies of a joint, each the same throughout, K,
/// coldest to hottest.
struct Temperatures {
  /// Colder, and coefficients of expansion go to 0; hotter, and solids melt.
  static constexpr double coldest = 100;
  static constexpr double hottest = 2000;

  double inner;  ///< the ball or pin with its coatings
  double outer;  ///< the seat or hole with its layers and their backing
  /// Temperature at which the clearance was measured; 20 deg C by ISO 1.
  double reference = 293.15;
  /// Growth of a pin along its axis; without influence on a ball.
  AxialGrowth axial = AxialGrowth::free;

  friend bool operator==(const Temperatures&, const Temperatures&) = default;
};

}  // namespace contact
