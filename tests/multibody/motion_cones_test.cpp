// Rigid stops of ball joints: impacts against closed forms and dense solutions,
// rest on the cone against an equation of motion of its own, Newton and Euler
// for all bodies, friction, and saved states.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "multibody_support/friction_parts.hpp"
#include "multibody_support/momentum.hpp"

namespace multibody::test::motion_cones_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

// A moment on body 0, inertial axes, and the opposite on the carrier.
class Moment : public ForceModel {
 public:
  explicit Moment(std::function<Vector3d(double)> moment)
      : moment_(std::move(moment)) {}
  void add_forces(double time, std::span<const BodyMotion>,
                  std::span<BodyForce> forces) const override {
    forces[1].moment += moment_(time);
    forces[0].moment -= moment_(time);
  }

 private:
  std::function<Vector3d(double)> moment_;
};

MotionOptions accurate() {
  MotionOptions options;
  options.relative_tolerance = 1e-12;
  options.absolute_tolerance = 1e-13;
  return options;
}

Carrier ground() {
  Carrier carrier;
  carrier.fixed = true;
  return carrier;
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double number() { return std::normal_distribution<>()(random_); }
  Vector3d vector() { return {number(), number(), number()}; }
  Vector3d unit() { return vector().normalized(); }
  Matrix3d turn() { return AngleAxisd(number(), unit()).toRotationMatrix(); }
  Matrix3d inertia() {
    Matrix3d a;
    a << vector(), vector(), vector();
    return a * a.transpose() + Matrix3d::Identity();
  }

 private:
  std::mt19937 random_;
};

