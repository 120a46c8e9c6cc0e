// The pendulum on a ball joint of docs/tutorials/pendulum.md, moved by the
// library that finds rest and slip itself: it swings, spins, stops, holds.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>
#include <multibody/motion/motion.hpp>

int main() {
  using Eigen::Vector3d;
  const contact::Material steel{2e11, 0.3};  // Pa, 1
  const contact::Joint joint(
      {.geometry =
           contact::JointGeometry::ball(0.02, 20e-6),  // radius, clearance
       .inner = steel,
       .outer = steel,
       .friction = contact::FrictionLaw(0.15, 2e4),  // f0, adhesion
       .half_angle_law = "tanh",
       .pressure_law = "cosine"});

  const double m = 5, arm = 0.4;  // kg, m
  // About the centre of mass, from that about the joint.
  const Vector3d inertia(0.9 - m * arm * arm, 0.9 - m * arm * arm, 0.02);
  const multibody::System system({.fixed = true},  // hangs on the ground
                                 {{.mass = m,
                                   .inertia = inertia.asDiagonal(),
                                   .hinge_from_com = {0, 0, arm}}});
  multibody::MotionStart start;
  start.bodies.resize(1);
  start.bodies[0].rotation = Eigen::AngleAxisd(1, Vector3d::UnitX());
  start.bodies[0].relative_angular_velocity =
      start.bodies[0].rotation.transpose() * Vector3d(0, 1, 0.5);
  multibody::MotionOptions options;
  options.gravity = {0, 0, -9.81};
  multibody::Motion motion(system, {multibody::JointFriction{joint}}, nullptr,
                           start, options);

  if (motion.advance_to(60) != multibody::Stop::time) return 1;
  const auto& changes = motion.changes();
  if (changes.empty()) return 1;
  const Vector3d down =
      motion.sample().motions()[1].rotation * -Vector3d::UnitZ();
  std::printf("rests after %.2f s, %.2f deg from the vertical\n",
              changes.back().time, std::acos(-down.z()) / contact::degree);
}
