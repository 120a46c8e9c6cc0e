// Chains of three pins, of balls, and of groups on axes with friction so strong
// that none, one or several sets of moments fit the reactions they cause: what
// the library finds, and calls the only one, beside Newton's method from many
// starts over a dense matrix of the balance about every hinge.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "multibody_support/coupled.hpp"
#include "multibody_support/prepared.hpp"

namespace multibody::test::search_test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

enum class Kind { pins, balls, groups };

// A rod along its x from its hinge, on the rod before. Body axes.
struct Rod {
  double mass, length, com;
  Vector3d inertia, force, rate;  // rate: relative; axis: along z
  Matrix3d to_parent_zero;        // axis: at angle 0
  double angle;
};

class Random {
 public:
  explicit Random(int seed) : engine_(seed) {}
  double within(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) / 0x1p53;
  }
  Vector3d vector() { return {within(-1, 1), within(-1, 1), within(-1, 1)}; }

 private:
  std::mt19937_64 engine_;
};

contact::Joint joint_of(contact::JointKind kind, double radius,
                        double coefficient, const contact::ElasticPair& pair) {
  const double clearance = 1e-3 * radius;
  return contact::Joint(
      {kind == contact::JointKind::pin
           ? contact::JointGeometry::pin(radius, clearance, 0.1)
           : contact::JointGeometry::ball(radius, clearance),
       pair, contact::FrictionLaw(coefficient),
       contact::make_half_angle_law("tanh", kind, pair),
       std::make_unique<contact::CosinePressure>(kind)});
}

// f0 0.5 to 2, rho/L 0.1 to 1, steel to rubber.
struct Chain {
  Chain(Kind of, int size, int seed) : kind(of) {
    Random random(seed);
    const contact::Material material(std::pow(10, random.within(3, 11)), 0.3);
    const contact::ElasticPair pair(material, material);
    for (int i = 0; i < size; ++i) {
      Rod rod;
      rod.mass = std::pow(10, random.within(-1, 1));
      rod.length = random.within(0.2, 1);
      rod.com = rod.length * random.within(0.2, 1);
      rod.inertia = rod.mass * rod.length * rod.length *
                    random.within(0.01, 0.2) * Vector3d(1, 1.2, 1.1);
      rod.force = 20 * rod.mass * random.vector();
      rod.rate = 2 * random.vector();
      if (!is_ball()) rod.rate.head<2>().setZero();
      rod.to_parent_zero =
          Eigen::AngleAxisd(random.within(0, 3), random.vector().normalized())
              .toRotationMatrix();
      rod.angle = is_ball() ? 0 : random.within(-3, 3);
      rods.push_back(rod);
      const double radius = rod.length * std::pow(10, random.within(-1, 0));
      friction.push_back(
          friction_of(radius, random.within(0.5, 2), rod.length, pair));
    }
  }

  bool is_ball() const { return kind == Kind::balls; }
  HingeFriction friction_of(double radius, double coefficient, double length,
                            const contact::ElasticPair& pair) const {
    using enum contact::JointKind;
    if (kind == Kind::pins) {
      return JointFriction{joint_of(pin, radius, coefficient, pair)};
    }
    if (is_ball()) {
      return JointFriction{joint_of(ball, radius, coefficient, pair)};
    }
    std::vector<contact::JointGroup::Member> joints;
    joints.push_back({joint_of(ball, radius, coefficient, pair), -length / 2});
    joints.push_back({joint_of(pin, radius, coefficient, pair), length / 2});
    return GroupFriction{contact::JointGroup(std::move(joints))};
  }

  Kind kind;
  std::vector<Rod> rods;
  std::vector<HingeFriction> friction;
};

// Inertial axes; a hinge has 1 or 3 numbers, of moments and accelerations.
class Dense {
 public:
  explicit Dense(const Chain& chain)
      : chain_(chain), n_(static_cast<int>(chain.rods.size())) {
    Matrix3d before = Matrix3d::Identity();
    Vector3d turned = Vector3d::Zero();
    for (const Rod& rod : chain.rods) {
      const Matrix3d spin =
          Eigen::AngleAxisd(rod.angle, Vector3d::UnitZ()).toRotationMatrix();
      before = before * rod.to_parent_zero * spin;
      axes_.push_back(before);
      relative_.emplace_back(before * rod.rate);
      turned += relative_.back();
      rates_.push_back(turned);
    }
    const int size = freedoms() * n_;
    at_rest_ = balance(VectorXd::Zero(size));
    MatrixXd moments(size, size);
    by_turn_.resize(6 * n_, size);
    for (int k = 0; k < size; ++k) {
      by_turn_.col(k) = balance(VectorXd::Unit(size, k)) - at_rest_;
      moments.col(k) = turning(by_turn_.col(k));
    }
    inverse_ = moments.inverse();
  }

  int freedoms() const { return chain_.is_ball() ? 3 : 1; }
  int size() const { return freedoms() * n_; }
  // Directions in which a hinge turns, columns.
  MatrixXd turns(int i) const { return axes_[i].rightCols(freedoms()); }
  const Matrix3d& axes(int i) const { return axes_[i]; }
  const Vector3d& relative(int i) const { return relative_[i]; }

