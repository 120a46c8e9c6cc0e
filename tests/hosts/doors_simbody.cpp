#include <random>

#include "hosts/doors.hpp"
#include "hosts/simbody/hinge_friction.hpp"

namespace contact::test {

using namespace SimTK;  // NOLINT(google-build-using-namespace)

std::vector<DoorRow> simbody_rows(const std::string& file, bool pin,
                                  int count) {
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  GeneralForceSubsystem forces(system);
  // The moment is compared at the reaction that it causes.
  contact_hosts::simbody::HingeFriction friction(
      system, forces, {contact_hosts::simbody::Fit::converged, 1e-13});
  const Force::UniformGravity weight(forces, matter, Vec3(1, 2, -9.81));
  const Body::Rigid body(
      MassProperties(5, Vec3(0, 0, -0.4), Inertia(0.9, 0.95, 0.1)));
  const MobilizedBody link =
      pin ? MobilizedBody(MobilizedBody::Pin(matter.Ground(), body))
          : MobilizedBody(MobilizedBody::Ball(matter.Ground(), body));
  friction.add(link, file);
  State state = system.realizeTopology();
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto three = [](const Vec3& v) { return Three{v[0], v[1], v[2]}; };
  const auto drawn = [&] {
    return Vec3(normal(random), normal(random), normal(random));
  };
  std::vector<DoorRow> rows(count);
  for (DoorRow& row : rows) {
    const Vec3 axis = pin ? Vec3(0, 0, 1) : Vec3(0);
    const double angle = Pi * normal(random);
    link.setQToFitRotation(state, pin ? Rotation(angle, ZAxis)
                                      : Rotation(angle, UnitVec3(drawn())));
    link.setUToFitAngularVelocity(state, pin ? normal(random) * axis : drawn());
    // A pin that reverses has not come to rest.
    friction.settle(state);
    // Evaluates again from consistent moments, so that the solution belongs to
    // their reactions.
    system.realize(state, Stage::Acceleration);
    state.invalidateAllCacheAtOrAbove(Stage::Dynamics);
    system.realize(state, Stage::Acceleration);
    const double* const moment = friction.hinge(0).friction_moment;
    row = {three(link.findMobilizerReactionOnBodyAtMInGround(state)[1]),
           three(link.getBodyAngularVelocity(state)),
           three(axis),
           {moment[0], moment[1], moment[2]}};
  }
  return rows;
}

}  // namespace contact::test
