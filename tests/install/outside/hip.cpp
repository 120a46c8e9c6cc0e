// Friction of a hip: a CoCr head of 28 mm in polyethylene, turning under 2000 N
// about an axis 60 degrees off the load.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>

int main() {
  const auto ball = contact::JointKind::ball;
  const contact::ElasticPair materials({230e9, 0.3}, {1e9, 0.4});  // Pa, 1
  const contact::Joint hip(
      {contact::JointGeometry::ball(0.014, 100e-6),  // radius, clearance, m
       materials, contact::FrictionLaw(0.062),
       contact::make_half_angle_law("fitted", ball, materials),
       contact::make_pressure_law("cosine", ball, materials)});

  const double beta = 60 * contact::degree;
  const contact::JointSolution s = hip.solve(
      {.reaction = {0, 0, 2000},                                   // N
       .angular_velocity = {std::sin(beta), 0, std::cos(beta)}});  // rad/s
  std::printf("half-angle %.2f deg, normal force %.1f N, moment %.4f N m\n",
              s.half_angle / contact::degree, s.normal_force,
              s.friction_moment.norm());
}