  // Friction under the reactions that such friction causes, less the latter.
  VectorXd mismatch(const VectorXd& x) const {
    const VectorXd loads =
        at_rest_ + by_turn_ * (inverse_ * (x - turning(at_rest_)));
    VectorXd f(size());
    for (int i = 0; i < n_; ++i) {
      f.segment(freedoms() * i, freedoms()) =
          turns(i).transpose() *
          moment(i, loads.segment<3>(6 * i), loads.segment<3>(6 * i + 3));
    }
    return f - x;
  }

  bool solve_from(VectorXd& x) const {
    constexpr double longest = 0.3;
    for (int step = 0; step < 60; ++step) {
      const VectorXd f = mismatch(x);
      if (!f.allFinite()) return false;
      if (f.norm() <= 1e-11 * x.norm()) return true;
      MatrixXd slopes(size(), size());
      const double h = 1e-6 * x.norm();
      for (int k = 0; k < size(); ++k) {
        slopes.col(k) = (mismatch(x + h * VectorXd::Unit(size(), k)) - f) / h;
      }
      VectorXd by = -slopes.partialPivLu().solve(f);
      x += std::min(1.0, longest * x.norm() / by.norm()) * by;
    }
    return false;
  }

  // From moments of many sizes against the sliding.
  std::vector<VectorXd> all(int starts) const {
    std::vector<VectorXd> found;
    Random random(1);
    const double scale = mismatch(VectorXd::Constant(size(), 1e-9)).norm();
    for (int start = 0; start < starts; ++start) {
      VectorXd x(size());
      for (int i = 0; i < n_; ++i) {
        x.segment(freedoms() * i, freedoms()) =
            -scale * std::pow(10, random.within(-1, 4)) *
            (turns(i).transpose() * relative_[i]).normalized();
      }
      if (!solve_from(x)) continue;
      if (nearest(found, x) > 1e-6) found.push_back(x);
    }
    return found;
  }

  static double nearest(const std::vector<VectorXd>& all, const VectorXd& x) {
    double least = 1;
    for (const VectorXd& y : all) {
      least = std::min(least, (x - y).norm() / x.norm());
    }
    return least;
  }

 private:
  // Forces and moments that the hinges have to give, about their centres.
  VectorXd balance(const VectorXd& accelerations) const {
    VectorXd loads(6 * n_);
    std::vector<Vector3d> arms, forces, moments;
    Vector3d turn = Vector3d::Zero(), place = Vector3d::Zero();
    for (int i = 0; i < n_; ++i) {
      const Rod& rod = chain_.rods[i];
      const Vector3d w = rates_[i];
      turn += (w - relative_[i]).cross(relative_[i]) +
              turns(i) * accelerations.segment(freedoms() * i, freedoms());
      const auto moved = [&](const Vector3d& by) {
        return Vector3d(place + turn.cross(by) + w.cross(w.cross(by)));
      };
      const Vector3d com = rod.com * axes_[i].col(0);
      const Matrix3d inertia =
          axes_[i] * rod.inertia.asDiagonal() * axes_[i].transpose();
      forces.emplace_back(rod.mass * moved(com) - axes_[i] * rod.force);
      moments.emplace_back(inertia * turn + w.cross(inertia * w) +
                           com.cross(forces[i]));
      arms.emplace_back(rod.length * axes_[i].col(0));
      place = moved(arms[i]);
    }
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (int i = n_ - 1; i >= 0; --i) {
      moment += arms[i].cross(force) + moments[i];
      force += forces[i];
      loads.segment<6>(6 * i) << force, moment;
    }
    return loads;
  }

  VectorXd turning(const VectorXd& loads) const {
    VectorXd x(size());
    for (int i = 0; i < n_; ++i) {
      x.segment(freedoms() * i, freedoms()) =
          turns(i).transpose() * loads.segment<3>(6 * i + 3);
    }
    return x;
  }

  Vector3d moment(int i, const Vector3d& force, const Vector3d& held) const {
    const Vector3d axis = axes_[i].col(2);
    const double rate = relative_[i].dot(axis);
    if (const auto* of = std::get_if<GroupFriction>(&chain_.friction[i])) {
      contact::JointGroup::Solution s = of->group.make_solution();
      of->group.solve({force, held, axis, rate}, s);
      if (s.status != contact::Status::ok && !(s.residual < 1e-11)) {
        return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
      }
      return s.friction_moment * axis;
    }
    const contact::Joint& joint =
        std::get<JointFriction>(chain_.friction[i]).joint;
    if (chain_.is_ball()) {
      return joint.solve({.reaction = force, .angular_velocity = relative_[i]})
          .friction_moment;
    }
    return joint.solve({force - force.dot(axis) * axis, rate * axis, axis})
        .friction_moment;
  }

  const Chain& chain_;
  int n_;
  std::vector<Matrix3d> axes_;
  std::vector<Vector3d> relative_, rates_;
  VectorXd at_rest_;
  MatrixXd by_turn_, inverse_;
};

