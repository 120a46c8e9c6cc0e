#include "support/random_slip.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/cosine.hpp"

namespace contact::test {

using Eigen::Vector3d;

Vector3d RandomSlips::direction() {
  const double z = 2 * uniform() - 1;
  const double phi = 2 * std::numbers::pi * uniform();
  const double r = std::sqrt((1 - z) * (1 + z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

double RandomSlips::log_uniform(double low, double high) {
  return low * std::pow(high / low, uniform());
}

double RandomSlips::angle() {
  constexpr double pi = std::numbers::pi;
  const double kind = uniform();
  if (kind < 0.02) return 0;
  if (kind < 0.04) return pi;
  if (kind < 0.06) return pi / 2;
  if (kind < 0.12) return log_uniform(1e-12, 1);
  if (kind < 0.15) return pi - log_uniform(1e-12, 1);
  if (kind < 0.21) {
    const double off = log_uniform(1e-12, 1);
    return pi / 2 + (uniform() < 0.5 ? off : -off);
  }
  return std::acos(1 - 2 * uniform());
}

RandomSlip RandomSlips::next() {
  const double radius = log_uniform(1e-3, 1);
  const double clearance = radius * log_uniform(1e-5, 1e-2);
  const ElasticPair pair({log_uniform(1e9, 4e11), 0.3}, {2e11, 0.3});
  HalfAngleOptions options;
  options.limit_half_angle = (30 + 85 * uniform()) * degree;
  const double law = uniform();
  const std::string name = law < 0.6   ? "tanh"
                           : law < 0.8 ? "arctan"
                                       : "blend:0.5";

  const double force =
      uniform() < 0.3 ? log_uniform(1e-12, 1e12)
                      : LoadScale(JointGeometry::ball(radius, clearance), pair)
                            .load(log_uniform(1e-6, 1e4));
  const double f0_kind = uniform();
  const double f0 = f0_kind < 0.1   ? 0
                    : f0_kind < 0.5 ? 5 * uniform()
                                    : log_uniform(1e-6, 5);
  const double adhesion_kind = uniform();
  const double adhesion = adhesion_kind < 0.15  ? 0
                          : adhesion_kind < 0.4 ? 1e4 * uniform()
                                                : log_uniform(1e-6, 1e4);
  const JointBody inner =
      uniform() < 0.5 ? JointBody::carrier : JointBody::body;
  Joint joint({JointGeometry::ball(radius, clearance, inner), pair,
               FrictionLaw(f0, adhesion * force / (radius * radius)),
               make_half_angle_law(name, JointKind::ball, pair, options),
               std::make_unique<CosinePressure>(JointKind::ball)});
  const double b = angle();
  const double speed = log_uniform(1e-9, 1e3);
  const Vector3d w = direction();
  const Vector3d across = w.cross(direction()).normalized();
  return {std::move(joint), force * (std::cos(b) * w + std::sin(b) * across),
          speed * w};
}

}  // namespace contact::test
