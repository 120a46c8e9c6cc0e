#include "multibody/dynamics/tree_kernel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "multibody/dynamics/state_rates.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Axes of the parent's equations: link axes, or the carrier's.
Matrix3d parent_axes(const System& system, const Link& link) {
  return link.parent < 0 ? Matrix3d(Matrix3d::Identity())
                         : system.links()[link.parent].axes;
}

ForestBody forest_body(const System& system, const Link& link) {
  ForestBody body{.parent = link.kind == HingeKind::none ? -1 : 1 + link.parent,
                  .kind = link.kind,
                  .mass = link.mass,
                  .inertia = link.inertia};
  if (link.kind == HingeKind::none) return body;
  const HingeTraits traits = hinge_traits(link.kind);
  body.hinge_from_com = link.arm * Vector3d::Unit(traits.arm_axis);
  Vector3d place = link.hinge;
  if (traits.is_axis) {
    body.hinge_from_com.z() = link.pole_offset;
    place += link.pole_offset * link.axes_to_carrier_zero.col(2);
  }
  body.hinge_from_parent_com = parent_axes(system, link).transpose() * place;
  return body;
}

Forest make_forest(const System& system) {
  const Carrier& carrier = system.carrier();
  std::vector<ForestBody> bodies{{.fixed = carrier.fixed,
                                  .mass = carrier.mass,
                                  .inertia = carrier.inertia}};
  for (const Link& link : system.links()) {
    bodies.push_back(forest_body(system, link));
  }
  return Forest(std::move(bodies));
}

Vector3d vector_at(const double* s) { return {s[0], s[1], s[2]}; }

}  // namespace

TreeKernel::TreeKernel(const System& system)
    : links_(system.links()),
      forest_(make_forest(system)),
      state_(1 + system.size()) {
  for (const Link& link : links_) {
    to_parent_link_.push_back(parent_axes(system, link).transpose());
    modes_.push_back(link.kind == HingeKind::none ? JointMode::released
                                                  : JointMode::turning);
  }
  layout_ = StateLayout(system, modes_);
}

void TreeKernel::set_mode(int body, JointMode mode) {
  modes_[body] = mode;
  const bool released = mode == JointMode::released;
  forest_.set_hinge(1 + body, released ? -1 : 1 + links_[body].parent,
                    mode == JointMode::held);
  std::vector<HingeKind> kinds;
  for (const Link& link : links_) kinds.push_back(link.kind);
  layout_ = StateLayout(kinds, modes_);
}

void TreeKernel::set_hinge(int body, const double* numbers) {
  ForestState& to = state_[1 + body];
  if (modes_[body] == JointMode::released) {
    to.angular_velocity = vector_at(numbers + StateLayout::angular_velocity);
    return;
  }
  to.rotation =
      to_parent_link_[body] * relative_rotation(links_[body], numbers);
  to.angular_velocity = relative_rate(links_[body], numbers);
}

void TreeKernel::set_state(const double* state,
                           const LinkForces<double>* bodies) {
  state_[0].angular_velocity = vector_at(state + StateLayout::angular_velocity);
  for (int i = 0; i < size(); ++i) {
    set_hinge(i, state + layout_.offset(i));
    ForestState& to = state_[1 + i];
    to.force = vec3(bodies[i].force);
    to.moment = vec3(bodies[i].moment);
    to.hinge_moment = vec3(bodies[i].friction);
  }
  forest_.prepare(state_, false, work_);
}

void TreeKernel::respond() {
  forest_.respond(state_, work_, motion_);
  carrier_ = {vec3(motion_[0].acceleration),
              vec3(motion_[0].angular_acceleration)};
}

void TreeKernel::evaluate(const double* state,
                          const CarrierActiveForces<double>& carrier,
                          const LinkForces<double>* bodies) {
  forest_.set_fixed(0, false);
  state_[0].force = vec3(carrier.force);
  state_[0].moment = vec3(carrier.moment);
  set_state(state, bodies);
  respond();
}

void TreeKernel::evaluate_prescribed(
    const double* state, const LinkForces<double>* bodies,
    const CarrierAcceleration<double>& carrier) {
  forest_.set_fixed(0, true);
  state_[0].acceleration = vec3(carrier.linear);
  state_[0].angular_acceleration = vec3(carrier.angular);
  set_state(state, bodies);
  respond();
}

