// One impulse in several hinges at once, in random trees, by Jourdain's
// principle: for every velocity that the hinges allow, the jumps of all
// momenta do the virtual work of the impulses, and no other.
#include "multibody/motion/impulse.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "multibody/motion/motion_start.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody::test::impulse_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Tree {
 public:
  explicit Tree(unsigned seed) : random_(seed) {
    std::vector<Body> bodies;
    MotionStart start;
    for (int i = 0; i < count; ++i) {
      Body body;
      body.kind = random_() % 3 == 0 ? HingeKind::ball : HingeKind::axis;
      body.mass = 1 + std::abs(number());
      const Matrix3d a = matrix();
      body.inertia = a * a.transpose() + Matrix3d::Identity();
      body.hinge_from_com = vector();
      body.hinge_from_carrier_com = vector();
      body.parent = static_cast<int>(random_() % (i + 1)) - 1;
      body.hinge_to_body = turn();
      body.hinge_to_carrier_zero = turn();
      bodies.push_back(body);
      BodyStart& at = start.bodies.emplace_back();
      at.angle = 3 * number();
      at.angle_rate = number();
      at.rotation = turn();
      at.relative_angular_velocity = vector();
    }
    start.carrier.position = vector();
    start.carrier.velocity = vector();
    start.carrier.rotation = turn();
    start.carrier.angular_velocity = vector();
    const Matrix3d a = matrix();
    carrier_ = {3, a * a.transpose() + Matrix3d::Identity()};
    equations_.emplace(System(carrier_, bodies), std::vector<HingeFriction>(),
                       nullptr, MotionOptions{});
    state_ = start_state(*equations_, start);
  }

  Equations& equations() { return *equations_; }
  const std::vector<double>& state() const { return state_; }
  Vector3d vector() { return {number(), number(), number()}; }

  std::vector<BodyMotion> motions(const std::vector<double>& state) const {
    std::vector<BodyMotion> all(count + 1);
    set_bodies(equations_->system, equations_->coupled.layout(),
               equations_->modes(), state.data(), all);
    return all;
  }
  // Their places, with one of the velocities alone: of the carrier (body -1),
  // or of a hinge.
  std::vector<BodyMotion> moved(int body, int axis, bool turns) const {
    std::vector<double> state = state_;
    for (int k = 0; k < 3; ++k) {
      state[StateLayout::velocity + k] = 0;
      state[StateLayout::angular_velocity + k] = 0;
    }
    for (int i = 0; i < count; ++i) {
      set_relative_rate(equations_->system.links()[i],
                        &state[equations_->offset(i)], Vector3d::Zero());
    }
    if (body < 0) {
      state[(turns ? StateLayout::angular_velocity : StateLayout::velocity) +
            axis] = 1;
    } else {
      set_relative_rate(equations_->system.links()[body],
                        &state[equations_->offset(body)], Vector3d::Unit(axis));
    }
    return motions(state);
  }

  // Inertia of body 0, the carrier, or body 1 +, inertial axes.
  Matrix3d inertia(int body, const BodyMotion& at) const {
    if (body == 0) {
      return at.rotation * carrier_.inertia * at.rotation.transpose();
    }
    const Link& link = equations_->system.links()[body - 1];
    const Matrix3d axes = at.rotation * link.axes;
    return axes * link.inertia * axes.transpose();
  }
  double mass(int body) const {
    return body == 0 ? carrier_.mass
                     : equations_->system.links()[body - 1].mass;
  }

  static constexpr int count = 7;

 private:
  double number() { return std::normal_distribution<>()(random_); }
  Matrix3d matrix() {
    Matrix3d m;
    m << vector(), vector(), vector();
    return m;
  }
  Matrix3d turn() {
    return Eigen::AngleAxisd(number(), vector().normalized())
        .toRotationMatrix();
  }

  std::mt19937 random_;
  Carrier carrier_;
  std::optional<Equations> equations_;
  std::vector<double> state_;
};

TEST(Impulse, DoesVirtualWorkInItsHingesAlone) {
  double worst = 0, worst_energy = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Tree tree(seed);
    Equations& equations = tree.equations();
    // Four targets; the other three hinges turn freely.
    std::vector<Impulse::Target> targets;
    for (int i = 0; i < Tree::count; i += 2) {
      const Vector3d rate = tree.vector();
      targets.push_back(
          {i, equations.is_axis(i) ? Vector3d(0, 0, rate.z()) : rate});
    }
    std::vector<double> after = tree.state();
    const auto jumps = Impulse(equations).apply(0, targets, true, after);
    const auto a = tree.motions(tree.state()), b = tree.motions(after);
    double before_energy = 0, loss = 0, size = 0;
    std::vector<Vector3d> linear, angular;
    for (int i = 0; i <= Tree::count; ++i) {
      const Matrix3d j = tree.inertia(i, a[i]);
      linear.push_back(tree.mass(i) * (b[i].velocity - a[i].velocity));
      angular.push_back(j * (b[i].angular_velocity - a[i].angular_velocity));
      size += linear.back().norm() + angular.back().norm();
      const auto energy = [&](const BodyMotion& m) {
        return (tree.mass(i) * m.velocity.squaredNorm() +
                m.angular_velocity.dot(j * m.angular_velocity)) /
               2;
      };
      before_energy += energy(a[i]);
      loss += energy(a[i]) - energy(b[i]);
    }
    const auto work = [&](const std::vector<BodyMotion>& along) {
      double sum = 0;
      for (int i = 0; i <= Tree::count; ++i) {
        sum += linear[i].dot(along[i].velocity) +
               angular[i].dot(along[i].angular_velocity);
      }
      return sum;
    };
    const auto expect = [&](double is, double should) {
      worst = std::max(worst, std::abs(is - should) / size);
    };
    for (int k = 0; k < 3; ++k) {
      expect(work(tree.moved(-1, k, false)), 0);
      expect(work(tree.moved(-1, k, true)), 0);
    }
    double told = 0;
    for (int i = 0; i < Tree::count; ++i) {
      const bool is_target = i % 2 == 0;
      for (int k = equations.is_axis(i) ? 2 : 0; k < 3; ++k) {
        expect(work(tree.moved(i, k, true)),
               is_target ? jumps[i / 2].impulse[k] : 0);
      }
      if (!is_target) continue;
      EXPECT_EQ(equations.rate_of(i, after.data()), targets[i / 2].rate);
      told += jumps[i / 2].loss;
    }
    worst_energy = std::max(
        worst_energy, std::abs(loss - told) / (before_energy + std::abs(loss)));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_energy, 1e-12);
}

}  // namespace
}  // namespace multibody::test::impulse_test
