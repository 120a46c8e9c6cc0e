#include "libcontact/play/impact.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {
namespace {

using detail::nan;

// W(largest) - W(largest - rest), near the largest not as a difference.
double energy_to_turn(const ForceLaw& law, double largest, double rest) {
  static const detail::GaussLegendre& rule = *new detail::GaussLegendre(12);
  if (rest > 0.05 * largest) {
    return law.energy(largest) - law.energy(largest - rest);
  }
  double sum = 0;
  for (int i = 0; i < rule.node.size(); ++i) {
    sum += rule.weight(i) * law.force(largest - rest * (1 + rule.node(i)) / 2);
  }
  return rest / 2 * sum;
}

// Time of a wave through the ball or pin and the wall and back.
double travel_time(const JointSpec& joint, double density) {
  const auto slowness = [density](const Material& material) {
    return std::sqrt(density / material.youngs_modulus);  // rigid: 0
  };
  double sum = joint.geometry.radius() * slowness(joint.inner.surface());
  for (const Layer& layer : joint.outer.layers) {
    sum += layer.thickness * slowness(layer.material);
  }
  return 2 * sum;
}

}  // namespace

JointImpact::JointImpact(const JointSpec& joint)
    : joint_(joint.without_seat()),
      law_(joint),
      pressure_(joint.make_pressure_law()) {}

// The integral of 1/speed over the penetration; the speed is 0 at its end.
double JointImpact::time(const HuntCrossley& damping, double mass,
                         double penetration, bool inwards) const {
  const auto slowness = [&](double x, double complement) {
    const double rest =
        x > penetration / 2 ? std::abs(complement) : penetration - x;
    const double energy = energy_to_turn(law_, penetration, rest) / mass;
    return 1 / (inwards ? damping.speed_inwards(energy)
                        : damping.speed_outwards(energy));
  };
  // Below the 1e-9 that are claimed; the rule is exponential in its steps.
  constexpr double tolerance = 1e-10;
  boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(slowness, 0.0, penetration, tolerance);
}

Impact JointImpact::operator()(const HuntCrossley& damping, double mass,
                               double speed) const {
  detail::require(detail::is_above_zero(mass), "impact", "mass", mass,
                  "above 0 kg");
  detail::require(detail::is_above_zero(speed), "impact", "speed", speed,
                  "above 0 m/s");
  const double energy = mass * speed * speed / 2 * damping.energy_share(speed);
  const double penetration = law_.penetration_of_energy(energy);
  const double e = damping.restitution(speed);
  if (std::isnan(penetration)) {
    return {e, nan, nan, nan, nan, nan, nan, nan};
  }
  const ForceState turn = law_.at(penetration);
  // Force and pressure are both 1 + a v times the elastic ones.
  const auto damped = [&](double delta) {
    const double rest = energy_to_turn(law_, penetration, penetration - delta);
    return 1 + damping.damping() * damping.speed_inwards(rest / mass);
  };
  const JointGeometry& geometry = joint_.geometry;
  const auto elastic_peak = [&](const ForceState& at) {
    return pressure_->peak(at.half_angle) *
           geometry.pressure_unit(geometry.load_from_force(at.force));
  };
  const auto largest = [&](const auto& of) {
    return -boost::math::tools::brent_find_minima(
                [&](double delta) { return -of(delta) * damped(delta); }, 0.0,
                penetration, 26)
                .second;
  };
  return {
      .restitution = e,
      .penetration = penetration,
      .elastic_force = turn.force,
      .peak_force = std::max(
          largest([&](double delta) { return law_.force(delta); }), turn.force),
      .half_angle = turn.half_angle,
      .peak_pressure = std::max(
          largest([&](double at) { return elastic_peak(law_.at(at)); }),
          elastic_peak(turn)),
      .compression_time = time(damping, mass, penetration, true),
      .restitution_time = time(damping, mass, penetration, false)};
}

std::vector<std::string> JointImpact::notes(const Impact& impact,
                                            double density) const {
  if (std::isnan(impact.penetration)) {
    return {
        detail::message("the impact exceeds the energy at the end of the force "
                        "law, {:.4g} J: a half-angle of {:.4g} deg",
                        law_.energy(law_.largest_penetration()),
                        law_.half_angle(law_.largest_penetration()) / degree)};
  }
  std::vector<std::string> notes;
  const ContactLimits limits(*joint_.make_half_angle_law(), joint_.pair(),
                             joint_.geometry);
  for (const std::string& note :
       limits.notes({impact.half_angle, impact.peak_pressure})) {
    notes.push_back(note +
                    ": the restitution is then mostly plastic, and its "
                    "damping a fit");
  }
  // Fewer waves to and fro are no quasi-static deformation.
  constexpr double fewest = 10;
  const double travel = travel_time(joint_, density);
  if (impact.duration() < fewest * travel) {
    notes.push_back(detail::message(
        "the impact takes {:.3g} us, {:.3g} times as long as a wave through "
        "the joint and back: below {:.4g} times elasticity is not quasi-static",
        1e6 * impact.duration(), impact.duration() / travel, fewest));
  }
  return notes;
}

}  // namespace contact
