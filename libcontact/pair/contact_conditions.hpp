// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact {

/// Sign of a joint's radial clearance. A law that allows one value allows those
/// before it.
enum class Clearance {
  positive,      ///< above 0
  none,          ///< 0
  interference,  ///< below 0
};
Clearance clearance_of(double radial_clearance);

/// Conditions of a contact beside the materials of its two surfaces. The usual
/// case, which every law knows: a force at the centre of the ball or pin, both
/// bodies homogeneous, the outer one infinite, and a clearance.
struct ContactConditions {
  InnerLoading loading = InnerLoading::centre();
  /// Walls and coatings. walls->surfaces() then gives the materials at the
  /// surfaces.
  std::optional<LayeredPair> walls = {};
  Clearance clearance = Clearance::positive;

  friend bool operator==(const ContactConditions&,
                         const ContactConditions&) = default;
};

/// Joints for which a law was made whose constants depend on them.
class MadeFor {
 public:
  /// The materials and all other conditions.
  explicit MadeFor(const ElasticPair& pair, ContactConditions conditions = {});
  /// Any materials of this ratio of the moduli, the usual conditions.
  explicit MadeFor(double modulus_ratio) : modulus_ratio_(modulus_ratio) {}

  /// Whether the law holds for these too: ratios of the moduli, Poisson's
  /// ratios of bodies that are not rigid, loading and walls but for names.
  bool fits(const ElasticPair& pair, const ContactConditions& conditions) const;

  const InnerLoading& loading() const { return conditions_.loading; }

 private:
  double modulus_ratio_;
  std::optional<ElasticPair> pair_ = {};
  ContactConditions conditions_ = {};
};

/// For messages of laws that do not know them: "interference", "no clearance",
/// "finite walls", or "loading back:20".
std::string to_string(const ContactConditions& conditions);

}  // namespace contact