double angle_of(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// psi of a stop, from the bodies.
double psi(const MotionSample& sample, const HingeStop& stop, int parent = 0) {
  return angle_of(sample.body(stop.body).rotation * stop.body_direction,
                  sample.motions()[parent].rotation * stop.parent_direction);
}

// J = 15 kg m^2 on the ground, 30 deg from a direction, driven by 2 N m about
// the normal of both to a stop at 120 deg, e = 0.4: an axis. Under a constant
// moment the rate at the first impact is sqrt(pi a), a = 2/15 rad/s^2, and
// flights last 2 e^n w/a.
TEST(ConeStops, AboutOneAxisTheyAreStopsOfAxes) {
  const Vector3d axis = Vector3d(1, -2, 0.5).normalized();
  const Vector3d down = axis.unitOrthogonal();
  const Matrix3d zero =
      AngleAxisd(1, Vector3d(2, 1, 3).normalized()).toRotationMatrix();
  const double e = 0.4, a = 2.0 / 15;
  Body body{HingeKind::ball, 1, 15 * Matrix3d::Identity()};
  MotionStart start;
  start.bodies.emplace_back().rotation =
      AngleAxisd(pi / 6, axis).toRotationMatrix() * zero;
  MotionOptions options = accurate();
  options.stops = {{0, 2 * pi / 3, -1, e, zero.transpose() * down, down}};
  Motion motion(
      System(ground(), {body}), {},
      std::make_shared<Moment>([&](double) { return Vector3d(2 * axis); }),
      start, options);
  ASSERT_EQ(motion.advance_to(13), Stop::time);
  const double times[] = {4.854064781389, 8.737316606501, 10.290617336545};
  const double w = std::sqrt(pi * a);
  EXPECT_NEAR(w * 180 / pi, 37.0823233942, 1e-9);
  EXPECT_NEAR(15 * (1 + e) * w, 13.5913813879, 1e-9);
  ASSERT_GT(motion.impacts().size(), 8u);
  for (int n = 0; n < 3; ++n) {
    const HingeImpact& impact = motion.impacts()[n];
    EXPECT_NEAR(impact.time, times[n], 1e-10);
    EXPECT_NEAR(impact.rate, w * std::pow(e, n), 1e-9);
    EXPECT_NEAR(impact.impulse, 15 * (1 + e) * w * std::pow(e, n), 1e-9);
    EXPECT_NEAR(impact.loss, pi * (1 - e * e) * std::pow(e, 2 * n), 1e-9);
  }
  ASSERT_FALSE(motion.changes().empty());
  EXPECT_TRUE(motion.changes().back().on_stop);
  EXPECT_NEAR(motion.changes().back().time, 11.326151156575, 1e-8);
  EXPECT_NEAR(motion.sample().energy().impacts, pi, 1e-9);
  const HingeSample hinge = motion.sample().hinge(0);
  EXPECT_NEAR(hinge.stop_moment, 2, 1e-11);
  EXPECT_EQ(hinge.mode, HingeMode::sliding);
  EXPECT_TRUE(motion.sample().rests_on_stop(0));
  // A couple about the axis, without a force on the hinge.
  EXPECT_LT(
      (motion.sample().body(0).rotation * hinge.reaction_moment + 2 * axis)
          .norm(),
      1e-10);
  EXPECT_LT(hinge.reaction_force.norm(), 1e-14);
}

// Jumps of the velocities of a free carrier with two bodies on ball joints, of
// which the first hits its stop: impulses in the hinges and about the normal,
// from momenta and constraints of all bodies at once.
struct DenseImpact {
  std::vector<Vector3d> linear, angular;
  double impulse = 0;
};
DenseImpact dense_impact(const std::vector<BodyMotion>& at,
                         const Carrier& carrier,
                         const std::vector<Body>& bodies,
                         const Vector3d& normal, double jump) {
  const int count = 1 + static_cast<int>(bodies.size());
  const int size = 6 * count + 3 * (count - 1) + 1;
  const int last = size - 1;
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  const auto cross = [](const Vector3d& v) {
    Matrix3d c;
    c << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return c;
  };
  for (int i = 0; i < count; ++i) {
    const Matrix3d& r = at[i].rotation;
    const double mass = i == 0 ? carrier.mass : bodies[i - 1].mass;
    const Matrix3d& own = i == 0 ? carrier.inertia : bodies[i - 1].inertia;
    m.block<3, 3>(6 * i, 6 * i) = mass * Matrix3d::Identity();
    m.block<3, 3>(6 * i + 3, 6 * i + 3) = r * own * r.transpose();
    if (i == 0) continue;
    const int p = 6 * count + 3 * (i - 1);
    const Vector3d arm = r * bodies[i - 1].hinge_from_com;
    const Vector3d arm0 = at[0].rotation * bodies[i - 1].hinge_from_carrier_com;
    // Momenta: the impulse acts on the body, its opposite on the carrier.
    m.block<3, 3>(6 * i, p) = -Matrix3d::Identity();
    m.block<3, 3>(6 * i + 3, p) = -cross(arm);
    m.block<3, 3>(0, p) = Matrix3d::Identity();
    m.block<3, 3>(3, p) = cross(arm0);
    // The hinge's points keep together.
    m.block<3, 3>(p, 6 * i) = Matrix3d::Identity();
    m.block<3, 3>(p, 6 * i + 3) = -cross(arm);
    m.block<3, 3>(p, 0) = -Matrix3d::Identity();
    m.block<3, 3>(p, 3) = cross(arm0);
  }
  m.block<3, 1>(9, last) = -normal;
  m.block<3, 1>(3, last) = normal;
  m.block<1, 3>(last, 9) = normal.transpose();
  m.block<1, 3>(last, 3) = -normal.transpose();
  right[last] = jump;
  const Eigen::VectorXd x = m.fullPivLu().solve(right);
  DenseImpact result;
  for (int i = 0; i < count; ++i) {
    result.linear.emplace_back(x.segment<3>(6 * i));
    result.angular.emplace_back(x.segment<3>(6 * i + 3));
  }
  result.impulse = x[last];
  return result;
}

double kinetic(const std::vector<BodyMotion>& at, const Carrier& carrier,
               const std::vector<Body>& bodies) {
  double sum = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vector3d w = at[i].rotation.transpose() * at[i].angular_velocity;
    const double mass = i == 0 ? carrier.mass : bodies[i - 1].mass;
    const Matrix3d& own = i == 0 ? carrier.inertia : bodies[i - 1].inertia;
    sum += (mass * at[i].velocity.squaredNorm() + w.dot(own * w)) / 2;
  }
  return sum;
}

