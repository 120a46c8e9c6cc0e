#include "multibody/dynamics/tree_kernel.hpp"

#include <algorithm>
#include <utility>

#include "multibody/dynamics/state_rates.hpp"
#include "multibody/system/eigen_conversion.hpp"

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

Forest make_forest(const System& system, contact::InstructionSet set) {
  const Carrier& carrier = system.carrier();
  std::vector<ForestBody> bodies{{.fixed = carrier.fixed,
                                  .mass = carrier.mass,
                                  .inertia = carrier.inertia}};
  for (const Link& link : system.links()) {
    bodies.push_back(forest_body(system, link));
  }
  return Forest(std::move(bodies), set);
}

Vec3<double> vector_at(const double* s) { return {s[0], s[1], s[2]}; }

Mat3<double> product(const Mat3<double>& m, const Mat3<double>& n) {
  return {m * n.x, m * n.y, m * n.z};
}

}  // namespace

TreeKernel::TreeKernel(const System& system, contact::InstructionSet set)
    : forest_(make_forest(system, set)), state_(1 + system.size()) {
  for (const Link& link : system.links()) {
    kinds_.push_back(link.kind);
    parents_.push_back(link.parent);
    to_parent_link_.push_back(mat3(parent_axes(system, link).transpose()));
    zero_.push_back(
        product(to_parent_link_.back(), mat3(link.axes_to_carrier_zero)));
    modes_.push_back(link.kind == HingeKind::none ? JointMode::released
                                                  : JointMode::turning);
  }
  layout_ = StateLayout(kinds_, modes_);
  // Whole packets of four.
  angles_.resize((modes_.size() + 3) / 4 * 4);
  sines_ = cosines_ = angles_;
}

void TreeKernel::set_mode(int body, JointMode mode) {
  modes_[body] = mode;
  const bool released = mode == JointMode::released;
  forest_.set_hinge(1 + body, released ? -1 : 1 + parents_[body],
                    mode == JointMode::held);
  layout_ = StateLayout(kinds_, modes_);
}

void TreeKernel::set_hinge(int body, const double* numbers) {
  ForestState& to = state_[1 + body];
  if (modes_[body] == JointMode::released) {
    to.angular_velocity = vector_at(numbers + StateLayout::angular_velocity);
  } else if (kinds_[body] == HingeKind::axis) {
    to.rotation = turned_about_z(zero_[body], cosines_[body], sines_[body]);
    to.angular_velocity = {0, 0, numbers[1]};
  } else {
    to.rotation = product(to_parent_link_[body],
                          rotation(Quaternion<double>{numbers[0], numbers[1],
                                                      numbers[2], numbers[3]}));
    to.angular_velocity = vector_at(numbers + 4);
  }
}

void TreeKernel::set_state(const double* state,
                           const LinkForces<double>* bodies) {
  state_[0].angular_velocity = vector_at(state + StateLayout::angular_velocity);
  for (int i = 0; i < size(); ++i) {
    // For a released body this number is a position.
    if (kinds_[i] == HingeKind::axis && modes_[i] != JointMode::released) {
      angles_[i] = state[layout_.offset(i)];
    }
  }
  forest_.kernel().sines(size(), angles_.data(), sines_.data(),
                         cosines_.data());
  for (int i = 0; i < size(); ++i) {
    set_hinge(i, state + layout_.offset(i));
    ForestState& to = state_[1 + i];
    to.force = bodies[i].force;
    to.moment = bodies[i].moment;
    to.hinge_moment = bodies[i].friction;
  }
  forest_.prepare(state_, false, work_);
}

void TreeKernel::respond() {
  forest_.respond(state_, work_);
  carrier_ = {work_.acceleration(0), work_.angular_acceleration(0)};
}

void TreeKernel::evaluate(const double* state,
                          const CarrierActiveForces<double>& carrier,
                          const LinkForces<double>* bodies) {
  forest_.set_fixed(0, false);
  state_[0].force = carrier.force;
  state_[0].moment = carrier.moment;
  set_state(state, bodies);
  respond();
}

