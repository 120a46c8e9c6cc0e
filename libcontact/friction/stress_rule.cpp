#include "libcontact/friction/stress_rule.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <optional>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

using detail::GaussLegendre;
using detail::pi;

// Gauss's rules for the planes through the slip axis and for the points in
// each. Edges ask for more points than planes do.
struct Rules {
  GaussLegendre planes;
  GaussLegendre across;

  explicit Rules(int points) : planes(points - 2), across(points + 2) {}
};

// Made anew unless they are the usual ones.
class RulesOf {
 public:
  explicit RulesOf(int points) {
    if (points != usual_stress_points) own_.emplace(points);
  }
  const Rules& operator*() const {
    static const Rules& usual = *new Rules(usual_stress_points);
    return own_ ? *own_ : usual;
  }

 private:
  std::optional<Rules> own_;
};

// Places in an interval and how fast they move.
struct Place {
  double at;
  double rate;
};

// From 0 to 1, s in [0, 1], slowly at the end: raises the powers of the
// distance to the edge, which are arbitrary for friction stresses.
Place to_end(double s) { return {s * (2 - s), 2 - 2 * s}; }
// The same from -1 to 1, t in [-1, 1], and odd.
Place to_both_ends(double t) {
  const double q = t * t;
  const double rest = (1 - t) * (1 + t);
  return {t * (35 - q * (35 - q * (21 - 5 * q))) / 16,
          35. / 16 * rest * rest * rest};
}

// The stress at places of a contact.
class Stress {
 public:
  Stress(const PressureLaw& law, const StressedContact& contact,
         const FrictionStress& stress)
      : profile_(law, contact.half_angle),
        unit_(contact.pressure_unit),
        uniform_(contact.uniform_pressure),
        rim_speed_(contact.rim_speed),
        stress_(stress) {}

  double pressure(double theta) const {
    // Rounding may give less than 0 for laws that end like a root.
    return std::max(unit_ * profile_.pressure(theta) + uniform_, 0.0);
  }
  double at_pressure(double p, double share_of_speed) const {
    return stress_.stress_at(p, rim_speed_ * share_of_speed);
  }
  double operator()(double theta, double share_of_speed) const {
    return at_pressure(pressure(theta), share_of_speed);
  }
  // How far from the slip axis the stress changes with the speed, rad.
  double layer() const { return stress_.speed_scale() / rim_speed_; }