TEST(ConeStops, ImpactsOfGeneralBodiesAreDenseSolutions) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const Carrier carrier{3, random.inertia()};
    std::vector<Body> bodies;
    MotionStart start;
    for (int i = 0; i < 2; ++i) {
      bodies.push_back({HingeKind::ball, 1. + i, random.inertia(),
                        random.vector(), random.vector()});
      start.bodies.emplace_back().rotation = random.turn();
      start.bodies.back().relative_angular_velocity = random.vector();
    }
    start.carrier.angular_velocity = random.vector();
    start.carrier.velocity = random.vector();
    // 0.2 rad away, towards the stop at about 2 rad/s.
    const Vector3d b = random.unit(), p = random.unit();
    const Matrix3d c = start.bodies[0].rotation;
    const Vector3d cb = c * b;
    const Vector3d n = p.cross(cb).normalized();
    const int side = seed % 2 ? 1 : -1;
    const double angle = angle_of(p, cb) - 0.2 * side;
    if (!(0.1 < angle && angle < pi - 0.1)) continue;
    start.bodies[0].relative_angular_velocity +=
        c.transpose() * (-2 * side * n);
    const double e = 0.3;
    MotionOptions options = accurate();
    options.stops = {{0, angle, side, e, b, p}};
    Motion motion(System(carrier, bodies), {}, nullptr, start, options);
    std::vector<std::pair<double, std::vector<BodyMotion>>> looks;
    motion.watch_steps([&](const MotionSample& sample) {
      looks.push_back(
          {sample.time(), {sample.motions().begin(), sample.motions().end()}});
    });
    ASSERT_EQ(motion.advance_to(1), Stop::time);
    if (motion.impacts().empty()) continue;
    const HingeImpact& impact = motion.impacts()[0];
    const auto found = std::ranges::find_if(
        looks, [&](const auto& look) { return look.first == impact.time; });
    const auto& before = found->second;
    const auto& after = std::next(found)->second;
    ASSERT_EQ(std::next(found)->first, impact.time);
    const Vector3d normal =
        (before[0].rotation * p).cross(before[1].rotation * b).normalized();
    const double u =
        normal.dot(before[1].angular_velocity - before[0].angular_velocity);
    EXPECT_NEAR(impact.rate, u, 1e-12);
    const DenseImpact dense =
        dense_impact(before, carrier, bodies, normal, -(1 + e) * u);
    EXPECT_NEAR(impact.impulse, std::abs(dense.impulse),
                1e-11 * impact.impulse);
    for (int i = 0; i < 3; ++i) {
      const Vector3d v = before[i].velocity + dense.linear[i];
      const Vector3d w = before[i].angular_velocity + dense.angular[i];
      EXPECT_LT((after[i].velocity - v).norm(), 1e-12 * (1 + v.norm()));
      EXPECT_LT((after[i].angular_velocity - w).norm(), 1e-12 * (1 + w.norm()));
    }
    EXPECT_NEAR(
        normal.dot(after[1].angular_velocity - after[0].angular_velocity),
        -e * u, 1e-12);
    const double energy = kinetic(before, carrier, bodies);
    EXPECT_NEAR(energy - kinetic(after, carrier, bodies), impact.loss,
                1e-12 * energy);
    EXPECT_NEAR(impact.loss,
                (1 - e) * u * std::abs(dense.impulse) * (u > 0 ? 0.5 : -0.5),
                1e-11 * energy);
    EXPECT_NEAR(motion.sample().energy().balance(), energy, 1e-10 * energy);
  }
}

// A pendulum with a symmetric bob whose arm turns along a cone about p, without
// spin: with the azimuth f, J sin^2 psi f'' = m l g . (p x b), and the stop
// presses with J sin psi cos psi f'^2 + m l (cos psi g . b - g . p)/sin psi
// while the arm is inside.
struct ConePendulum {
  double mass = 3, arm = 0.8, about = 0.3;
  Vector3d gravity{1.5, -2, -9.3};
  Vector3d p = Vector3d(0.6, 0.2, -0.7).normalized();
  double angle = 50 * pi / 180;

