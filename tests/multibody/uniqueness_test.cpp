// Two pins in a chain, and one on the ground, with friction so strong that
// none, one or several moments fit the reactions they cause: how many there
// are, by the library and by a scan of the equations of a plane pendulum.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/base/root_finding.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "multibody_support/coupled.hpp"
#include "multibody_support/prepared.hpp"

namespace multibody::test::uniqueness_test {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Rod {
  double mass, inertia, length, com;  // com: from its hinge
  double angle, rate;                 // absolute
  Vector2d force;                     // at the centre of mass
  double radius, coefficient;         // pin's
};

contact::Joint pin_of(const Rod& rod, const contact::ElasticPair& pair) {
  constexpr auto kind = contact::JointKind::pin;
  return contact::Joint(
      {contact::JointGeometry::pin(rod.radius, 1e-3 * rod.radius, 0.1), pair,
       contact::FrictionLaw(rod.coefficient),
       contact::make_half_angle_law("tanh", kind, pair),
       std::make_unique<contact::CosinePressure>(kind)});
}

// A harsh one: f0 0.5 to 2, rho/L 0.1 to 1; with soft halves the moment grows
// faster than the load.
struct Chain {
  explicit Chain(int seed) {
    std::mt19937_64 random(seed);
    const auto within = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) / 0x1p53;
    };
    for (int i = 0; i < 2; ++i) {
      Rod rod{};
      rod.mass = std::pow(10, within(-1, 1));
      rod.length = within(0.2, 1);
      rod.com = rod.length * within(0.2, 1);
      rod.inertia = rod.mass * rod.length * rod.length * within(0.01, 0.2);
      rod.angle = within(-3, 3);
      rod.rate = within(-2, 2);
      rod.force = 20 * rod.mass * Vector2d(within(-1, 1), within(-1, 1));
      rod.radius = rod.length * std::pow(10, within(-1, 0));
      rod.coefficient = within(0.5, 2);
      rods.push_back(rod);
    }
    const contact::Material material(std::pow(10, within(3, 11)), 0.3);
    for (const Rod& rod : rods)
      pins.push_back(pin_of(rod, {material, material}));
  }

  double sign(int i) const {
    return rods[i].rate < (i == 0 ? 0 : rods[0].rate) ? -1 : 1;
  }

  // |R| on both pins for moments of these sizes against the sliding: for rod 2
  // the moment about its hinge, for both rods the moment about the first hinge.
  Vector2d loads(const Vector2d& sizes) const {
    const auto cross = [](const Vector2d& a, const Vector2d& b) {
      return a.x() * b.y() - a.y() * b.x();
    };
    const auto& [one, two] = std::pair(rods[0], rods[1]);
    Vector2d e[2], n[2];
    for (int i = 0; i < 2; ++i) {
      e[i] = {std::cos(rods[i].angle), std::sin(rods[i].angle)};
      n[i] = {-e[i].y(), e[i].x()};
    }
    const Vector2d places[] = {one.com * e[0],
                               one.length * e[0] + two.com * e[1]};
    // Acceleration of the centre of mass i = turns[i] w' + bends[i].
    Eigen::Matrix2d turns[2];
    turns[0] << one.com * n[0], Vector2d::Zero();
    turns[1] << one.length * n[0], two.com * n[1];
    const double squares[] = {one.rate * one.rate, two.rate * two.rate};
    const Vector2d bends[] = {
        -one.com * squares[0] * e[0],
        -one.length * squares[0] * e[0] - two.com * squares[1] * e[1]};
    Matrix2d a = Matrix2d::Zero();
    Vector2d b(-sign(0) * sizes[0], -sign(1) * sizes[1]);
    for (int i = 0; i < 2; ++i) {
      const Vector2d free = rods[i].force - rods[i].mass * bends[i];
      a(0, i) += rods[i].inertia;
      b[0] += cross(places[i], free);
      for (int k = 0; k < 2; ++k) {
        a(0, k) += rods[i].mass * cross(places[i], turns[i].col(k));
      }
    }
    a(1, 1) += two.inertia;
    b[1] += two.com * cross(e[1], two.force - two.mass * bends[1]);
    for (int k = 0; k < 2; ++k) {
      a(1, k) += two.mass * two.com * cross(e[1], turns[1].col(k));
    }
    const Vector2d turn = a.inverse() * b;
    const auto needed = [&](int i) {
      return Vector2d(rods[i].mass * (turns[i] * turn + bends[i]) -
                      rods[i].force);
    };
    const Vector2d second = needed(1);
    return {(needed(0) + second).norm(), second.norm()};
  }

  // |R| on the first pin if its rod is alone.
  double load_alone(double size) const {
    const Rod& rod = rods[0];
    const Vector2d e(std::cos(rod.angle), std::sin(rod.angle));
    const Vector2d n(-e.y(), e.x());
    const double turn = (rod.com * n.dot(rod.force) - sign(0) * size) /
                        (rod.inertia + rod.mass * rod.com * rod.com);
    const Vector2d acceleration =
        rod.com * (turn * n - rod.rate * rod.rate * e);
    return (rod.mass * acceleration - rod.force).norm();
  }

  double moment(int i, double load) const {
    return std::abs(
        pins[i]
            .solve(
                {{load, 0, 0}, sign(i) * Vector3d::UnitZ(), Vector3d::UnitZ()})
            .friction_moment.z());
  }

  // Friction under the reactions that such friction causes, less the latter.
  Vector2d mismatch(const Vector2d& sizes) const {
    const Vector2d load = loads(sizes);
    return Vector2d(moment(0, load[0]), moment(1, load[1])) - sizes;
  }

  std::vector<Rod> rods;
  std::vector<contact::Joint> pins;
};

