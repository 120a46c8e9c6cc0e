#include "libcontact/pressure/validity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/worn.hpp"

namespace contact {
namespace {

constexpr double megapascal = 1e6;

// Only the law `exact` is of joints with walls.
const LayeredPair* walls_of(const HalfAngleLaw& law) {
  if (const auto* worn = dynamic_cast<const WornHalfAngle*>(&law)) {
    return walls_of(worn->law());
  }
  const auto* exact = dynamic_cast<const ExactLaw*>(&law);
  return exact && exact->walls() ? &*exact->walls() : nullptr;
}

std::vector<std::string> liner_notes(const HalfAngleLaw& law,
                                     const ElasticPair& pair) {
  if (const LayeredPair* walls = walls_of(law)) {
    return infinite_liner_notes(walls->inner(), walls->outer());
  }
  return infinite_liner_notes(pair.inner(), pair.outer());
}

double limit_half_angle(const HalfAngleLaw& law, const ElasticPair& pair) {
  const bool is_its_own = dynamic_cast<const ExactLaw*>(&law) != nullptr ||
                          dynamic_cast<const WornHalfAngle*>(&law) != nullptr;
  return is_its_own ? law.limit_half_angle()
                    : FittedLaw(law.joint_kind(), pair).limit_half_angle();
}

// Materials this much stiffer than a surface do not yield with it: a polymer
// on metal is confined, a bush of bronze in steel is not.
constexpr double stiff = 10;

// The depth at which a body ends or is stiff against its surface, m.
double elastic_depth(const LayeredBody& body, double radius, double modulus) {
  double depth = 0;
  for (const Layer& layer : body.layers) {
    if (layer.material.youngs_modulus > stiff * modulus) return depth;
    depth += layer.thickness;
  }
  const bool ends = body.backing.kind() != Backing::Kind::medium ||
                    body.backing.material().youngs_modulus > stiff * modulus;
  return ends ? depth : depth + radius;
}

// The depth of the deeper one of the bodies that yield.
double elastic_depth(const LayeredPair& bodies) {
  const double modulus = std::min(bodies.inner().surface().youngs_modulus,
                                  bodies.outer().surface().youngs_modulus);
  return std::max(elastic_depth(bodies.inner(), bodies.radius(), modulus),
                  elastic_depth(bodies.outer(), bodies.radius(), modulus));
}

}  // namespace

ContactLimits::ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair) {
  add_pressures(pair);
  if (const LayeredPair* walls = walls_of(law)) add_layers(*walls);
  add_liners(liner_notes(law, pair));
  add_half_angle(law, pair);
}

ContactLimits::ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair,
                             const JointGeometry& geometry) {
  add_pressures(pair);
  if (const LayeredPair* walls = walls_of(law)) add_layers(*walls);
  add_liners(liner_notes(law, pair));
  if (const auto& seat = geometry.drawn_seat()) {
    limits_.push_back(
        {&LargestContact::half_angle, seat->reach(), degree, "half-angle",
         " {:.4g} deg is",
         detail::message(" beyond {:.4g} deg, where a contact in the middle of "
                         "the seat reaches a rim: the contact is not confined "
                         "here, and the printed pressures are too low",
                         seat->reach() / degree)});
    // A tenth of a degree: rounding at a rim is no overlap.
    limits_.push_back(
        {&LargestContact::rim_overlap, 0.1 * degree, degree, "contact",
         " that goes {:.3g} deg",
         detail::message(
             " beyond a rim of its seat in the direction of the load: the seat "
             "is ignored here, and the printed pressures are too low")});
  }
  if (geometry.radial_clearance() >= 0) add_half_angle(law, pair);
  if (geometry.kind() == JointKind::pin) {
    const LayeredPair* walls = walls_of(law);
    add_length(walls
                   ? *walls
                   : LayeredPair(geometry.radius(), pair.inner(), pair.outer()),
               geometry.length());
  }
}

void ContactLimits::add_pressure(double limit, const std::string& what,
                                 double least_half_angle) {
  limits_.push_back(
      {&LargestContact::peak_pressure, limit, megapascal, "peak pressure",
       " {:.4g} MPa is",
       detail::message(" above {:.4g} MPa, {}", limit / megapascal, what),
       least_half_angle});
}