 private:
  detail::PressureProfile profile_;
  double unit_;
  double uniform_;
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
  // The variable becomes infinite where the slip axis pierces the edge of the
  // contact; a modulus below serves too.
  constexpr double largest_modulus = 1 - 1e-12;
  constexpr double longest_part = 6;  // longest part of the variable
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
    const Eigen::Index k = i % size;
    double node = (1 + gauss.node[k]) / 2;
    double width = part * gauss.weight[k] / 2;
    if (pole_inside) {  // periodic
      node = (static_cast<double>(k) + 0.5) / static_cast<double>(size);
      width = part / static_cast<double>(size);
    } else if (i >= (parts - 1) * size) {  // the last arcs are short
      width *= 1.5 * (1 - node) * (1 + node);
      node *= (3 - node * node) / 2;
    }
    const Eigen::Index before = i / size;
    const double u = part * (static_cast<double>(before) + node);
    double cn = 0;
    double dn = 0;
    const double sn =
        boost::math::jacobi_elliptic(modulus, u, &cn, &dn, Double());
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

// Calls visit(x, dx) with the places [-d, d] of an arc.
template <class Visit>
void across_arc(double d, const GaussLegendre& gauss, const Visit& visit) {
  for (Eigen::Index k = 0; k < gauss.node.size(); ++k) {
    const auto [share, rate] = to_both_ends(gauss.node[k]);
    visit(d * share, d * rate * gauss.weight[k]);
  }
}

// The same from x = pole on, where e changes its sign, to either end. What
// changes like exp(-|x - pole|/layer) has pieces of its own beside the pole.
template <class Visit>
void across_both_sides(double d, double pole, double layer,
                       const GaussLegendre& gauss, const Visit& visit) {
  // The first piece has all of the exponential but 2e-3, the second one all but
  // 1e-13.
  constexpr std::array<double, 2> pieces = {6, 30};
  for (const double side : {-1.0, 1.0}) {
    double start = std::asin(pole / d);  // x = d sin V
    for (const double piece : pieces) {
      const double x = pole + side * piece * layer;
      if (!(side * x < d)) break;
      const double end = std::asin(x / d);
      const double half = std::abs(end - start) / 2;
      for (Eigen::Index k = 0; k < gauss.node.size(); ++k) {
        const double v = (start + end) / 2 + side * half * gauss.node[k];
        visit(d * std::sin(v), d * std::cos(v) * half * gauss.weight[k]);
      }
      start = end;
    }
    const double end = side * pi / 2;
    for (Eigen::Index k = 0; k < gauss.node.size(); ++k) {
      const auto [share, rate] = to_end((1 + gauss.node[k]) / 2);
      const double v = start + (end - start) * share;
      const double dv = std::abs(end - start) * rate * gauss.weight[k] / 2;
      visit(d * std::sin(v), d * std::cos(v) * dv);
    }
  }
}

// Along great circles through the slip axis.
FrictionTriple by_planes(double half_angle, SlipAxis axis, const Stress& stress,
                         const Rules& rules) {
  const double c = std::cos(half_angle);
  const double s = std::sin(half_angle);
  const double q = axis.cos;
  const double sa = axis.sin;
  FrictionTriple sum{0, 0, 0};
  along_planes(s, q, rules.planes, [&](const Plane& plane) {
    const double out = q * plane.sine;  // distance of the contact's centre
    const double r = std::sqrt((1 - out) * (1 + out));
    const double d = std::atan2(plane.distance, c);
    const double middle = std::atan2(q * plane.cosine, sa);
    const auto add = [&](double x, double dx) {
      const double cos_x = std::cos(x);
      const double colatitude = middle + x;
      const double w = std::sin(colatitude);
      const double across = std::cos(colatitude) * plane.cosine;
      const double theta =
          std::atan2(std::hypot(std::sin(x), out * cos_x), r * cos_x);
      // |w| times the sign of w in front of e.
      const double t = stress(theta, std::abs(w)) * dx * plane.weight * w;
      sum.force += t * plane.cosine;
      sum.sliding += t * (w * q + sa * across);
      sum.spinning += t * (w * sa - q * across);
    };
    const bool crosses_pole = s >= q && middle < d;
    if (crosses_pole) {
      across_both_sides(d, -middle, stress.layer(), rules.across, add);
    } else {
      across_arc(d, rules.across, add);
    }
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
  // Point where the slip axis pierces the sphere.
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
      const double p = stress.pressure(theta);
      for (const auto& [turn, turn_weight] : rule.nodes) {
        const double y = sine * std::cos(pi * turn);
        const double x = sine * std::sin(pi * turn);
        const double across = q * z - sa * y;
        const double w = std::hypot(across, x);
        if (w == 0) continue;
        const double along = q * y + sa * z;
        const double t = stress.at_pressure(p, w) / w * sine * weight * width *
                         turn_weight * pi;
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
  using detail::nan;
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
  const RulesOf rules(points);
  const FrictionTriple sum =
      contact.half_angle > pi / 2
          ? by_definition(contact.half_angle, used, field)
          : by_planes(contact.half_angle, used, field, *rules);
  // A moment about n may drive the spin, where the contact's fast parts rub
  // less than its slow ones: mirrored, not given the sign of the axis.
  return {share * sum.force, share * sum.sliding,
          std::copysign(1.0, axis.sin) * sum.spinning};
}

FrictionTriple pin_stress_integrals(const PressureLaw& law,
                                    const StressedContact& contact,
                                    const FrictionStress& stress, int points) {
  const Stress field(law, contact, stress);
  const RulesOf rules(points);
  const auto& [node, weight] = (*rules).across;
  FrictionTriple sum{0, 0, 0};
  for (Eigen::Index k = 0; k < node.size(); ++k) {
    const auto [share, rate] = to_end((1 + node[k]) / 2);
    // The sine takes away the root at the edge.
    const double v = pi / 2 * share;
    const double theta = contact.half_angle * std::sin(v);
    // Both sides.
    const double t = 2 * field(theta, 1) * contact.half_angle * std::cos(v) *
                     pi / 4 * rate * weight[k];
    sum.force += t * std::cos(theta);
    sum.sliding += t;
  }
  return sum;
}

}  // namespace contact