// From 0 to far beyond what could fit.
std::vector<double> grid(double scale, int per_decade) {
  std::vector<double> all{0};
  for (int k = -3 * per_decade; k <= 6 * per_decade; ++k) {
    all.push_back(scale * std::pow(10, double(k) / per_decade));
  }
  return all;
}

// Where f is 0: two places at most, as the friction of a pin is convex over its
// moment.
template <class F>
std::vector<double> roots(const F& f, double scale) {
  const std::vector<double> x = grid(scale, 8);
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  std::vector<double> found;
  const auto between = [&](double low, double high, double fl, double fh) {
    found.push_back(contact::shrink_bracket(f, low, high, fl, fh, 48).middle());
  };
  for (std::size_t k = 1; k < x.size(); ++k) {
    if ((y[k] > 0) != (y[k - 1] > 0)) {
      between(x[k - 1], x[k], y[k - 1], y[k]);
    } else if (k + 1 < x.size() && y[k] > 0 && y[k] <= y[k - 1] &&
               y[k] <= y[k + 1] && y[k + 1] > 0) {
      // Two between neighbours, perhaps.
      double low = x[k - 1], high = x[k + 1];
      constexpr double golden = 0.381966;
      for (int step = 0; step < 40; ++step) {
        const double a = low + golden * (high - low);
        const double b = high - golden * (high - low);
        (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
      }
      const double least = (low + high) / 2, value = f(least);
      if (value > 0) continue;
      between(x[k - 1], least, y[k - 1], value);
      between(least, x[k + 1], value, y[k + 1]);
    }
  }
  return found;
}

// Sizes of the second moment that fit its pin beside a given first one.
std::vector<double> seconds(const Chain& chain, double first, double scale) {
  return roots(
      [&](double second) {
        return chain.mismatch({first, second})[1];
      },
      scale);
}

bool solve_from(const Chain& chain, Vector2d& x) {
  for (int step = 0; step < 50; ++step) {
    const Vector2d f = chain.mismatch(x);
    if (f.norm() <= 1e-11 * x.norm()) return x.minCoeff() >= 0;
    Matrix2d slope;
    for (int k = 0; k < 2; ++k) {
      const double by = 1e-6 * x.norm();
      slope.col(k) = (chain.mismatch(x + by * Vector2d::Unit(k)) - f) / by;
    }
    Vector2d by = -slope.inverse() * f;
    const double far = by.norm() / x.norm();
    if (far > 0.3) by *= 0.3 / far;
    x += by;
  }
  return false;
}

// All pairs of sizes that fit.
std::vector<Vector2d> all_of(const Chain& chain) {
  const Vector2d slid = chain.mismatch(Vector2d::Zero());
  const double scale = slid.maxCoeff();
  std::vector<Vector2d> found;
  const auto look = [&](double first, double second) {
    Vector2d x(first, second);
    if (!solve_from(chain, x)) return;
    const bool is_new = std::none_of(
        found.begin(), found.end(),
        [&](const Vector2d& y) { return (x - y).norm() < 1e-6 * x.norm(); });
    if (is_new) found.push_back(x);
  };
  // Along each branch of seconds the first moment's mismatch: it changes its
  // sign, or is least, or the branch ends.
  std::vector<double> last, last_values;
  double before = 0;
  for (const double first : grid(scale, 20)) {
    const std::vector<double> now = seconds(chain, first, scale);
    std::vector<double> values;
    for (const double second : now) {
      values.push_back(chain.mismatch({first, second})[0]);
    }
    const bool same = now.size() == last.size();
    for (std::size_t k = 0; k < last.size(); ++k) {
      if (!same || (values[k] > 0) != (last_values[k] > 0)) {
        look(before, last[k]);
      }
    }
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (!same || (values[k] > 0) != (last_values[k] > 0)) look(first, now[k]);
    }
    last = now;
    last_values = values;
    before = first;
  }
  return found;
}

