#include "libcontact/friction/stress_rule.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

using detail::GaussLegendre;
using std::numbers::pi;

// Gauss's rule, made anew unless it is the usual one.
class Gauss {
 public:
  explicit Gauss(int points) {
    if (points != usual_stress_points) own_.emplace(points);
  }
  const GaussLegendre& rule() const {
    static const GaussLegendre usual(usual_stress_points);
    return own_ ? *own_ : usual;
  }

 private:
  std::optional<GaussLegendre> own_;
};

// The stress at places of a contact.
class Stress {
 public:
  Stress(const PressureLaw& law, const StressedContact& contact,
         const FrictionStress& stress)
      : profile_(law, contact.half_angle),
        unit_(contact.pressure_unit),
        rim_speed_(contact.rim_speed),
        stress_(stress) {}

  double operator()(double theta, double share_of_speed) const {
    // Of laws that end like a root, rounding may say less than 0.
    const double p = std::max(unit_ * profile_.pressure(theta), 0.0);
    return stress_.stress_at(p, rim_speed_ * share_of_speed);
  }

 private:
  detail::PressureProfile profile_;
  double unit_;
  double rim_speed_;
  const FrictionStress& stress_;
};

// One half plane pair through the slip axis, at the longitude phi from the
// plane of axis and contact's centre: d phi = weight.
struct Plane {
  double sine;
  double cosine;
  double distance;  // D = sqrt(s^2 - q^2 sin^2 phi)
  double weight;
};

// Calls visit() with the planes of a contact up to 90 deg: nodes in Jacobi's
// variable, with which the edge of the contact is smooth.
template <class Visit>
void along_planes(double s, double q, const GaussLegendre& gauss,
                  const Visit& visit) {
  // Where the slip axis pierces the edge of the contact the variable becomes
  // infinite; a modulus below serves too.
  constexpr double largest_modulus = 1 - 1e-12;
  constexpr double longest_part = 6;  // of the variable
  const bool pole_inside = s >= q;
  const double z = s / q;
  const double modulus = std::min(pole_inside ? q / s : z, largest_modulus);
  // Double precision is enough.
  using boost::math::policies::policy;
  using Double = policy<boost::math::policies::promote_double<false>>;
  const double end = boost::math::ellint_1(modulus, Double());
  const auto size = gauss.node.size();
  const auto parts = static_cast<Eigen::Index>(std::ceil(end / longest_part));
  const double part = end / static_cast<double>(parts);
  for (Eigen::Index i = 0; i < parts * size; ++i) {
    // Periodic with a pole inside, else with odd powers at the end.
    const Eigen::Index k = i % size;
    const double start = static_cast<double>(i / size) * part;
    const double node =
        pole_inside ? (static_cast<double>(k) + 0.5) / static_cast<double>(size)
                    : (1 + gauss.node[k]) / 2;
    const double width = part * (pole_inside ? 1 / static_cast<double>(size)
                                             : gauss.weight[k] / 2);
    double cn = 0;
    double dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus, start + node * part,
                                                   &cn, &dn, Double());
    if (pole_inside) {
      visit(Plane{sn, cn, std::sqrt((s - q) * (s + q) + q * q * cn * cn),
                  dn * width});
    } else {
      const double cosine =
          std::sqrt((q - s) * (q + s) / (q * q) + z * z * cn * cn);
      visit(Plane{z * sn, cosine, s * cn, z * cn * dn / cosine * width});
    }
  }
}

// Along great circles through the slip axis.
FrictionTriple by_planes(double half_angle, SlipAxis axis, const Stress& stress,
                         const GaussLegendre& gauss) {
  const double c = std::cos(half_angle);
  const double s = std::sin(half_angle);
  const double q = axis.cos;
  const double sa = axis.sin;
  FrictionTriple sum{0, 0, 0};
  along_planes(s, q, gauss, [&](const Plane& plane) {
    const double out = q * plane.sine;  // of the plane: the contact's centre
    const double r = std::sqrt((1 - out) * (1 + out));
    const double d = std::atan2(plane.distance, c);
    const double middle = std::atan2(q * plane.cosine, sa);
    const auto add = [&](double from, double to) {
      const double half = (to - from) / 2;
      for (Eigen::Index k = 0; k < gauss.node.size(); ++k) {
        const double v = (from + to) / 2 + half * gauss.node[k];
        const double x = d * std::sin(v);
        const double cos_x = std::cos(x);
        const double colatitude = middle + x;
        const double w = std::sin(colatitude);
        const double across = std::cos(colatitude) * plane.cosine;
        const double theta =
            std::atan2(std::hypot(std::sin(x), out * cos_x), r * cos_x);
        const double dx = d * std::cos(v) * half * gauss.weight[k];
        // |w| times the sign of w in front of e.
        const double t = stress(theta, std::abs(w)) * dx * plane.weight * w;
        sum.force += t * plane.cosine;
        sum.sliding += t * (w * q + sa * across);
        sum.spinning += t * (w * sa - q * across);
      }
    };
    // e changes its sign at the pole.
    const double pole = s >= q && middle < d ? -std::asin(middle / d) : -pi / 2;
    if (pole > -pi / 2) add(-pi / 2, pole);
    add(pole, pi / 2);
  });
  // Both sides of the plane of slip axis and centre.
  return {2 * sum.force, 2 * sum.sliding, 2 * sum.spinning};
}

