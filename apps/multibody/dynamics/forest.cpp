#include "multibody/dynamics/forest.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <string>
#include <utility>

#include "libcontact/base/error.hpp"
#include "multibody/system/tree_order.hpp"

namespace multibody {
namespace {

using detail::ForestPart;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

ForestPart::Turn turn_of(const ForestBody& body) {
  if (body.held) return ForestPart::Turn::none;
  return body.kind == HingeKind::axis ? ForestPart::Turn::axis
                                      : ForestPart::Turn::ball;
}

void set_motion(const ForestBody& body, const ForestState& state,
                const ForestPart& parent, ForestPart& p) {
  const auto to_body = state.rotation.transpose();
  p.turn = turn_of(body);
  p.axis = body.axis;
  p.rotation = state.rotation;
  p.from_parent = body.hinge_from_parent_com - parent.r;
  p.r = body.hinge_from_com;
  Vector3d relative = state.angular_velocity;
  if (body.held) relative.setZero();
  if (p.turn == ForestPart::Turn::axis) {
    relative = body.axis * body.axis.dot(relative);
  }
  const Vector3d w = to_body * parent.w;
  p.w = w + relative;
  p.linear_bias = to_body * parent.w.cross(parent.w.cross(p.from_parent));
  p.angular_bias = w.cross(relative);
}

Matrix6 matrix_of(const ForestPart& p, bool sloped) {
  Matrix6 m;
  m << p.a, p.b, sloped ? p.c : Matrix3d(p.b.transpose()), p.d;
  return m;
}

[[noreturn]] void refuse_body(std::size_t i, const std::string& what) {
  throw contact::Error(fmt::format("bodies[{}]{}", i, what));
}

void check(const std::vector<ForestBody>& bodies, std::size_t i) {
  const ForestBody& b = bodies[i];
  if (b.parent >= 0 && b.fixed) {
    refuse_body(i, ".fixed must be false for a body with a parent");
  }
  if (b.parent >= 0 && b.kind == HingeKind::none) {
    refuse_body(i, ".kind must be ball or axis for a body with a parent");
  }
  if (!b.fixed && !(std::isfinite(b.mass) && b.mass > 0)) {
    refuse_body(
        i, fmt::format(".mass = {} kg must be above 0 and finite", b.mass));
  }
  if (!b.inertia.allFinite() || !b.hinge_from_com.allFinite() ||
      !b.hinge_from_parent_com.allFinite()) {
    refuse_body(i, ": inertia and hinge points must be finite");
  }
  // Seven printed digits pass.
  if (!(std::abs(b.axis.norm() - 1) <= 1e-6)) {
    refuse_body(
        i, fmt::format(".axis has the length {}, it must be 1", b.axis.norm()));
  }
}

}  // namespace

Forest::Forest(std::vector<ForestBody> bodies) : bodies_(std::move(bodies)) {
  std::vector<int> parents;
  for (const ForestBody& body : bodies_) parents.push_back(body.parent);
  order_ = parents_first(parents);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    check(bodies_, i);
    bodies_[i].axis.normalize();
  }
}

void Forest::prepare(const std::vector<ForestState>& state, bool sloped,
                     ForestWork& work) const {
  work.parts.resize(bodies_.size());
  work.roots.resize(bodies_.size());
  std::vector<ForestPart>& parts = work.parts;
  for (const int i : order_) {
    const ForestBody& body = bodies_[i];
    ForestPart& p = parts[i];
    if (body.parent >= 0) {
      set_motion(body, state[i], parts[body.parent], p);
    } else {
      p.w = state[i].angular_velocity;
      p.r.setZero();
    }
    p.set_own(body.mass, body.inertia, state[i].force, state[i].moment);
    p.slope = sloped ? state[i].slope : Matrix3d(Matrix3d::Zero());
  }
  for (auto i = order_.rbegin(); i != order_.rend(); ++i) {
    const ForestBody& body = bodies_[*i];
    ForestPart& p = parts[*i];
    if (body.parent < 0) {
      if (!body.fixed) work.roots[*i].compute(matrix_of(p, sloped));
    } else if (sloped) {
      p.eliminate<true>(parts[body.parent]);
    } else {
      p.eliminate<false>(parts[body.parent]);
    }
  }
}

void Forest::respond(const std::vector<ForestState>& state, ForestWork& work,
                     std::vector<ForestMotion>& to) const {
  to.resize(bodies_.size());
  std::vector<ForestPart>& parts = work.parts;
  for (ForestPart& p : parts) {
    p.force = p.own_force;
    p.moment = p.own_moment;
  }
  for (auto i = order_.rbegin(); i != order_.rend(); ++i) {
    const int parent = bodies_[*i].parent;
    if (parent < 0) continue;
    parts[*i].eliminate_load(state[*i].hinge_moment, parts[parent]);
  }
  for (const int i : order_) {
    const ForestBody& body = bodies_[i];
    ForestPart& p = parts[i];
    ForestPart::Reaction reaction{Vector3d::Zero(), Vector3d::Zero(),
                                  Vector3d::Zero()};
    if (body.parent >= 0) {
      reaction = p.resolve(state[i].hinge_moment, parts[body.parent]);
    } else if (body.fixed) {
      p.linear = state[i].acceleration;
      p.angular = state[i].angular_acceleration;
    } else {
      Vector6 load;
      load << p.force, p.moment;
      const Vector6 acceleration = -work.roots[i].solve(load);
      p.linear = acceleration.head<3>();
      p.angular = acceleration.tail<3>();
    }
    // The centre of mass is at -r from the origin.
    to[i] = {p.linear - p.angular.cross(p.r) - p.w.cross(p.w.cross(p.r)),
             p.angular, reaction.turn, reaction.force, reaction.moment};
  }
}

std::vector<ForestMotion> Forest::solve(const std::vector<ForestState>& state,
                                        const Vector3d& gravity) const {
  if (state.size() != bodies_.size()) {
    throw contact::Error(
        fmt::format("{} states for {} bodies", state.size(), bodies_.size()));
  }
  std::vector<Vector3d> down(bodies_.size());
  std::vector<ForestState> falling = state;
  for (const int i : order_) {
    const int parent = bodies_[i].parent;
    down[i] =
        state[i].rotation.transpose() * (parent < 0 ? gravity : down[parent]);
    falling[i].acceleration -= down[i];
  }
  ForestWork work;
  std::vector<ForestMotion> to;
  prepare(falling, true, work);
  respond(falling, work, to);
  for (std::size_t i = 0; i < to.size(); ++i) to[i].acceleration += down[i];
  return to;
}

}  // namespace multibody
