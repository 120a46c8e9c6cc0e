#include "libcontact/pair/material.hpp"

#include <cmath>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"

namespace contact {
namespace {

using detail::infinity;

void check_poissons_ratio(double nu, const std::string& place) {
  detail::require(nu >= 0 && nu <= 0.5, place, "poissons_ratio", nu,
                  "0 to 0.5");
}

double one_minus_square(double nu) { return (1 - nu) * (1 + nu); }

// b(nu) of Dundurs' beta.
double beta_part(double nu) { return (1 - 2 * nu) / (2 * (1 - nu)); }

}  // namespace

void detail::check_material(const Material& material, std::string place) {
  if (!material.name.empty()) place += " " + material.name;
  require(material.youngs_modulus > 0, place, "youngs_modulus",
          material.youngs_modulus, "above 0 Pa or inf for a rigid body");
  require(material.limit_pressure > 0, place, "limit_pressure",
          material.limit_pressure, "above 0 Pa or inf for none");
  check_poissons_ratio(material.poissons_ratio, place);
  const double expansion = material.thermal_expansion.value_or(0);
  require(std::abs(expansion) <= 1e-3, place, "thermal_expansion", expansion,
          "-0.001 to 0.001 per K");
}

ElasticPair::ElasticPair(const Material& inner, const Material& outer)
    : ElasticPair(inner, outer, inner.youngs_modulus / outer.youngs_modulus) {}

ElasticPair::ElasticPair(Material inner, Material outer, double modulus_ratio)
    : inner_(std::move(inner)),
      outer_(std::move(outer)),
      modulus_ratio_(modulus_ratio) {
  detail::check_material(inner_, "inner material");
  detail::check_material(outer_, "outer material");
  if (std::isinf(inner_.youngs_modulus) && std::isinf(outer_.youngs_modulus)) {
    throw Error(detail::conflicts("elastic pair: rigid inner body",
                                  "rigid outer body"));
  }
  const double c1 =
      one_minus_square(inner_.poissons_ratio) / inner_.youngs_modulus;
  const double c2 =
      one_minus_square(outer_.poissons_ratio) / outer_.youngs_modulus;
  const double sum = c1 + c2;
  contact_modulus_ = 1 / sum;
  inner_share_ = c1 / sum;
  outer_share_ = c2 / sum;
  dundurs_alpha_ = (c2 - c1) / sum;
  dundurs_beta_ = outer_share_ * beta_part(outer_.poissons_ratio) -
                  inner_share_ * beta_part(inner_.poissons_ratio);
}

ElasticPair ElasticPair::from_modulus_ratio(double modulus_ratio,
                                            double inner_poissons_ratio,
                                            double outer_poissons_ratio) {
  detail::require(modulus_ratio >= 0, "elastic pair", "modulus_ratio",
                  modulus_ratio, "0 (rigid seat) to inf (rigid ball)");
  check_poissons_ratio(inner_poissons_ratio, "inner material");
  check_poissons_ratio(outer_poissons_ratio, "outer material");
  // Effective modulus 1: E_1 = (c + Ebar d)/2, E_2 = (c/Ebar + d)/2 with
  // c = 1 - nu_1^2, d = 1 - nu_2^2.
  const double c = one_minus_square(inner_poissons_ratio);
  const double d = one_minus_square(outer_poissons_ratio);
  const double inner =
      std::isinf(modulus_ratio) ? infinity : (c + modulus_ratio * d) / 2;
  const double outer = (c / modulus_ratio + d) / 2;
  return ElasticPair({inner, inner_poissons_ratio},
                     {outer, outer_poissons_ratio}, modulus_ratio);
}

bool ElasticPair::identical() const {
  return inner_.youngs_modulus == outer_.youngs_modulus &&
         inner_.poissons_ratio == outer_.poissons_ratio;
}

}  // namespace contact