  double j() const { return about + mass * arm * arm; }
  Vector3d b(double f) const {
    const Vector3d e = p.unitOrthogonal();
    return std::cos(angle) * p +
           std::sin(angle) * (std::cos(f) * e + std::sin(f) * p.cross(e));
  }
  double acceleration(double f) const {
    const double s = std::sin(angle);
    return mass * arm * gravity.dot(p.cross(b(f))) / (j() * s * s);
  }
  double pressing(double f, double rate) const {
    const double s = std::sin(angle), c = std::cos(angle);
    return j() * s * c * rate * rate +
           mass * arm * (c * gravity.dot(b(f)) - gravity.dot(p)) / s;
  }
  struct State {
    double f, rate;
  };
  State after(State x, double time) const {
    const int steps = 1 + static_cast<int>(time / 5e-4);
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
      const auto [f, w] = x;
      const double a1 = acceleration(f), w2 = w + h / 2 * a1;
      const double a2 = acceleration(f + h / 2 * w), w3 = w + h / 2 * a2;
      const double a3 = acceleration(f + h / 2 * w2), w4 = w + h * a3;
      const double a4 = acceleration(f + h * w3);
      x = {f + h / 6 * (w + 2 * w2 + 2 * w3 + w4),
           w + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
    }
    return x;
  }

  // In body axes the arm is -z.
  Motion motion(const State& begin, const MotionOptions& given) const {
    Body body{HingeKind::ball, mass, about * Matrix3d::Identity(),
              Vector3d(0, 0, arm)};
    body.inertia(2, 2) = 0.1;
    const Vector3d at = b(begin.f);
    MotionStart start;
    BodyStart& of = start.bodies.emplace_back();
    of.rotation = Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), at)
                      .toRotationMatrix();
    of.relative_angular_velocity =
        of.rotation.transpose() * (begin.rate * (p - p.dot(at) * at));
    MotionOptions options = given;
    options.gravity = gravity;
    options.stops = {{0, angle, -1, 0.5, -Vector3d::UnitZ(), p}};
    return {System(ground(), {body}), {}, nullptr, start, options};
  }
};

TEST(ConeStops, APendulumTurnsAlongItsCone) {
  const ConePendulum pendulum;
  const ConePendulum::State begin{1, 6};
  double most = 0;
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    MotionOptions options = accurate();
    options.integrator = integrator;
    Motion motion = pendulum.motion(begin, options);
    motion.watch_steps([&](const MotionSample& sample) {
      most = std::max(
          most, std::abs(angle_of(pendulum.p, -sample.body(0).rotation.col(2)) -
                         pendulum.angle));
    });
    const double accuracy = integrator == Integrator::rk4 ? 1e-8 : 1e-10;
    for (double time = 0.25; time < 3; time += 0.25) {
      ASSERT_EQ(motion.advance_to(time), Stop::time);
      const auto [f, rate] = pendulum.after(begin, time);
      const Vector3d arm = -motion.sample().body(0).rotation.col(2);
      EXPECT_LT((arm - pendulum.b(f)).norm(), accuracy) << time;
      const double pressing = pendulum.pressing(f, rate);
      EXPECT_NEAR(motion.sample().hinge(0).stop_moment, pressing,
                  100 * accuracy);
    }
    EXPECT_TRUE(motion.changes().empty());
  }
  // What a step adds to the angle before it is removed.
  EXPECT_LT(most, 1e-12);
}

TEST(ConeStops, APendulumLeavesItsConeWhereTheStopWouldPull) {
  const ConePendulum pendulum;
  for (const ConePendulum::State& begin :
       {ConePendulum::State{3, 4}, {4, 3}, {5, 4}}) {
    const auto presses = [&](double time) {
      const auto [f, rate] = pendulum.after(begin, time);
      return pendulum.pressing(f, rate) > 0;
    };
    ASSERT_TRUE(presses(0));
    double low = 0, high = 0.05;
    while (presses(high)) high += 0.05;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (presses(middle) ? low : high) = middle;
    }
    Motion motion = pendulum.motion(begin, accurate());
    ASSERT_EQ(motion.advance_to(high + 0.2), Stop::time);
    ASSERT_EQ(motion.changes().size(), 1u);
    EXPECT_NEAR(motion.changes()[0].time, high, 1e-11);
    EXPECT_FALSE(motion.changes()[0].on_stop);
    EXPECT_TRUE(motion.impacts().empty());
    const Vector3d arm = -motion.sample().body(0).rotation.col(2);
    EXPECT_LT(angle_of(arm, pendulum.p), pendulum.angle - 0.02);
    // It comes back, and all of its energy is in the book.
    ASSERT_EQ(motion.advance_to(20), Stop::time);
    EXPECT_GT(motion.impacts().size(), 3u);
    EXPECT_GT(motion.sample().energy().impacts, 1);
    EXPECT_NEAR(motion.sample().energy().balance(),
                pendulum.motion(begin, accurate()).sample().energy().balance(),
                1e-9);
  }
}

