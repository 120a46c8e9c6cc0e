// A pendulum on a ball joint with dry friction: swings, spins, stops, holds.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>

using Eigen::Vector3d;

int main() {
  const contact::Material steel{2e11, 0.3};  // Pa, 1
  const contact::Joint joint(
      {.geometry =
           contact::JointGeometry::ball(0.02, 20e-6),  // radius, clearance
       .inner = steel,
       .outer = steel,
       .friction = contact::FrictionLaw(0.15, 2e4),  // f0, adhesion
       .half_angle_law = "tanh",
       .pressure_law = "cosine"});

  const double m = 5, dt = 1e-3;
  const Vector3d weight(0, 0, -9.81 * m), centre(0, 0, -0.4);  // body axes
  const Vector3d inertia(0.9, 0.9, 0.02);  // about the joint, body axes
  Eigen::Quaterniond attitude(Eigen::AngleAxisd(1.0, Vector3d::UnitX()));
  Vector3d w(0, 1, 0.5);  // angular velocity against the carrier
  Vector3d R = -weight;   // reaction on the pendulum
  contact::JointStep s;   // the last one is where the next begins
  double time = 0, work = 0;
  for (; time < 60; time += dt) {
    const Eigen::Matrix3d A = attitude.toRotationMatrix();
    const Eigen::Matrix3d J = A * inertia.asDiagonal() * A.transpose();
    const Vector3d c = A * centre, torque = c.cross(weight);
    // Velocity without friction, and with it: exactly 0 as long as the joint
    // holds.
    const Vector3d free = w + dt * J.inverse() * (torque - w.cross(J * w));
    s = step(joint, {.reaction = R, .angular_velocity = w, .free = free},
             J / dt, s);
    if (s.holds && w.isZero(0)) break;
    const Vector3d acceleration = (s.angular_velocity - w) / dt;
    work += dt * s.moment.dot(s.angular_velocity);
    R = m * (acceleration.cross(c) + w.cross(w.cross(c))) - weight;
    w = s.angular_velocity;
    const Vector3d turn = 0.5 * dt * w;
    attitude = Eigen::Quaterniond(1, turn.x(), turn.y(), turn.z()) * attitude;
    attitude.normalize();
  }
  const double tilt = (attitude * centre).normalized().dot(-Vector3d::UnitZ());
  std::printf(
      "rests after %.2f s, %.2f deg from the vertical; friction took "
      "%.2f J\n",
      time, std::acos(tilt) / contact::degree, -work);
}
