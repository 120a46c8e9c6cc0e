#pragma once

namespace contact {

/// How a pin and the body around it grow along their axis.
enum class AxialGrowth {
  free,  ///< as what lies behind the layers does, or the outermost one
  held,  ///< not at all: plane strain
};

/// Temperatures of the two bodies of a joint, each the same throughout, K,
/// coldest to hottest.
struct Temperatures {
  /// Colder, and coefficients of expansion go to 0; hotter, and solids melt.
  static constexpr double coldest = 100;
  static constexpr double hottest = 2000;

  double inner;  ///< of the ball or pin with its coatings
  double outer;  ///< of the seat or hole with its layers and their backing
  /// At which the clearance was measured. ISO 1 has 20 deg C.
  double reference = 293.15;
  /// Of a pin; without influence for a ball.
  AxialGrowth axial = AxialGrowth::free;

  friend bool operator==(const Temperatures&, const Temperatures&) = default;
};

}  // namespace contact
