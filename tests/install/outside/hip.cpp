// Friction of a hip: a CoCr head of 28 mm in 8 mm of polyethylene on a stiff
// shell, turning under 2000 N about an axis 60 degrees off the load.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>

int main() {
  using namespace contact;
  const Joint hip(
      {.geometry = JointGeometry::ball(0.014, 100e-6),  // radius, clearance, m
       .inner = Material{230e9, 0.3},                   // Pa, 1
       .outer = {{{0.008, {1e9, 0.4}}}, Backing::rigid()},
       .friction = FrictionLaw(0.0587)});

  const double beta = 60 * degree;
  const JointSolution s = hip.solve(
      {.reaction = {0, 0, 2000},                                   // N
       .angular_velocity = {std::sin(beta), 0, std::cos(beta)}});  // rad/s
  std::printf("half-angle %.2f deg, normal force %.1f N, moment %.4f N m\n",
              s.half_angle / degree, s.normal_force, s.friction_moment.norm());
}