// A free carrier with two balls on stops, one of them with friction, and a body
// on an axis that hangs on it: pressed by moments, they turn along their cones.
struct Mechanism {
  Carrier carrier{40, Vector3d(6, 8, 5).asDiagonal()};
  std::vector<Body> bodies;
  std::vector<HingeFriction> friction;
  MotionStart start;
  MotionOptions options = accurate();
  contact::Joint joint = ball_joint(contact::FrictionLaw(0.3));

  Mechanism() {
    Random random(4);
    for (int i = 0; i < 3; ++i) {
      Body& body = bodies.emplace_back(
          Body{i < 2 ? HingeKind::ball : HingeKind::axis, 2.0 + i,
               random.inertia(), 0.4 * random.vector(), 0.5 * random.vector()});
      body.hinge_to_body = random.turn();
      body.hinge_to_carrier_zero = random.turn();
      start.bodies.emplace_back().rotation = random.turn();
    }
    bodies[2].parent = 0;
    start.bodies[2].angle_rate = 0.4;
    start.carrier.angular_velocity = Vector3d(0.1, -0.2, 0.1);
    friction = {JointFriction{joint}, {}, {}};
    for (int i = 0; i < 2; ++i) {
      const Vector3d b = random.unit(), p = random.unit();
      const Matrix3d& c = start.bodies[i].rotation;
      options.stops.push_back({i, angle_of(c * b, p), 1 - 2 * i, 0.3, b, p});
      // Along the cone, and about the body's own direction.
      start.bodies[i].relative_angular_velocity =
          c.transpose() * (0.5 * p) + 0.3 * b;
    }
  }
  HingeStop stop(int i) const { return options.stops[i]; }

  // Presses both on their stops.
  class Press : public ForceModel {
   public:
    explicit Press(const Mechanism& of) : of_(of) {}
    void add_forces(double, std::span<const BodyMotion> at,
                    std::span<BodyForce> forces) const override {
      for (const HingeStop& stop : of_.options.stops) {
        const BodyMotion& body = at[1 + stop.body];
        const Vector3d n = (at[0].rotation * stop.parent_direction)
                               .cross(body.rotation * stop.body_direction)
                               .normalized();
        forces[1 + stop.body].moment -= 4 * stop.side * n;
        forces[0].moment += 4 * stop.side * n;
      }
    }

   private:
    const Mechanism& of_;
  };
  Motion motion() const {
    return {System(carrier, bodies), friction, std::make_shared<Press>(*this),
            start, options};
  }
};

// Second derivative of the angle of two directions, from the bodies'
// accelerations: cos psi = b . p.
double bend(const MotionSample& sample, const HingeStop& stop) {
  const auto derivatives = [&](int place, const Vector3d& direction) {
    const BodyMotion& body = sample.motions()[place];
    const Vector3d v = body.rotation * direction;
    const Vector3d& w = body.angular_velocity;
    const Vector3d rate = w.cross(v);
    return std::array{
        v, rate,
        Vector3d(sample.angular_acceleration(place).cross(v) + w.cross(rate))};
  };
  const auto b = derivatives(1 + stop.body, stop.body_direction);
  const auto p = derivatives(0, stop.parent_direction);
  const double second = b[2].dot(p[0]) + 2 * b[1].dot(p[1]) + b[0].dot(p[2]);
  const double rate = -(b[1].dot(p[0]) + b[0].dot(p[1])) / std::sin(stop.angle);
  return -(second + std::cos(stop.angle) * rate * rate) / std::sin(stop.angle);
}

