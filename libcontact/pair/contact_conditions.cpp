#include "libcontact/pair/contact_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/pair/law_entry.hpp"

namespace contact {
namespace {

// Numbers that come by other arithmetic, as ratios and converted units do,
// differ by some roundings.
bool is_near(double a, double b) {
  constexpr double roundings = 1e-12;
  return a == b || std::abs(a - b) <= roundings * std::abs(b);
}

bool have_equal_constants(const Material& a, const Material& b) {
  return is_near(a.youngs_modulus, b.youngs_modulus) &&
         (std::isinf(a.youngs_modulus) ||
          is_near(a.poissons_ratio, b.poissons_ratio));
}

bool are_alike(const LayeredBody& a, const LayeredBody& b) {
  return std::ranges::equal(a.layers, b.layers,
                            [](const Layer& x, const Layer& y) {
                              return is_near(x.thickness, y.thickness) &&
                                     have_equal_constants(x.material,
                                                          y.material);
                            }) &&
         a.backing.kind() == b.backing.kind() &&
         have_equal_constants(a.backing.material(), b.backing.material());
}

bool are_alike(const LayeredPair& a, const LayeredPair& b) {
  return is_near(a.radius(), b.radius()) && are_alike(a.inner(), b.inner()) &&
         are_alike(a.outer(), b.outer());
}

}  // namespace

Clearance clearance_of(double radial_clearance) {
  if (radial_clearance < 0) return Clearance::interference;
  return radial_clearance == 0 ? Clearance::none : Clearance::positive;
}

std::string to_string(const ContactConditions& conditions) {
  switch (conditions.clearance) {
    case Clearance::interference:
      return "interference";
    case Clearance::none:
      return "no clearance";
    case Clearance::positive:
      break;
  }
  return conditions.walls ? "finite walls"
                          : "loading " + to_string(conditions.loading);
}

MadeFor::MadeFor(const ElasticPair& pair, ContactConditions conditions)
    : modulus_ratio_(pair.modulus_ratio()),
      pair_(pair),
      conditions_(std::move(conditions)) {}

bool MadeFor::fits(const ElasticPair& pair,
                   const ContactConditions& conditions) const {
  const auto& [loading, walls, clearance] = conditions;
  if (loading != conditions_.loading ||
      !is_near(pair.modulus_ratio(), modulus_ratio_) ||
      walls.has_value() != conditions_.walls.has_value()) {
    return false;
  }
  if (walls) return are_alike(*walls, *conditions_.walls);
  if (!pair_) return true;
  const auto fits_ratio = [](double share, const Material& a,
                             const Material& b) {
    return share == 0 || is_near(a.poissons_ratio, b.poissons_ratio);
  };
  return fits_ratio(pair.inner_compliance_share(), pair.inner(),
                    pair_->inner()) &&
         fits_ratio(pair.outer_compliance_share(), pair.outer(),
                    pair_->outer());
}

void detail::refuse_law(std::string_view kind, std::string_view name,
                        const std::vector<std::string>& allowed,
                        const ContactConditions& conditions) {
  throw Error(
      must_be(message("{} {}", kind, printable(name)),
              message("{} with {}", either(allowed), to_string(conditions))));
}

}  // namespace contact
