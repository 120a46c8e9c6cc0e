#include "multibody/dynamics/forest.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <string>
#include <utility>

#include "libcontact/base/error.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Turns = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
using Columns6 = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 3>;
using Rows6 = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 3, 6>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// The directions T in which the hinge turns, body axes.
Turns turns(const ForestBody& body) {
  if (body.held) return Turns(3, 0);
  if (body.kind == HingeKind::axis) return body.axis;
  return Matrix3d::Identity();
}

// A body between the two steps. Origin: its hinge's centre; of a root: its
// centre of mass. (R; M) = inertia (v'; w') + load.
struct Part {
  Vector3d r = Vector3d::Zero();  // of the origin from the centre of mass
  Vector3d w;                     // absolute angular velocity
  Vector3d gravity;
  Matrix6 inertia;
  Vector6 load;
  Matrix6 shift;  // the parent's motion at the hinge, body axes
  Vector6 bias;   // accelerations for those of the parent 0 and no turn
  Turns t;
  Columns6 inertia_t;
  Rows6 row;     // E = T^T (-S, 1)
  Square pivot;  // D^-1
  Vector given;  // T^T M for R = 0
  Vector6 acceleration;
};

// Its own equations, before anything hangs on it.
void set_inertia(const ForestBody& body, const ForestState& state, Part& p) {
  const Matrix3d r = cross_matrix(p.r);
  p.inertia << body.mass * Matrix3d::Identity(), body.mass * r, -body.mass * r,
      body.inertia - body.mass * r * r;
  const Vector3d force = -body.mass * p.w.cross(p.w.cross(p.r)) - state.force;
  p.load << force,
      p.w.cross(body.inertia * p.w) - state.moment - p.r.cross(force);
}

void set_motion(const ForestBody& body, const ForestState& state,
                const Part& parent, Part& p) {
  const Matrix3d to_body = state.rotation.transpose();
  const Vector3d from_parent = body.hinge_from_parent_com - parent.r;
  p.r = body.hinge_from_com;
  const Vector3d w = to_body * parent.w;
  const Vector3d relative =
      body.held ? Vector3d::Zero().eval()
      : body.kind == HingeKind::axis
          ? (body.axis * body.axis.dot(state.angular_velocity)).eval()
          : state.angular_velocity;
  p.w = w + relative;
  p.gravity = to_body * parent.gravity;
  p.shift << to_body, -to_body * cross_matrix(from_parent), Matrix3d::Zero(),
      to_body;
  p.bias << to_body * parent.w.cross(parent.w.cross(from_parent)),
      w.cross(relative);
  set_inertia(body, state, p);
}

// First step: what the parent sees of the body and all that hangs on it.
void eliminate(const ForestBody& body, const ForestState& state, Part& p,
               Part& parent) {
  p.t = turns(body);
  p.load += p.inertia * p.bias;
  p.row.resize(p.t.cols(), 6);
  p.row << -p.t.transpose() * state.slope, p.t.transpose();
  p.inertia_t = p.inertia.rightCols<3>() * p.t;
  p.given = p.t.transpose() * state.hinge_moment;
  Matrix6 inertia = p.inertia;
  Vector6 load = p.load;
  if (p.t.cols() > 0) {
    p.pivot = (p.row * p.inertia_t).inverse();
    inertia -= p.inertia_t * p.pivot * (p.row * p.inertia);
    load += p.inertia_t * (p.pivot * (p.given - p.row * p.load));
  }
  parent.inertia += p.shift.transpose() * inertia * p.shift;
  parent.load += p.shift.transpose() * load;
}

// Second step. The load has the bias in it.
ForestMotion resolve(const Part& parent, Part& p) {
  ForestMotion to;
  const Vector6 prescribed = p.shift * parent.acceleration;
  p.acceleration = prescribed + p.bias;
  to.relative_acceleration.setZero();
  if (p.t.cols() > 0) {
    to.relative_acceleration =
        p.t * (p.pivot * (p.given - p.row * (p.inertia * prescribed + p.load)));
    p.acceleration.tail<3>() += to.relative_acceleration;
  }
  const Vector6 reaction = p.inertia * (p.acceleration - p.bias) + p.load;
  to.reaction = reaction.head<3>();
  to.reaction_moment = reaction.tail<3>();
  return to;
}

[[noreturn]] void refuse_body(std::size_t i, const std::string& what) {
  throw contact::Error(fmt::format("bodies[{}]{}", i, what));
}

void check(const std::vector<ForestBody>& bodies, std::size_t i) {
  const ForestBody& b = bodies[i];
  const int size = static_cast<int>(bodies.size());
  if (b.parent < -1 || b.parent >= size) {
    refuse_body(i, fmt::format(".parent = {} must be one of the {} bodies, or "
                               "-1 for a root",
                               b.parent, size));
  }
  if (b.parent == static_cast<int>(i)) refuse_body(i, " hangs on itself");
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
  const std::size_t n = bodies_.size();
  for (std::size_t i = 0; i < n; ++i) {
    check(bodies_, i);
    bodies_[i].axis.normalize();
  }
  // From each body up to one that is in order, then down again.
  std::vector<bool> done(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<int> up;
    for (int k = static_cast<int>(i); k >= 0 && !done[k];
         k = bodies_[k].parent) {
      up.push_back(k);
      if (up.size() <= n) continue;
      std::string circle = fmt::format("bodies[{}]", k);
      for (int j = bodies_[k].parent; j != k; j = bodies_[j].parent) {
        circle += fmt::format(" on bodies[{}]", j);
      }
      throw contact::Error(circle + fmt::format(" on bodies[{}]: a circle", k));
    }
    for (auto k = up.rbegin(); k != up.rend(); ++k) {
      done[*k] = true;
      order_.push_back(*k);
    }
  }
}

std::vector<ForestMotion> Forest::solve(const std::vector<ForestState>& state,
                                        const Vector3d& gravity) const {
  if (state.size() != bodies_.size()) {
    throw contact::Error(
        fmt::format("{} states for {} bodies", state.size(), bodies_.size()));
  }
  std::vector<Part> parts(bodies_.size());
  for (const int i : order_) {
    const ForestBody& body = bodies_[i];
    if (body.parent >= 0) {
      set_motion(body, state[i], parts[body.parent], parts[i]);
      continue;
    }
    parts[i].w = state[i].angular_velocity;
    parts[i].gravity = state[i].rotation.transpose() * gravity;
    set_inertia(body, state[i], parts[i]);
  }
  for (auto i = order_.rbegin(); i != order_.rend(); ++i) {
    const int parent = bodies_[*i].parent;
    if (parent >= 0) {
      eliminate(bodies_[*i], state[*i], parts[*i], parts[parent]);
    }
  }
  std::vector<ForestMotion> to(bodies_.size());
  for (const int i : order_) {
    const ForestBody& body = bodies_[i];
    Part& p = parts[i];
    if (body.parent >= 0) {
      to[i] = resolve(parts[body.parent], p);
    } else {
      to[i].relative_acceleration.setZero();
      to[i].reaction.setZero();
      to[i].reaction_moment.setZero();
      if (body.fixed) {
        p.acceleration << -p.gravity, Vector3d::Zero();
      } else {
        p.acceleration = -p.inertia.partialPivLu().solve(p.load);
      }
    }
    to[i].angular_acceleration = p.acceleration.tail<3>();
    // The centre of mass is at -r from the origin.
    to[i].acceleration = p.acceleration.head<3>() + p.gravity -
                         to[i].angular_acceleration.cross(p.r) -
                         p.w.cross(p.w.cross(p.r));
  }
  return to;
}

}  // namespace multibody