void ContactLimits::add_pressures(const ElasticPair& pair) {
  add_pressure(largest_pressure_share * std::min(pair.inner().youngs_modulus,
                                                 pair.outer().youngs_modulus),
               detail::message("{:g} % of the smaller Young's modulus: linear "
                               "elasticity does not hold",
                               100 * largest_pressure_share));
  for (const auto& [material, body] :
       {std::pair{&pair.inner(), "inner"}, std::pair{&pair.outer(), "outer"}}) {
    add_pressure(
        material->limit_pressure,
        detail::message("the limit pressure of the {} body{}", body,
                        material->name.empty() ? "" : ", " + material->name));
  }
}

void ContactLimits::add_layers(const LayeredPair& walls) {
  const auto add = [&](const Material& material, const char* body,
                       double depth) {
    const std::string place = detail::message(
        "{} body {:.3g} mm under the contact{}: the pressure there is lower, "
        "but not computed",
        body, 1e3 * depth, material.name.empty() ? "" : ", " + material.name);
    const double from = depth / walls.radius();
    add_pressure(material.limit_pressure, "the limit pressure of the " + place,
                 from);
    add_pressure(largest_pressure_share * material.youngs_modulus,
                 detail::message("{:g} % of Young's modulus of the {}",
                                 100 * largest_pressure_share, place),
                 from);
  };
  for (const auto& [of, body] : {std::pair{&walls.inner(), "inner"},
                                 std::pair{&walls.outer(), "outer"}}) {
    double depth = 0;
    for (std::size_t i = 0; i < of->layers.size(); ++i) {
      if (i > 0) add(of->layers[i].material, body, depth);
      depth += of->layers[i].thickness;
    }
    const bool is_elastic = of->backing.kind() == Backing::Kind::medium;
    if (depth > 0 && is_elastic) add(of->backing.material(), body, depth);
  }
}

void ContactLimits::add_liners(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    limits_.push_back({&LargestContact::half_angle, 0, degree, "", "", note});
  }
}

void ContactLimits::add_half_angle(const HalfAngleLaw& law,
                                   const ElasticPair& pair) {
  constexpr double fitted_error = 1e-3;
  const double limit = limit_half_angle(law, pair);
  limits_.push_back(
      {&LargestContact::half_angle, limit * (1 + fitted_error), degree,
       "half-angle", " {:.4g} deg is",
       detail::message(" beyond {:.4g} deg, the limit half-angle of this joint",
                       limit / degree)});
}

void ContactLimits::add_length(const LayeredPair& bodies, double length) {
  const double share = length / (2 * bodies.radius());
  if (!(share < 1) || !(elastic_depth(bodies) > length / 2)) return;
  const double from = std::asin(share);
  limits_.push_back(
      {&LargestContact::half_angle, from, degree, "half-angle",
       " {:.4g} deg is",
       detail::message(
           " beyond {:.4g} deg, where the contact is wider than the pin is "
           "long, {:.4g} mm: it is between plane_state = \"strain\" and "
           "\"stress\", whose peaks differ by some 5 % and stiffnesses by 10 %",
           from / degree, 1e3 * length)});
}

double ContactLimits::peak_pressure() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Limit& limit : limits_) {
    if (limit.of == &LargestContact::peak_pressure &&
        limit.least_half_angle == 0) {
      least = std::min(least, limit.value);
    }
  }
  return least;
}

std::vector<std::string> ContactLimits::notes(
    const LargestContact& largest) const {
  std::vector<std::string> notes;
  for (const Limit& limit : limits_) {
    if (!limit.is_passed(largest)) continue;
    notes.push_back(
        limit.what +
        detail::message(limit.number, largest.*limit.of / limit.unit) +
        limit.beyond);
  }
  return notes;
}

std::vector<std::string> ContactLimits::passed(
    const LargestContact& largest) const {
  std::vector<std::string> all;
  for (const Limit& limit : limits_) {
    if (limit.is_passed(largest)) all.push_back(limit.what + limit.beyond);
  }
  return all;
}

}  // namespace contact