// Newton and Euler for every body with the reactions, friction and moments of
// stops that the sample has, the friction of the joint under its reaction, and
// the angles of the stops.
TEST(ConeStops, FrictionAndReactionsFitTheMotionOnTheCones) {
  const Mechanism mechanism;
  Motion motion = mechanism.motion();
  const double energy = motion.sample().energy().balance();
  for (double time = 0.1; time < 3; time += 0.1) {
    ASSERT_EQ(motion.advance_to(time), Stop::time);
    const MotionSample& sample = motion.sample();
    std::vector<BodyForce> loads(4);
    Mechanism::Press(mechanism).add_forces(time, sample.motions(), loads);
    for (int i = 0; i < 3; ++i) {
      const Body& body = mechanism.bodies[i];
      const BodyMotion& at = sample.body(i);
      const BodyMotion& parent = sample.motions()[body.parent + 1];
      const HingeSample hinge = sample.hinge(i);
      const Vector3d force = at.rotation * hinge.reaction_force;
      const Vector3d moment =
          at.rotation * (hinge.reaction_moment + hinge.friction_moment);
      loads[1 + i].force += force;
      loads[1 + i].moment +=
          moment + (at.rotation * body.hinge_from_com).cross(force);
      loads[1 + body.parent].force -= force;
      loads[1 + body.parent].moment -=
          moment + (parent.rotation * body.hinge_from_carrier_com).cross(force);
    }
    for (int i = 0; i <= 3; ++i) {
      const BodyMotion& at = sample.motions()[i];
      const double mass =
          i == 0 ? mechanism.carrier.mass : mechanism.bodies[i - 1].mass;
      const Matrix3d inertia = at.rotation *
                               (i == 0 ? mechanism.carrier.inertia
                                       : mechanism.bodies[i - 1].inertia) *
                               at.rotation.transpose();
      const Vector3d& w = at.angular_velocity;
      EXPECT_LT((mass * sample.acceleration(i) - loads[i].force).norm(), 1e-11);
      EXPECT_LT((inertia * sample.angular_acceleration(i) +
                 w.cross(inertia * w) - loads[i].moment)
                    .norm(),
                1e-11);
    }
    for (int i = 0; i < 2; ++i) {
      EXPECT_TRUE(sample.rests_on_stop(i));
      EXPECT_GT(sample.hinge(i).stop_moment, 0.5);
      EXPECT_LT(std::abs(bend(sample, mechanism.stop(i))), 1e-11);
      EXPECT_NEAR(psi(sample, mechanism.stop(i)), mechanism.stop(i).angle,
                  1e-11);
    }
    const HingeSample ball = sample.hinge(0);
    EXPECT_LT((mechanism.joint
                   .solve({ball.reaction_force, ball.relative_angular_velocity})
                   .friction_moment -
               ball.friction_moment)
                  .norm(),
              1e-9 * ball.friction_moment.norm());
    EXPECT_NEAR(sample.energy().balance(), energy, 1e-10);
  }
  EXPECT_GT(motion.sample().energy().dissipated, 0.01);
  EXPECT_TRUE(motion.changes().empty());
}