void TreeKernel::add_friction(const Vec3<double>* change) {
  for (int i = 0; i < size(); ++i) {
    if (turns(i)) state_[1 + i].hinge_moment += vec3(change[i]);
  }
  respond();
}

void TreeKernel::add_friction(const VectorRows& change) {
  constexpr int next = VectorRows::lanes;
  for (int i = 0; i < size(); ++i) {
    const double* c = change.at(i);
    if (turns(i)) {
      state_[1 + i].hinge_moment += Vector3d(c[0], c[next], c[2 * next]);
    }
  }
  respond();
}

Vec3<double> TreeKernel::relative_acceleration(int body) const {
  const ForestMotion& motion = motion_[1 + body];
  return vec3(modes_[body] == JointMode::released
                  ? motion.angular_acceleration
                  : motion.relative_acceleration);
}

void TreeKernel::relative_accelerations(Vec3<double>* to) const {
  for (int i = 0; i < size(); ++i) to[i] = relative_acceleration(i);
}

Vec3<double> TreeKernel::angular_acceleration(int body) const {
  return vec3(motion_[1 + body].angular_acceleration);
}

Mat3<double> TreeKernel::axes(int body) const {
  if (modes_[body] == JointMode::released) return {};
  return mat3(to_parent_link_[body].transpose() * state_[1 + body].rotation);
}

void TreeKernel::rates(const double* state, const Vec3<double>& gravity,
                       double* to) const {
  body_rates(state, 0, carrier_.linear, gravity, carrier_.angular, to);
  for (int i = 0; i < size(); ++i) {
    const int at = layout_.offset(i);
    const ForestMotion& motion = motion_[1 + i];
    const Vec3<double> turn = relative_acceleration(i);
    switch (modes_[i]) {
      case JointMode::released:
        body_rates(state, at, vec3(motion.acceleration), gravity, turn, to);
        break;
      case JointMode::held:
        std::fill_n(to + at, StateLayout::link_size(links_[i].kind, modes_[i]),
                    0.0);
        break;
      case JointMode::turning:
        if (links_[i].kind == HingeKind::axis) {
          to[at] = state[at + 1];
          to[at + 1] = turn.z;
        } else {
          turn_rates(state, at, at + 4, turn, to);
        }
    }
  }
}

Reaction<double> TreeKernel::reaction(int body) const {
  const ForestMotion& motion = motion_[1 + body];
  Vector3d moment = motion.reaction_moment;
  // Friction is not in it.
  if (turns(body)) {
    if (links_[body].kind == HingeKind::ball) moment.setZero();
    moment.z() = 0;
  }
  return {vec3(motion.reaction), vec3(moment)};
}

void TreeKernel::reactions(Reaction<double>* to) const {
  for (int i = 0; i < size(); ++i) to[i] = reaction(i);
}

void TreeKernel::reactions(const VectorRows& force,
                           const VectorRows* moment) const {
  const auto put = [](const VectorRows& rows, int i, const Vec3<double>& v) {
    constexpr int next = VectorRows::lanes;
    double* const to = rows.at(i);
    to[0] = v.x;
    to[next] = v.y;
    to[2 * next] = v.z;
  };
  for (int i = 0; i < size(); ++i) {
    const Reaction<double> r = reaction(i);
    put(force, i, r.force);
    if (moment) put(*moment, i, r.moment);
  }
}

void TreeKernel::fitting_moments(std::span<const Vec3<double>> moments,
                                 std::span<const Matrix3d> slopes,
                                 std::span<Vec3<double>> to) {
  sloped_state_ = state_;
  for (int i = 0; i < size(); ++i) {
    sloped_state_[1 + i].hinge_moment = vec3(moments[i]);
    sloped_state_[1 + i].slope = slopes[i];
  }
  forest_.prepare(sloped_state_, true, sloped_work_);
  forest_.respond(sloped_state_, sloped_work_, sloped_motion_);
  for (int i = 0; i < size(); ++i) {
    const Vector3d m =
        vec3(moments[i]) + slopes[i] * sloped_motion_[1 + i].reaction;
    to[i] = {};
    if (!turns(i)) continue;
    // On an axis (z) the hinge holds the other parts.
    to[i] =
        links_[i].kind == HingeKind::axis ? Vec3<double>{0, 0, m.z()} : vec3(m);
  }
}

}  // namespace multibody::detail
