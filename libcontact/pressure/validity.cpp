#include "libcontact/pressure/validity.hpp"

#include <algorithm>
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

double limit_half_angle(const HalfAngleLaw& law, const ElasticPair& pair) {
  const bool is_its_own = dynamic_cast<const ExactLaw*>(&law) != nullptr ||
                          dynamic_cast<const WornHalfAngle*>(&law) != nullptr;
  return is_its_own ? law.limit_half_angle()
                    : FittedLaw(law.joint_kind(), pair).limit_half_angle();
}

}  // namespace

ContactLimits::ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair) {
  add_pressures(pair);
  add_half_angle(law, pair);
}

ContactLimits::ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair,
                             const JointGeometry& geometry) {
  add_pressures(pair);
  if (const auto& seat = geometry.seat()) {
    limits_.push_back(
        {&LargestContact::half_angle, seat->reach(), degree, "half-angle",
         " {:.4g} deg is",
         detail::message(" beyond {:.4g} deg, where a contact in the middle of "
                         "the seat reaches a rim: its pressures are not "
                         "confined here, and too low",
                         seat->reach() / degree)});
  }
  if (geometry.radial_clearance() >= 0) add_half_angle(law, pair);
}

void ContactLimits::add_pressures(const ElasticPair& pair) {
  const auto add_pressure = [this](double limit, const std::string& what) {
    limits_.push_back(
        {&LargestContact::peak_pressure, limit, megapascal, "peak pressure",
         " {:.4g} MPa is",
         detail::message(" above {:.4g} MPa, {}", limit / megapascal, what)});
  };
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

double ContactLimits::peak_pressure() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Limit& limit : limits_) {
    if (limit.of == &LargestContact::peak_pressure) {
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