// Its friction holds a ball at its stop against a moment along the cone that
// grows. With a search for the direction along the cone in which friction would
// oppose what the stop leaves of that moment: there it gives way where the
// friction of sliding is as large, and begins to turn.
TEST(ConeStops, FrictionHoldsWhatTheStopLeaves) {
  const contact::Joint joint = ball_joint(contact::FrictionLaw(0.3));
  const Body body{HingeKind::ball, 50, 2 * Matrix3d::Identity()};
  const Vector3d p = Vector3d(1, 2, -1).normalized();
  const Vector3d n = p.unitOrthogonal(), m = n.cross(p);
  const Vector3d weight(0, 0, 50 * 9.81);
  MotionStart start;
  start.bodies.emplace_back();
  MotionOptions options = accurate();
  options.gravity = -weight / 50;
  options.stops = {{0, 1, -1, 0, AngleAxisd(1, n) * p, p}};
  const auto moment = [&](double time) {
    return Vector3d(time * (p + 0.4 * m) + (3 + 0.3 * time) * n);
  };
  Motion motion(System(ground(), {body}), {JointFriction{joint}},
                std::make_shared<Moment>(moment), start, options);
  // Utilisation, and the moment of the stop.
  const auto split = [&](double time) {
    const auto friction = [&](double way) {
      return joint
          .solve({weight, Vector3d(std::cos(way) * p + std::sin(way) * m)})
          .friction_moment;
    };
    const Vector3d held = -moment(time);
    const auto off = [&](double way) {
      return n.dot(friction(way).cross(held));
    };
    double low = -0.5, high = 1.5;
    EXPECT_LT(off(low) * off(high), 0);
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (off(middle) * off(low) > 0 ? low : high) = middle;
    }
    const Vector3d by = friction(low);
    const double tau = held.dot(p) / by.dot(p);
    return std::pair(tau, (tau * by - held).dot(n));
  };
  ASSERT_EQ(motion.advance_to(0.5), Stop::time);
  HingeSample hinge = motion.sample().hinge(0);
  ASSERT_EQ(hinge.mode, HingeMode::resting);
  EXPECT_TRUE(motion.sample().rests_on_stop(0));
  EXPECT_NEAR(hinge.utilisation, split(0.5).first, 1e-9);
  EXPECT_NEAR(hinge.stop_moment, split(0.5).second, 1e-9);
  EXPECT_LT((hinge.reaction_moment + moment(0.5)).norm(), 1e-10);
  double low = 0.5, high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (split(middle).first < 1 ? low : high) = middle;
  }
  ASSERT_EQ(motion.advance_to(high + 1e-6), Stop::time);
  ASSERT_EQ(motion.changes().size(), 1u);
  EXPECT_NEAR(motion.changes()[0].time, high, 1e-7);
  EXPECT_TRUE(motion.changes()[0].on_stop);
  hinge = motion.sample().hinge(0);
  EXPECT_EQ(hinge.mode, HingeMode::sliding);
  EXPECT_NEAR(hinge.stop_moment, split(high).second, 1e-5);
  ASSERT_EQ(motion.advance_to(high + 0.1), Stop::time);
  EXPECT_TRUE(motion.sample().rests_on_stop(0));
  EXPECT_GT(motion.sample().hinge(0).relative_angular_velocity.norm(), 1e-3);
  EXPECT_NEAR(psi(motion.sample(), options.stops[0]), 1, 1e-11);
  EXPECT_EQ(motion.changes().size(), 1u);
}

// Bounces, the rest of them that is summed, rest on the cone, and what comes
// after it, from a saved state.
TEST(ConeStops, SavedMotionsGoOnTheSame) {
  const ConePendulum pendulum;
  const ConePendulum::State begin{4, 3};
  for (const double time : {0.1, 0.35, 0.9, 1.7, 2.8, 4.0, 6.0, 9.5}) {
    Motion one = pendulum.motion(begin, {});
    ASSERT_EQ(one.advance_to(time), Stop::time);
    const MotionState saved = one.save();
    Motion other = pendulum.motion(begin, {});
    other.restore(saved);
    ASSERT_EQ(one.advance_to(12), Stop::time);
    ASSERT_EQ(other.advance_to(12), Stop::time);
    EXPECT_EQ(one.save().numbers, other.save().numbers) << time;
    EXPECT_EQ(one.sample().hinge(0).stop_moment,
              other.sample().hinge(0).stop_moment);
  }
  MotionState forged = pendulum.motion(begin, {}).save();
  ASSERT_EQ(forged.rests_on[0], 0);
  for (const int stop : {-2, 1}) {
    forged.rests_on[0] = stop;
    EXPECT_THROW(pendulum.motion(begin, {}).restore(forged), contact::Error);
  }
}