// Double exponential rule on [0, 1]; from each end its own distance.
struct EndRule {
  static constexpr int size = 91;
  struct Node {
    double share;
    double weight;
  };
  std::array<Node, size> nodes;

  EndRule() {
    constexpr double reach = 3.2;  // leaves 1e-16 of a root's end
    const double step = 2 * reach / (size - 1);
    for (int i = 0; i < size; ++i) {
      const double t = -reach + i * step;
      const double u = pi / 2 * std::sinh(t);
      const double cosh_u = std::cosh(u);
      nodes[static_cast<std::size_t>(i)] = {
          1 / (1 + std::exp(-2 * u)),
          step * pi / 4 * std::cosh(t) / (cosh_u * cosh_u)};
    }
  }
};

// By the definition, in polar coordinates round the contact's centre.
FrictionTriple by_definition(double half_angle, SlipAxis axis,
                             const Stress& stress) {
  static const EndRule rule;
  const double q = axis.cos;
  const double sa = axis.sin;
  // Where the slip axis pierces the sphere.
  const double pole = std::atan2(q, sa);
  const std::array<double, 4> ends = {
      0, std::min({pole, pi - pole, half_angle}),
      std::min(std::max(pole, pi - pole), half_angle), half_angle};
  FrictionTriple sum{0, 0, 0};
  for (std::size_t part = 1; part < ends.size(); ++part) {
    const double width = ends[part] - ends[part - 1];
    if (width == 0) continue;
    for (const auto& [share, weight] : rule.nodes) {
      const double theta = ends[part - 1] + share * width;
      const double sine = std::sin(theta);
      const double z = std::cos(theta);
      for (const auto& [turn, turn_weight] : rule.nodes) {
        const double y = sine * std::cos(pi * turn);
        const double x = sine * std::sin(pi * turn);
        const double across = q * z - sa * y;
        const double w = std::hypot(across, x);
        if (w == 0) continue;
        const double along = q * y + sa * z;
        const double t =
            stress(theta, w) / w * sine * weight * width * turn_weight * pi;
        sum.force += t * across;
        sum.sliding += t * (q - y * along);
        sum.spinning += t * (sa - z * along);
      }
    }
  }
  return {2 * sum.force, 2 * sum.sliding, 2 * sum.spinning};
}

}  // namespace

FrictionTriple stress_integrals(const PressureLaw& law,
                                const StressedContact& contact, SlipAxis axis,
                                const FrictionStress& stress, int points) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double all = contact.half_angle + contact.pressure_unit +
                     contact.rim_speed + axis.sin + axis.cos;
  if (!std::isfinite(all) || !(contact.half_angle > 0)) return {nan, nan, nan};
  // Force and sliding moment are linear in cos a near 90 deg, with a square
  // of this behind; what is less is lost in their rounding.
  const double least_cosine =
      1e-5 * std::sin(std::min(contact.half_angle, pi / 2));
  const double share = std::min(axis.cos / least_cosine, 1.0);
  const double sine = std::abs(axis.sin);
  const SlipAxis used = {
      share < 1 ? std::sqrt(1 - least_cosine * least_cosine) : sine,
      std::max(axis.cos, least_cosine)};
  const Stress field(law, contact, stress);
  const Gauss gauss(points);
  const FrictionTriple sum =
      contact.half_angle > pi / 2
          ? by_definition(contact.half_angle, used, field)
          : by_planes(contact.half_angle, used, field, gauss.rule());
  return {share * sum.force, share * sum.sliding,
          std::copysign(sum.spinning, axis.sin)};
}

FrictionTriple pin_stress_integrals(const PressureLaw& law,
                                    const StressedContact& contact,
                                    const FrictionStress& stress, int points) {
  const Stress field(law, contact, stress);
  const Gauss gauss(points);
  const GaussLegendre& rule = gauss.rule();
  FrictionTriple sum{0, 0, 0};
  for (Eigen::Index k = 0; k < rule.node.size(); ++k) {
    // The sine takes away the root at the edge.
    const double v = pi / 4 * (1 + rule.node[k]);
    const double theta = contact.half_angle * std::sin(v);
    // Both sides.
    const double t = 2 * field(theta, 1) * contact.half_angle * std::cos(v) *
                     pi / 4 * rule.weight[k];
    sum.force += t * std::cos(theta);
    sum.sliding += t;
  }
  return sum;
}

}  // namespace contact
