#include "multibody/dynamics/forest.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <string>
#include <utility>

#include "libcontact/base/error.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/tree_order.hpp"

namespace multibody {
namespace {

using detail::ForestPart;
using detail::ForestTurn;
using detail::Padded;
using detail::PaddedMatrix;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Pivoted = Eigen::PartialPivLU<Matrix6>;

Vector3d vector(const Padded& v) { return vec3(vec3(v)); }
Matrix3d matrix(const PaddedMatrix& m) {
  Matrix3d to;
  to << vector(m.x), vector(m.y), vector(m.z);
  return to;
}

ForestTurn turn_of(const ForestBody& body) {
  if (body.held) return ForestTurn::none;
  return body.kind == HingeKind::axis ? ForestTurn::axis : ForestTurn::ball;
}

detail::ForestHinge hinge_of(const ForestBody& body) {
  const Vector3d r =
      body.parent < 0 ? Vector3d(Vector3d::Zero()) : body.hinge_from_com;
  const Vector3d arm = r - body.com;
  const Matrix3d inertia =
      body.inertia + body.mass * (arm.squaredNorm() * Matrix3d::Identity() -
                                  arm * arm.transpose());
  return {.parent = body.parent,
          .turn = turn_of(body),
          .mass = body.mass,
          .r = vec3(r),
          .mass_r = vec3(Vector3d(body.mass * arm)),
          .from_parent = vec3(body.hinge_from_parent_com),
          .axis = vec3(body.axis),
          .inertia = mat3(inertia)};
}

Pivoted pivoted(const ForestPart& p) {
  Matrix6 m;
  m << matrix(p.a), matrix(p.b), matrix(p.c), matrix(p.d);
  return Pivoted(m);
}

CarrierSolver<double> symmetric(const ForestPart& p) {
  const auto half = [](const PaddedMatrix& m) {
    return Sym3<double>{m.x.x, m.y.y, m.z.z, m.y.x, m.z.x, m.z.y};
  };
  const PaddedMatrix& b = p.b;
  return CarrierSolver<double>(CarrierMatrix<double>{
      half(p.a),
      {{b.x.x, b.y.x, b.z.x}, {b.x.y, b.y.y, b.z.y}, {b.x.z, b.y.z, b.z.z}},
      half(p.d)});
}

void accelerate(const CarrierSolver<double>& solver, ForestPart& root) {
  const Vec3<double> none{0, 0, 0};
  const auto [linear, angular] =
      solver.solve({none - vec3(root.force), none - vec3(root.moment)});
  root.linear = padded(linear);
  root.angular = padded(angular);
}

void accelerate(const Pivoted& solver, ForestPart& root) {
  Vector6 load;
  load << vector(root.force), vector(root.moment);
  const Vector6 acceleration = -solver.solve(load);
  root.linear = padded(vec3(Vector3d(acceleration.head<3>())));
  root.angular = padded(vec3(Vector3d(acceleration.tail<3>())));
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

Forest::Forest(std::vector<ForestBody> bodies, contact::InstructionSet set)
    : bodies_(std::move(bodies)), kernel_(detail::forest_kernel(set)) {
  std::vector<int> parents;
  for (const ForestBody& body : bodies_) parents.push_back(body.parent);
  order_ = parents_first(parents);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    check(bodies_, i);
    bodies_[i].axis.normalize();
    hinges_.push_back(hinge_of(bodies_[i]));
  }
}

void Forest::set_hinge(int body, int parent, bool held) {
  bodies_[body].parent = parent;
  bodies_[body].held = held;
  hinges_[body] = hinge_of(bodies_[body]);
}

void Forest::set_mass(int body, double mass, const Vector3d& com,
                      const Matrix3d& inertia) {
  bodies_[body].mass = mass;
  bodies_[body].com = com;
  bodies_[body].inertia = inertia;
  hinges_[body] = hinge_of(bodies_[body]);
}

void Forest::prepare(const std::vector<ForestState>& state, bool sloped,
                     ForestWork& work) const {
  work.parts_.resize(bodies_.size());
  work.roots_.resize(bodies_.size());
  work.sloped_ = sloped;
  kernel_.prepare(of(work), state.data(), sloped);
  for (const int i : order_) {
    if (bodies_[i].parent >= 0 || bodies_[i].fixed) continue;
    if (sloped) {
      work.roots_[i] = pivoted(work.parts_[i]);
    } else {
      work.roots_[i] = symmetric(work.parts_[i]);
    }
  }
}

void Forest::respond(const std::vector<ForestState>& state,
                     ForestWork& work) const {
  kernel_.gather_loads(of(work), state.data(), work.sloped_);
  for (const int i : order_) {
    if (bodies_[i].parent >= 0) continue;
    ForestPart& root = work.parts_[i];
    if (bodies_[i].fixed) {
      root.linear = padded(state[i].acceleration);
      root.angular = padded(state[i].angular_acceleration);
    } else {
      std::visit([&](const auto& solver) { accelerate(solver, root); },
                 work.roots_[i]);
    }
  }
  kernel_.resolve(of(work), work.sloped_);
}

std::vector<ForestMotion> Forest::solve(const std::vector<ForestState>& state,
                                        const Vector3d& gravity) const {
  if (state.size() != bodies_.size()) {
    throw contact::Error(
        fmt::format("{} states for {} bodies", state.size(), bodies_.size()));
  }
  std::vector<ForestState> falling = state;
  for (const int i : order_) {
    if (bodies_[i].parent >= 0) continue;
    falling[i].acceleration -=
        transposed_times(state[i].rotation, vec3(gravity));
  }
  ForestWork work;
  prepare(falling, true, work);
  respond(falling, work);
  std::vector<Vec3<double>> down(bodies_.size());
  std::vector<ForestMotion> to(bodies_.size());
  for (const int i : order_) {
    const int parent = bodies_[i].parent;
    down[i] = transposed_times(state[i].rotation,
                               parent < 0 ? vec3(gravity) : down[parent]);
    to[i] = work.motion(i);
    to[i].acceleration += vec3(down[i]);
  }
  return to;
}

ForestMotion ForestWork::motion(int body) const {
  const ForestPart& p = parts_[body];
  // The centre of mass is at -r from the origin.
  const Vector3d r = vector(p.r);
  const Vector3d w = vector(p.w);
  const Vector3d linear =
      vector(p.linear) - vector(p.angular).cross(r) - w.cross(w.cross(r));
  const auto in_own = [&](const Padded& v) { return vec3(own(body, v)); };
  return {in_own(padded(vec3(linear))), in_own(p.angular), in_own(p.turn),
          in_own(p.reaction), in_own(p.reaction_moment)};
}

}  // namespace multibody
