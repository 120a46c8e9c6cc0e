#include "libcontact/play/published_forces.hpp"

#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

// h, R, R_1, R_2, c, l as in docs/how-to/play.md.
namespace contact {
namespace {

using detail::pi;

// delta = (F h/l) (ln(B/F) + q): five of the laws, with other B and q.
auto logarithmic(double h_over_length, double b, double q) {
  return [=](double force) -> PublishedApproach {
    const double bracket = std::log(b / force) + q;
    const double growth = h_over_length * (bracket - 1);
    return {h_over_length * force * bracket, 1 / growth, !(growth > 0)};
  };
}

// F = k delta^n.
auto power(double k, double n, bool outside = false) {
  return [=](double force) -> PublishedApproach {
    const double delta = std::pow(force / k, 1 / n);
    return {delta, n * force / delta, outside};
  };
}

// F = k delta sqrt(delta/(2 (c + delta))); z = delta^3/(c + delta) is known.
auto liu(double k, double c) {
  return [=](double force) -> PublishedApproach {
    const double z = 2 * force * force / (k * k);
    // Above the root, where Newton's steps do not pass it.
    double delta = std::cbrt(z * c) + std::sqrt(z);
    for (int i = 0; i < 60; ++i) {
      const double step =
          (delta * delta * delta - z * (c + delta)) / (3 * delta * delta - z);
      delta -= step;
      if (std::abs(step) < 1e-15 * delta) break;
    }
    const double slope =
        force * (1.5 / delta - 0.5 / (c + delta));  // from its logarithm
    return {delta, slope, false};
  };
}

// In mm, N, MPa.
auto pereira(double modulus, double length, double clearance) {
  const double c = 1e3 * clearance;
  const double y = c < 0.34954 ? 1.51 * std::pow(std::log(1e3 * c), -0.151)
                               : 0.0151 * c + 1.151;
  const double n = y * std::pow(c, -0.005);
  const double k = (0.965 * c + 0.0965) / c * (1e3 * length) * (1e-6 * modulus);
  return power(k * std::pow(1e3, n), n, c < 0.005 || c > 10);
}

}  // namespace

std::vector<PublishedForceLaw> published_force_laws(
    const JointGeometry& geometry, const ElasticPair& pair) {
  const double modulus = pair.contact_modulus();
  const double c = geometry.radial_clearance();
  if (!(c > 0)) {
    throw Error(detail::needs(
        "published force laws",
        detail::message("a radial_clearance above 0 m, not {}: the half-angle "
                        "law exact alone knows joints without",
                        c)));
  }
  const double r1 = geometry.radius();
  const double r2 = r1 + c;
  const double r = r1 * r2 / c;
  const double hertz = 4.0 / 3 * modulus * std::sqrt(r);
  if (geometry.kind() == JointKind::ball) {
    return {{"hertz", "Hertz 1882", "small contacts", power(hertz, 1.5)}};
  }
  const double l = geometry.length();
  const double h = 1 / (pi * modulus);
  return {
      {"johnson", "Johnson 1985", "its force decreases beyond 4 pi E* l c e^-2",
       logarithmic(h / l, 4 * l * c / h, -1)},
      {"radzimovsky", "Radzimovsky 1953",
       "with the K_D of Roark's formulas; other authors use half of it",
       logarithmic(h / l, 16 * r1 * r2 * l * modulus / (2.56 * 2 * r),
                   2.0 / 3)},
      {"esdu", "ESDU 78035, 1978", "", logarithmic(h / l, 4 * l * c / h, 1)},
      {"goldsmith", "Goldsmith 1960",
       "the logarithm's argument has a unit: of SI, other ones differ",
       logarithmic(h / l, l / (r * h), 1)},
      {"dubowsky_freudenstein", "Dubowsky, Freudenstein 1971",
       "the length stands for a radius",
       logarithmic(h / l, l * l * l * c / (r1 * r2 * h), 1)},
      {"lankarani_nikravesh", "Lankarani, Nikravesh 1990",
       "a ball's law: the length has no effect", power(hertz, 1.5)},
      {"liu", "Liu et al. 2007", "like a bed of springs",
       liu(pi / 2 * modulus * l, c)},
      {"pereira", "Pereira et al. 2011",
       "a fit, for clearances of 5 um to 10 mm", pereira(modulus, l, c)},
  };
}

}  // namespace contact
