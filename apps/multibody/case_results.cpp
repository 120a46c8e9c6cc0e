#include "multibody/case_file.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::ordered_json;

ordered_json array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json results_of_load(const Case& c, const Dynamics<double>& dynamics,
                             int i, const Vector3d& gravity) {
  const Link& link = c.system.links()[i];
  const Matrix3d& axes = link.axes;
  const Reaction<double> reaction = dynamics.reaction(i);
  const Vector3d force = vec3(reaction.force);
  const Vector3d moment = vec3(reaction.moment);
  const Vector3d active = vec3(c.loading.loads[i].force);
  const Vector3d relative = vec3(dynamics.relative_acceleration(i));
  ordered_json result;
  result["acceleration_com"] =
      array(axes * ((active + force) / link.mass + gravity));
  result["angular_acceleration"] =
      array(axes * vec3(dynamics.angular_acceleration(i)));
  if (c.modes[i] == JointMode::released) return result;
  if (link.kind == JointKind::axis) {
    result["angle_acceleration"] = relative.z();
  } else {
    result["relative_angular_acceleration"] = array(axes * relative);
  }
  result["reaction_force"] = array(axes * force);
  if (link.kind == JointKind::axis) {
    const Vector3d m = link.axes_to_hinge * moment;
    result["reaction_moment_hinge_xy"] = {m.x(), m.y()};
  }
  result["reaction_moment"] = array(axes * moment);
  return result;
}

}  // namespace

ordered_json evaluate(const Case& c) {
  Dynamics<double> dynamics(c.system);
  for (int i = 0; i < dynamics.size(); ++i) dynamics.set_mode(i, c.modes[i]);
  dynamics.evaluate(c.state.data(), c.loading);

  const double* const q = &c.state[StateLayout::rotation];
  const Mat3<double> to_inertial =
      rotation(Quaternion<double>{q[0], q[1], q[2], q[3]});
  const Vec3<double> gravity = transposed_times(to_inertial, vec3(c.gravity));
  const CarrierAcceleration<double>& carrier = dynamics.carrier();
  ordered_json result;
  result["carrier_acceleration"] = array(vec3(carrier.linear + gravity));
  result["carrier_acceleration_minus_gravity"] = array(vec3(carrier.linear));
  result["carrier_angular_acceleration"] = array(vec3(carrier.angular));
  result["loads"] = ordered_json::array();
  for (int i = 0; i < dynamics.size(); ++i) {
    // A released load has its own rotation to inertial axes.
    const bool released = c.modes[i] == JointMode::released;
    const StateLayout layout(c.system, c.modes);
    const double* const p = &c.state[layout.offset(i)] + StateLayout::rotation;
    const Vec3<double> local =
        released ? transposed_times(
                       rotation(Quaternion<double>{p[0], p[1], p[2], p[3]}),
                       vec3(c.gravity))
                 : transposed_times(dynamics.axes(i), gravity);
    result["loads"].push_back(results_of_load(c, dynamics, i, vec3(local)));
  }
  return result;
}

}  // namespace multibody