// The library's chain.
struct Ours {
  Prepared prepared;
  Coupled coupled;

  static Instant instant(const Chain& chain, int size) {
    Instant all;
    all.carrier.fixed = true;
    for (int i = 0; i < size; ++i) {
      const Rod& rod = chain.rods[i];
      BodyInstant body;
      body.body = {HingeKind::axis, rod.mass,
                   rod.inertia * Eigen::Matrix3d::Identity()};
      body.body.hinge_from_com.x() = -rod.com;
      body.angle = rod.angle;
      body.angle_rate = rod.rate;
      if (i > 0) {
        const Rod& below = chain.rods[0];
        body.body.parent = 0;
        body.body.hinge_from_carrier_com.x() = below.length - below.com;
        body.angle -= below.angle;
        body.angle_rate -= below.rate;
      }
      body.active_force.head<2>() = Eigen::Rotation2Dd(-rod.angle) * rod.force;
      all.bodies.push_back(body);
    }
    return all;
  }
  static std::vector<HingeFriction> friction(const Chain& chain, int size) {
    std::vector<HingeFriction> all;
    for (int i = 0; i < size; ++i) all.push_back(JointFriction{chain.pins[i]});
    return all;
  }

  explicit Ours(const Chain& chain, int size = 2)
      : prepared(prepare(instant(chain, size))),
        coupled(prepared.system, friction(chain, size)) {
    for (int i = 0; i < size; ++i) {
      coupled.set_direction(i, chain.sign(i) * Vector3d::UnitZ());
    }
    coupled.prescribe_carrier({});
  }
};

// The library finds all solutions, and never calls one of two the only one.
TEST(Uniqueness, TwoPinsInAChain) {
  std::vector<int> counts(3);
  int proven = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const Chain chain(seed);
    const std::vector<Vector2d> all = all_of(chain);
    ASSERT_LT(all.size(), counts.size()) << seed;
    ++counts[all.size()];
    Ours ours(chain);
    const CoupledReport report =
        ours.coupled.evaluate(ours.prepared.state, ours.prepared.forces);
    std::vector<Vector2d> found;
    const auto add = [&](const Vector3d& first, const Vector3d& second) {
      found.emplace_back(-chain.sign(0) * first.z(),
                         -chain.sign(1) * second.z());
    };
    if (report.status == CoupledStatus::ok) {
      add(ours.coupled.friction_moment(0), ours.coupled.friction_moment(1));
      proven += !report.others_possible;
    } else {
      EXPECT_FALSE(report.others_possible) << seed;
      for (const CoupledSolution& s : ours.coupled.solutions()) {
        add(s.moments[0], s.moments[1]);
      }
    }
    EXPECT_EQ(found.size(), all.size()) << seed;
    for (const Vector2d& x : all) {
      double nearest = 1;
      for (const Vector2d& y : found) {
        nearest = std::min(nearest, (x - y).norm() / x.norm());
      }
      // Near double solutions move further within the tolerance of 1e-10 of the
      // library's equations.
      EXPECT_LT(nearest, 1e-7) << seed;
    }
  }
  EXPECT_GT(counts[0], 20);
  EXPECT_GT(counts[2], 20);
  // Most of those that are alone are known to be.
  EXPECT_GT(proven, 0.8 * counts[1]);
}

// Local slopes below 1 do not hide a second moment: with soft halves friction
// is steeper under larger loads.
TEST(Uniqueness, OnePinOfAStar) {
  std::vector<int> counts(3);
  for (int seed = 0; seed < 1000; ++seed) {
    const Chain chain(seed);
    const auto mismatch = [&](double size) {
      return chain.moment(0, chain.load_alone(size)) - size;
    };
    const std::vector<double> all = roots(mismatch, mismatch(0));
    ASSERT_LT(all.size(), counts.size()) << seed;
    ++counts[all.size()];
    Ours ours(chain, 1);
    const CoupledReport report =
        ours.coupled.evaluate(ours.prepared.state, ours.prepared.forces);
    const std::size_t found = report.status == CoupledStatus::ok
                                  ? 1
                                  : ours.coupled.solutions().size();
    EXPECT_EQ(found, all.size()) << seed;
    EXPECT_FALSE(report.others_possible) << seed;
  }
  EXPECT_GT(counts[0], 10);
  EXPECT_GT(counts[2], 10);
}

}  // namespace
}  // namespace multibody::test::uniqueness_test