Instant instant_of(const Chain& chain) {
  Instant all;
  all.carrier.fixed = true;
  for (const Rod& rod : chain.rods) {
    BodyInstant body;
    body.body = {chain.is_ball() ? HingeKind::ball : HingeKind::axis, rod.mass,
                 Matrix3d(rod.inertia.asDiagonal())};
    body.body.hinge_from_com.x() = -rod.com;
    body.body.parent = static_cast<int>(all.bodies.size()) - 1;
    if (body.body.parent >= 0) {
      const Rod& below = chain.rods[body.body.parent];
      body.body.hinge_from_carrier_com.x() = below.length - below.com;
    }
    body.body.hinge_to_carrier_zero = body.rotation = rod.to_parent_zero;
    body.relative_angular_velocity = rod.rate;
    body.angle = rod.angle;
    body.angle_rate = rod.rate.z();
    body.active_force = rod.force;
    all.bodies.push_back(body);
  }
  return all;
}

// What the library finds, as Dense has it.
struct Found {
  std::vector<VectorXd> all;
  bool proven = false;
  /// The joints of a group share no forces that fit: reported as that.
  bool failed = false;
};
Found ours(const Chain& chain, const Dense& dense) {
  const Prepared prepared = prepare(instant_of(chain));
  Coupled coupled(prepared.system, chain.friction);
  const int n = coupled.size();
  for (int i = 0; i < n && !chain.is_ball(); ++i) {
    const double sign = chain.rods[i].rate.z() < 0 ? -1 : 1;
    coupled.set_direction(i, sign * Vector3d::UnitZ());
  }
  coupled.prescribe_carrier({});
  const CoupledReport& report =
      coupled.evaluate(prepared.state, prepared.forces);
  std::vector<CoupledSolution> solutions = coupled.solutions();
  if (report.status == CoupledStatus::ok) {
    solutions = {{}};
    for (int i = 0; i < n; ++i) {
      solutions[0].moments.push_back(coupled.friction_moment(i));
    }
  }
  Found found{{},
              report.status == CoupledStatus::ok && !report.others_possible,
              report.status == CoupledStatus::no_contact};
  const int freedoms = dense.freedoms();
  for (const CoupledSolution& s : solutions) {
    VectorXd& x = found.all.emplace_back(dense.size());
    for (int i = 0; i < n; ++i) {
      const Matrix3d to_body = chain.is_ball() ? prepared.system.links()[i].axes
                                               : Matrix3d(Matrix3d::Identity());
      x.segment(freedoms * i, freedoms) =
          (to_body * s.moments[i]).tail(freedoms);
    }
  }
  return found;
}

struct Counts {
  int none = 0, one = 0, several = 0, proven = 0, failed = 0;
};
Counts compare(Kind kind, int size, int seeds, int starts) {
  Counts counts;
  for (int seed = 0; seed < seeds; ++seed) {
    const Chain chain(kind, size, seed);
    const Dense dense(chain);
    const std::vector<VectorXd> all = dense.all(starts);
    const Found found = ours(chain, dense);
    if (found.failed) {
      ++counts.failed;
      continue;
    }
    // The library's equations hold to 1e-10; where two solutions are near each
    // other that lets them move further.
    for (const VectorXd& x : found.all) {
      EXPECT_LT(dense.mismatch(x).norm(), 1e-7 * x.norm()) << seed;
    }
    for (const VectorXd& x : all) {
      EXPECT_LT(Dense::nearest(found.all, x), 1e-6) << seed;
    }
    EXPECT_TRUE(!found.proven || all.size() <= 1) << seed;
    counts.proven += found.proven;
    const std::size_t number = found.all.size();
    ++(number == 0 ? counts.none : number == 1 ? counts.one : counts.several);
  }
  std::printf("none %d, one %d (%d proven), several %d, failed %d\n",
              counts.none, counts.one, counts.proven, counts.several,
              counts.failed);
  return counts;
}

// All outcomes, and enough that are proven to be the only ones.
TEST(Search, ThreePins) {
  const Counts counts = compare(Kind::pins, 3, 60, 40);
  EXPECT_GT(counts.none, 5);
  EXPECT_GT(counts.several, 1);
  EXPECT_GT(counts.proven, 0.4 * counts.one);
  EXPECT_EQ(counts.failed, 0);
}
TEST(Search, TwoBalls) {
  const Counts counts = compare(Kind::balls, 2, 60, 40);
  EXPECT_GT(counts.none, 1);
  EXPECT_GT(counts.several, 1);
  EXPECT_GT(counts.proven, 0.2 * counts.one);
  EXPECT_EQ(counts.failed, 0);
}
TEST(Search, TwoGroups) {
  const Counts counts = compare(Kind::groups, 2, 20, 8);
  EXPECT_GT(counts.proven, 0.3 * counts.one);
  EXPECT_LT(counts.failed, 10);
}

}  // namespace
}  // namespace multibody::test::search_test
