#include "hosts/ode/hinge_friction.hpp"

#include <Eigen/Geometry>

namespace contact_hosts::ode {
namespace {

using Eigen::Vector3d;
using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Vector3d rate_of(dBodyID body) {
  if (!body) return Vector3d::Zero();
  const dReal* const w = dBodyGetAngularVel(body);
  return {w[0], w[1], w[2]};
}

// Rotates from body axes to world axes.
Rotation axes_of(dBodyID body) {
  Rotation axes = Rotation::Identity();
  for (int i = 0; body && i < 9; ++i) {
    axes(i / 3, i % 3) = dBodyGetRotation(body)[i / 3 * 4 + i % 3];
  }
  return axes;
}

// An upper bound of the inertia about any axis.
double largest_inertia(dBodyID body) {
  dMass mass;
  dBodyGetMass(body, &mass);
  return mass.I[0] + mass.I[5] + mass.I[10];
}

void set_axes(dJointID motor, const Vector3d& first, int count, double limit) {
  const Vector3d u = first.normalized();
  const Vector3d v = u.unitOrthogonal();
  const Vector3d axes[] = {u, v, u.cross(v)};
  dJointSetAMotorNumAxes(motor, count);
  for (int i = 0; i < count; ++i) {
    dJointSetAMotorAxis(motor, i, 0, axes[i].x(), axes[i].y(), axes[i].z());
    const int group = dParamGroup * i;
    dJointSetAMotorParam(motor, dParamVel + group, 0);
    dJointSetAMotorParam(motor, dParamFMax + group, limit);
  }
}

}  // namespace

void HingeFriction::add(dJointID joint, const std::string& file) {
  const dJointType type = dJointGetType(joint);
  if (type != dJointTypeBall && type != dJointTypeHinge) {
    throw std::runtime_error(
        "HingeFriction::add: joint must be a ball or hinge");
  }
  const bool is_ball = type == dJointTypeBall;
  FrictionMoment contact(read_dry_joint(file, "HingeFriction::add",
                                        is_ball ? CONTACT_BALL : CONTACT_PIN));
  feedback_.push_back(std::make_unique<dJointFeedback>());
  dJointSetFeedback(joint, feedback_.back().get());
  dJointID motor = nullptr;
  if (is_ball) {
    motor = dJointCreateAMotor(world_, nullptr);
    dJointAttach(motor, dJointGetBody(joint, 0), dJointGetBody(joint, 1));
    dJointSetAMotorMode(motor, dAMotorUser);
  }
  hinges_.push_back(
      {joint, motor, std::move(contact), feedback_.back().get(), 0});
}

void HingeFriction::update(double step) {
  for (Hinge& h : hinges_) {
    dBodyID const body = dJointGetBody(h.joint, 0);
    Vector3d rate = rate_of(body) - rate_of(dJointGetBody(h.joint, 1));
    contact_slip slip{};
    for (int i = 0; i < 3; ++i) slip.reaction[i] = h.feedback->f1[i];
    if (!h.motor) {
      dVector3 axis;
      dJointGetHingeAxis(h.joint, axis);
      for (int i = 0; i < 3; ++i) slip.axis[i] = axis[i];
      rate = Vector3d(slip.axis);  // any rate along the axis
    }
    if (rate.isZero(0)) rate = Vector3d::UnitX();
    Vector3d::Map(slip.angular_velocity) = rate;
    const bool on_carrier = h.contact.seat() == Seat::on_carrier;
    Vector3d moment;
    h.contact.find(slip, axes_of(dJointGetBody(h.joint, on_carrier)).data(),
                   moment.data());
    h.limit = moment.norm();
    if (h.motor) {
      const bool stops =
          rate.norm() * largest_inertia(body) <= 2 * h.limit * step;
      set_axes(h.motor, h.limit > 0 ? moment : rate, stops ? 3 : 1, h.limit);
    } else {
      dJointSetHingeParam(h.joint, dParamVel, 0);
      dJointSetHingeParam(h.joint, dParamFMax, h.limit);
    }
  }
}

}  // namespace contact_hosts::ode
