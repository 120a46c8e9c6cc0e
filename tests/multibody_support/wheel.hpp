#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <utility>

#include "multibody/motion/motion.hpp"

/// A wheel on a carrier, and its driving forces, for tests of motions.
namespace multibody::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline constexpr double g = 9.81;

inline Carrier heavy_carrier() { return {100, 50 * Matrix3d::Identity()}; }

/// A wheel on a horizontal axis through its centre of mass; about the axis
/// (z) its inertia is `about`.
inline Body wheel(double mass, double about) {
  Body body{HingeKind::axis, mass, Matrix3d::Zero()};
  body.inertia.diagonal() << 0.7 * about, 0.7 * about, about;
  return body;
}

inline MotionStart start_of(int bodies) {
  MotionStart start;
  start.bodies.resize(bodies);
  return start;
}

inline MotionStart turning(double rate) {
  MotionStart start = start_of(1);
  start.bodies[0].angle_rate = rate;
  return start;
}

inline MotionOptions on_fixed_carrier(
    Integrator integrator = Integrator::adaptive,
    double step = MotionOptions().step) {
  MotionOptions options;
  options.integrator = integrator;
  options.step = step;
  options.carrier_drive = CarrierDrive{};
  options.gravity = Vector3d(0, -g, 0);
  return options;
}

/// A torque about z on body 0, as a function of time.
class Torque : public ForceModel {
 public:
  explicit Torque(std::function<double(double)> torque)
      : torque_(std::move(torque)) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    forces[1].moment.z() += torque_(time);
  }

 private:
  std::function<double(double)> torque_;
};

}  // namespace multibody::test
