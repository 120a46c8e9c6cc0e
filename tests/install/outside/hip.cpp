// Friction of a hip: a CoCr head of 28 mm in 8 mm of polyethylene on a stiff
// shell, turning under 2000 N about an axis 60 degrees off the load.
#include <cmath>
#include <cstdio>
#include <libcontact/contact.hpp>

int main() {
  const auto ball = contact::JointKind::ball;
  const contact::Material cobalt{230e9, 0.3};  // Pa, 1
  const contact::Material polyethylene{1e9, 0.4};
  const contact::ElasticPair materials(cobalt, polyethylene);
  const contact::ContactConditions cup{
      .walls = contact::LayeredPair(
          0.014, {{}, contact::Backing::medium(cobalt)},
          {{{0.008, polyethylene}}, contact::Backing::rigid()})};  // m
  const contact::Joint hip(
      {contact::JointGeometry::ball(0.014, 100e-6),  // radius, clearance, m
       materials, contact::FrictionLaw(0.062),
       contact::make_half_angle_law("exact", ball, materials, {}, cup),
       contact::make_pressure_law("exact", ball, materials, cup)});

  const double beta = 60 * contact::degree;
  const contact::JointSolution s = hip.solve(
      {.reaction = {0, 0, 2000},                                   // N
       .angular_velocity = {std::sin(beta), 0, std::cos(beta)}});  // rad/s
  std::printf("half-angle %.2f deg, normal force %.1f N, moment %.4f N m\n",
              s.half_angle / contact::degree, s.normal_force,
              s.friction_moment.norm());
}