void TreeKernel::evaluate_prescribed(
    const double* state, const LinkForces<double>* bodies,
    const CarrierAcceleration<double>& carrier) {
  forest_.set_fixed(0, true);
  state_[0].acceleration = carrier.linear;
  state_[0].angular_acceleration = carrier.angular;
  set_state(state, bodies);
  respond();
}

void TreeKernel::add_friction(const Vec3<double>* change) {
  for (int i = 0; i < size(); ++i) {
    if (turns(i)) state_[1 + i].hinge_moment += change[i];
  }
  respond();
}

void TreeKernel::add_friction(const VectorRows& change) {
  constexpr int next = VectorRows::lanes;
  for (int i = 0; i < size(); ++i) {
    const double* c = change.at(i);
    if (turns(i)) {
      state_[1 + i].hinge_moment += Vec3<double>{c[0], c[next], c[2 * next]};
    }
  }
  respond();
}

Vec3<double> TreeKernel::relative_acceleration(int body) const {
  if (modes_[body] == JointMode::released) return angular_acceleration(body);
  // Values tiny compared with other parts are rounding.
  if (kinds_[body] == HingeKind::axis) {
    return {0, 0, turns(body) ? work_.rate_change(1 + body) : 0};
  }
  return work_.relative_acceleration(1 + body);
}

void TreeKernel::relative_accelerations(Vec3<double>* to) const {
  for (int i = 0; i < size(); ++i) to[i] = relative_acceleration(i);
}

Vec3<double> TreeKernel::angular_acceleration(int body) const {
  return work_.angular_acceleration(1 + body);
}

Mat3<double> TreeKernel::axes(int body) const {
  if (modes_[body] == JointMode::released) return {};
  const auto to_own = [&](const Vec3<double>& v) {
    return transposed_times(to_parent_link_[body], v);
  };
  const Mat3<double>& axes = state_[1 + body].rotation;
  return {to_own(axes.x), to_own(axes.y), to_own(axes.z)};
}

void TreeKernel::rates(const double* state, const Vec3<double>& gravity,
                       double* to) const {
  body_rates(state, 0, carrier_.linear, gravity, carrier_.angular, to);
  for (int i = 0; i < size(); ++i) {
    const int at = layout_.offset(i);
    const Vec3<double> turn = relative_acceleration(i);
    switch (modes_[i]) {
      case JointMode::released:
        body_rates(state, at, work_.acceleration(1 + i), gravity, turn, to);
        break;
      case JointMode::held:
        std::fill_n(to + at, StateLayout::link_size(kinds_[i], modes_[i]), 0.0);
        break;
      case JointMode::turning:
        if (kinds_[i] == HingeKind::axis) {
          to[at] = state[at + 1];
          to[at + 1] = turn.z;
        } else {
          turn_rates(state, at, at + 4, turn, to);
        }
    }
  }
}

Reaction<double> TreeKernel::reaction(int body) const {
  const Vec3<double> force = work_.reaction(1 + body);
  // The reaction does not include friction.
  if (!turns(body)) return {force, work_.reaction_moment(1 + body)};
  if (kinds_[body] == HingeKind::ball) return {force, {}};
  const Vec3<double> moment = work_.reaction_moment(1 + body);
  return {force, {moment.x, moment.y, 0}};
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
    sloped_state_[1 + i].hinge_moment = moments[i];
    sloped_state_[1 + i].slope = mat3(slopes[i]);
  }
  forest_.prepare(sloped_state_, true, sloped_work_);
  forest_.respond(sloped_state_, sloped_work_);
  for (int i = 0; i < size(); ++i) {
    to[i] = {};
    if (!turns(i)) continue;
    // Computed by the law, because in the balance it is a difference of large
    // moments. On an axis (z) the hinge carries the other components.
    const ForestState& s = sloped_state_[1 + i];
    const Vec3<double> m =
        s.hinge_moment + s.slope * sloped_work_.reaction(1 + i);
    to[i] = kinds_[i] == HingeKind::axis ? Vec3<double>{0, 0, m.z} : m;
  }
}

}  // namespace multibody::detail
