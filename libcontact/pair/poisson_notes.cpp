#include "libcontact/pair/poisson_notes.hpp"

#include "libcontact/base/text.hpp"

#include <cmath>

namespace contact::detail {

std::vector<std::string> poisson_notes(std::string_view subject,
                                       const ElasticPair& pair) {
  constexpr double tolerance = 0.01 + 1e-12;
  std::vector<std::string> notes;
  const auto add = [&](const char* body, const Material& material) {
    // A rigid body's Poisson's ratio has no influence.
    if (std::isinf(material.youngs_modulus)) return;
    const double nu = material.poissons_ratio;
    if (std::abs(nu - 0.3) <= tolerance) return;
    notes.push_back(
        detail::message("{} for Poisson's ratio 0.3; the {} body has {:.4g}",
                        subject, body, nu));
  };
  add("inner", pair.inner());
  add("outer", pair.outer());
  return notes;
}

}  // namespace contact::detail
