// A hip of unbounded polyethylene with a user-defined pressure: a flat top.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>
#include <memory>

class FlatTop final : public contact::ShapedPressure {
 public:
  explicit FlatTop(contact::JointKind kind)
      : ShapedPressure(kind, "flat_top") {}

 private:
  double shape(double theta, double half_angle) const noexcept override {
    return std::sqrt(1 - std::pow(theta / half_angle, 4));
  }
};

int main() {
  const auto ball = contact::JointKind::ball;
  const contact::ElasticPair materials({230e9, 0.3}, {1e9, 0.4});  // Pa, 1
  const contact::JointContact hip(
      contact::JointGeometry::ball(0.014, 100e-6),  // radius, clearance, m
      materials, contact::FrictionLaw(0.0587),
      contact::make_half_angle_law("fitted", ball, materials),
      std::make_shared<FlatTop>(ball));

  const double half_angle = hip.half_angle(2000).half_angle;
  const contact::FrictionIntegrals spinning =
      hip.integrals(half_angle, contact::SlipAxis::from_degrees(90));
  std::printf("peak %.2f MPa, moment of pure spinning %.4f N m\n",
              hip.peak_pressure(2000, half_angle) / 1e6,
              0.0587 * 2000 * 0.014 * spinning.coefficient.spinning);
}
