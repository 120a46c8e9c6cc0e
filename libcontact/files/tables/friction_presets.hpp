#pragma once

#include <span>
#include <string_view>

/// Friction coefficients that have been published, by the name of the surfaces.
namespace contact::detail {

/// The range of one pair of surfaces. Where it is of friction factors f_M,
/// which belong to bearings, f0 is up to 18 % smaller where a ball slides
/// (docs/how-to/identify.md): as f0 they err on the safe side.
struct FrictionPreset {
  std::string_view name;
  double least;
  double largest;
  std::string_view source;  ///< key of docs/reference/references.md

  /// A share of the way from the least to the largest; the middle.
  double at(double share) const { return least + share * (largest - least); }
  double middle() const { return at(0.5); }
};

/// All of them.
std::span<const FrictionPreset> friction_presets();

}  // namespace contact::detail