// Random trees on balls and axes near their stops, with and without friction:
// bodies bounce, rest, turn along their cones and drive each other off. Nothing
// gets beyond its stop or is pulled by it, and the energy book closes.
class RandomStops {
 public:
  RandomStops(unsigned seed, bool fixed, bool tree) : random_(seed) {
    carrier_ = {5, 0.3 * random_.inertia()};
    carrier_.fixed = fixed;
    if (fixed) options_.gravity = {0, 0, -9.81};
    if (!fixed) start_.carrier.angular_velocity = 0.5 * random_.vector();
    const int count = 1 + static_cast<int>(3 * share());
    for (int i = 0; i < count; ++i) add(i, tree);
  }
  Motion motion() const {
    return {System(carrier_, bodies_), friction_, nullptr, start_, options_};
  }
  // Least distance from the stops.
  double gap(const MotionSample& sample) const {
    double least = 1;
    for (const HingeStop& stop : options_.stops) {
      const Body& body = bodies_[stop.body];
      const double angle = body.kind == HingeKind::axis
                               ? sample.angle(stop.body)
                               : psi(sample, stop, 1 + body.parent);
      least = std::min(least, stop.gap(angle));
    }
    return least;
  }

 private:
  double share() { return std::abs(std::fmod(random_.number(), 1)); }
  void add(int i, bool tree) {
    Body& body = bodies_.emplace_back();
    body.kind = share() < 0.7 ? HingeKind::ball : HingeKind::axis;
    body.mass = 1 + share();
    body.inertia = 0.3 * random_.inertia();
    body.hinge_from_com = 0.5 * random_.vector();
    body.hinge_from_carrier_com = 0.5 * random_.vector();
    body.hinge_to_body = random_.turn();
    body.hinge_to_carrier_zero = random_.turn();
    if (tree) body.parent = static_cast<int>(share() * (i + 1)) - 1;
    BodyStart& start = start_.bodies.emplace_back();
    start.rotation = random_.turn();
    start.relative_angular_velocity = 0.7 * random_.vector();
    start.angle_rate = random_.number();
    const contact::FrictionLaw law(0.2 * share());
    friction_.emplace_back();
    const bool is_ball = body.kind == HingeKind::ball;
    if (share() < 0.6) {
      friction_.back() =
          JointFriction{is_ball ? ball_joint(law) : pin_joint(law)};
    }
    const double e = share() < 0.3 ? 0 : 0.8 * share();
    const Vector3d b = random_.unit(), p = random_.unit();
    const double angle = is_ball ? angle_of(start.rotation * b, p) : 0;
    for (const int side : {1, -1}) {
      const double at = angle - side * (0.4 * share() + 1e-3);
      if (is_ball && !(0.05 < at && at < pi - 0.05)) continue;
      if (share() < 0.8) options_.stops.push_back({i, at, side, e, b, p});
    }
  }

  Random random_;
  Carrier carrier_;
  std::vector<Body> bodies_;
  std::vector<HingeFriction> friction_;
  MotionStart start_;
  MotionOptions options_;
};

TEST(ConeStops, RandomMechanismsStayWithinTheirStops) {
  int rests = 0, held = 0;
  std::size_t impacts = 0;
  double worst = 0, beyond = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const RandomStops random(seed, seed % 2 == 1, seed % 4 > 1);
    Motion motion = random.motion();
    const double begin = motion.sample().energy().balance();
    double size = 1;
    for (double time = 0.02; time < 3; time += 0.02) {
      ASSERT_EQ(motion.advance_to(time), Stop::time)
          << seed << ' ' << motion.failure()->message();
      const MotionSample& sample = motion.sample();
      beyond = std::max(beyond, -random.gap(sample));
      size = std::max(size, sample.energy().kinetic);
      for (int i = 0; i + 1 < std::ssize(sample.motions()); ++i) {
        if (!sample.rests_on_stop(i)) continue;
        ++rests;
        if (sample.mode(i) == HingeMode::resting) ++held;
      }
    }
    impacts += motion.impacts().size();
    worst = std::max(
        worst, std::abs(motion.sample().energy().balance() - begin) / size);
  }
  EXPECT_GT(rests, 10000);
  EXPECT_GT(held, 1000);
  EXPECT_GT(impacts, 1000u);
  EXPECT_LT(worst, 1e-7);
  EXPECT_LT(beyond, 1e-7);
}

}  // namespace
}  // namespace multibody::test::motion_cones_test
