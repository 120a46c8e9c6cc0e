// Compiled with assertions on, as the distribution compiled the library.
#include "simbody_system.hpp"

#include <Simbody.h>

namespace multibody::bench {
namespace {

using SimTK::MobilizedBody;

SimTK::Vec3 simtk(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
SimTK::Rotation simtk_rotation(const Eigen::Matrix3d& m) {
  return SimTK::Rotation(SimTK::Mat33(m(0, 0), m(0, 1), m(0, 2), m(1, 0),
                                      m(1, 1), m(1, 2), m(2, 0), m(2, 1),
                                      m(2, 2)));
}
SimTK::Body::Rigid rigid_body(double mass, const Eigen::Matrix3d& i) {
  return SimTK::Body::Rigid(SimTK::MassProperties(
      mass, SimTK::Vec3(0),
      SimTK::Inertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2))));
}
Eigen::Vector3d eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

struct SimbodySystem::Parts {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  MobilizedBody carrier;
  std::vector<MobilizedBody> bodies;
  SimTK::State state;
  SimTK::Vector_<SimTK::SpatialVec> reactions;
};

SimbodySystem::SimbodySystem(const Instant& instant)
    : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  // A handle: the force itself stays with p.forces.
  const SimTK::Force::UniformGravity gravity(p.forces, p.matter,
                                             simtk(instant.gravity));
  MobilizedBody::Free carrier(
      p.matter.Ground(),
      rigid_body(instant.carrier.mass, instant.carrier.inertia));
  p.carrier = carrier;
  std::vector<MobilizedBody>& bodies = p.bodies;
  for (const BodyInstant& body : instant.bodies) {
    const Body& l = body.body;
    const SimTK::Body::Rigid b = rigid_body(l.mass, l.inertia);
    MobilizedBody parent = l.parent < 0 ? p.carrier : bodies[l.parent];
    if (l.kind == HingeKind::axis) {
      bodies.push_back(MobilizedBody::Pin(
          parent,
          SimTK::Transform(simtk_rotation(l.hinge_to_carrier_zero),
                           simtk(l.hinge_from_carrier_com)),
          b,
          SimTK::Transform(simtk_rotation(l.hinge_to_body),
                           simtk(l.hinge_from_com))));
    } else {
      bodies.push_back(MobilizedBody::Ball(
          parent, SimTK::Transform(simtk(l.hinge_from_carrier_com)), b,
          SimTK::Transform(simtk(l.hinge_from_com))));
    }
  }
  p.state = p.system.realizeTopology();
  carrier.setQToFitTransform(p.state,
                             SimTK::Transform(simtk_rotation(instant.rotation),
                                              simtk(instant.position)));
  p.system.realize(p.state, SimTK::Stage::Position);
  carrier.setUToFitVelocity(
      p.state,
      SimTK::SpatialVec(simtk(instant.rotation * instant.angular_velocity),
                        simtk(instant.velocity)));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyInstant& body = instant.bodies[i];
    if (body.body.kind == HingeKind::axis) {
      bodies[i].setOneQ(p.state, 0, body.angle);
      bodies[i].setOneU(p.state, 0, body.angle_rate);
    } else {
      bodies[i].setQToFitRotation(p.state, simtk_rotation(body.rotation));
      bodies[i].setUToFitAngularVelocity(
          p.state, simtk(body.rotation * body.relative_angular_velocity));
    }
  }
}

SimbodySystem::~SimbodySystem() = default;

void SimbodySystem::advance(double time, double accuracy) {
  SimTK::RungeKuttaMersonIntegrator integrator(parts_->system);
  integrator.setAccuracy(accuracy);
  integrator.setConstraintTolerance(1e-12);
  SimTK::TimeStepper stepper(parts_->system, integrator);
  stepper.initialize(parts_->state);
  stepper.stepTo(parts_->state.getTime() + time);
  parts_->state = integrator.getState();
  parts_->system.realize(parts_->state, SimTK::Stage::Position);
}

std::vector<Eigen::Vector3d> SimbodySystem::positions() const {
  std::vector<Eigen::Vector3d> result;
  const auto add = [&](const MobilizedBody& body) {
    result.push_back(eigen(body.getBodyOriginLocation(parts_->state)));
  };
  add(parts_->carrier);
  for (const MobilizedBody& body : parts_->bodies) add(body);
  return result;
}

void SimbodySystem::evaluate() {
  parts_->state.updQ();  // as if an integrator had written it
  parts_->system.realize(parts_->state, SimTK::Stage::Acceleration);
}

void SimbodySystem::find_reactions() {
  parts_->matter.calcMobilizerReactionForces(parts_->state, parts_->reactions);
}

Eigen::Vector3d SimbodySystem::carrier_acceleration() const {
  const MobilizedBody& body = parts_->carrier;
  const SimTK::State& state = parts_->state;
  return eigen(~body.getBodyRotation(state) *
               body.getBodyOriginAcceleration(state));
}

Eigen::Vector3d SimbodySystem::carrier_angular_acceleration() const {
  const MobilizedBody& body = parts_->carrier;
  const SimTK::State& state = parts_->state;
  return eigen(~body.getBodyRotation(state) *
               body.getBodyAngularAcceleration(state));
}

}  // namespace multibody::bench
