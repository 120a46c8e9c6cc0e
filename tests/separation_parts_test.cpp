// Parts of hinge-separation against independent routes: inertia of solids,
// distances, forces that keep momentum.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "libcontact/error.hpp"
#include "separation/clearance.hpp"
#include "separation/shape.hpp"
#include "support/error_message.hpp"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyMotion;
using separation::Clearance;
using separation::convex_hull;
using separation::Shape;
using separation::ShapeKind;
using separation::solid_properties;
using separation::SolidProperties;

constexpr double pi = std::numbers::pi;

void expect_close(const Matrix3d& a, const Matrix3d& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance * b.norm()) << a << "\n\n" << b;
}

// Slices of discs of the radius r(z), axis from `from` along `axis`.
template <class R>
SolidProperties of_slices(const R& radius, const std::vector<double>& ends,
                          const Vector3d& from, const Vector3d& axis) {
  const auto integral = [&](const auto& f) {
    double sum = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      sum += boost::math::quadrature::gauss<double, 20>::integrate(
          f, ends[i - 1], ends[i]);
    }
    return sum;
  };
  const auto area = [&](double z) { return pi * radius(z) * radius(z); };
  const double v = integral(area);
  const double c = integral([&](double z) { return z * area(z); }) / v;
  const double axial =
      integral([&](double z) { return area(z) * radius(z) * radius(z) / 2; });
  const double across = integral([&](double z) {
    return area(z) * (radius(z) * radius(z) / 4 + (z - c) * (z - c));
  });
  const Matrix3d along = axis * axis.transpose();
  return {v, from + c * axis,
          axial * along + across * (Matrix3d::Identity() - along)};
}

TEST(Shape, SolidsOfRevolutionAgainstSlices) {
  const Vector3d from(1, -2, 0.5);
  const Vector3d axis = Vector3d(2, 1, -3).normalized();
  const double l = 2.75, r = 0.625;
  const auto check = [&](ShapeKind kind, const auto& radius,
                         const std::vector<double>& ends) {
    const SolidProperties s =
        solid_properties(Shape{kind, from, from + l * axis, r});
    const SolidProperties exact = of_slices(radius, ends, from, axis);
    EXPECT_NEAR(s.volume, exact.volume, 1e-13 * exact.volume);
    EXPECT_LE((s.centroid - exact.centroid).norm(), 1e-13 * l);
    expect_close(s.inertia, exact.inertia, 1e-13);
  };
  check(ShapeKind::cylinder, [&](double) { return r; }, {0, l});
  check(ShapeKind::cone, [&](double z) { return r * (1 - z / l); }, {0, l});
  const auto capsule = [&](double z) {
    const double out = z < 0 ? z : z > l ? z - l : 0;
    return std::sqrt(r * r - out * out);
  };
  check(ShapeKind::capsule, capsule, {-r, 0, l, l + r});
}

TEST(Shape, HullsOfBoxAndTetrahedron) {
  const Vector3d size(1, 2, 4);
  std::vector<Vector3d> corners = {{0.1, 0.2, 0.3}};  // one inside
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1 ? 1 : 0, i & 2 ? 2 : 0, i & 4 ? 4 : 0);
  }
  const Shape box = convex_hull(corners);
  EXPECT_EQ(box.points.size(), 8U);
  EXPECT_EQ(box.faces.size(), 12U);
  const SolidProperties s = solid_properties(box);
  EXPECT_NEAR(s.volume, 8, 1e-13);
  EXPECT_LE((s.centroid - size / 2).norm(), 1e-13);
  const Vector3d square = size.cwiseProduct(size);
  const Matrix3d inertia =
      8.0 / 12 *
      (square.sum() * Vector3d::Ones() - square).asDiagonal().toDenseMatrix();
  expect_close(s.inertia, inertia, 1e-13);

  // Corner at the origin and unit legs: I_xx = 1/80, I_xy = +1/480 about the
  // centroid.
  const SolidProperties t = solid_properties(
      convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_NEAR(t.volume, 1.0 / 6, 1e-15);
  EXPECT_LE((t.centroid - Vector3d::Constant(0.25)).norm(), 1e-15);
  Matrix3d exact = Matrix3d::Constant(1.0 / 480);
  exact.diagonal().setConstant(1.0 / 80);
  expect_close(t.inertia, exact, 1e-13);
}

TEST(Shape, SeveralTogetherAreOneBody) {
  const Vector3d a(0, 0, 0), m(1, 1, 0), b(3, 3, 0);
  const SolidProperties whole =
      solid_properties(Shape{ShapeKind::cylinder, a, b, 0.5});
  const SolidProperties parts = solid_properties(std::vector<Shape>{
      {ShapeKind::cylinder, a, m, 0.5}, {ShapeKind::cylinder, m, b, 0.5}});
  EXPECT_NEAR(parts.volume, whole.volume, 1e-13 * whole.volume);
  EXPECT_LE((parts.centroid - whole.centroid).norm(), 1e-13);
  expect_close(parts.inertia, whole.inertia, 1e-13);
}

TEST(Shape, FlatHullsAreRefused) {
  EXPECT_EQ(contact::test::error_message([] {
              convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
            }),
            "a hull needs 4 or more points");
  EXPECT_EQ(contact::test::error_message([] {
              convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
            }),
            "the points of a hull are (nearly) in one plane");
}

// Largest n . x over a solid.
double support(const Shape& s, const Vector3d& n) {
  const double ends = std::max(n.dot(s.from), n.dot(s.to));
  const Vector3d axis = (s.to - s.from).normalized();
  const double across = s.radius * n.cross(axis).norm();
  switch (s.kind) {
    case ShapeKind::capsule:
      return ends + s.radius * n.norm();
    case ShapeKind::cylinder:
      return ends + across;
    case ShapeKind::cone:
      return std::max(n.dot(s.to), n.dot(s.from) + across);
    case ShapeKind::hull:
      break;
  }
  double largest = n.dot(s.points[0]);
  for (const Vector3d& p : s.points) largest = std::max(largest, n.dot(p));
  return largest;
}

// Distance of convex solids: the widest gap between parallel planes, over all
// directions; a search that narrows down. Negative if they overlap.
double widest_gap(const Shape& a, const Shape& b, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto gap = [&](const Vector3d& n) {
    return -support(b, -n) - support(a, n);
  };
  Vector3d best = Vector3d::UnitX();
  double value = gap(best);
  double spread = 10;
  for (int i = 0; i < 160000; ++i) {
    Vector3d n = best;
    for (double& x : n) x += spread * normal(random);
    n.normalize();
    const double g = gap(n);
    if (g > value) {
      value = g;
      best = n;
      spread *= 1.3;
    } else {
      spread = std::max(0.995 * spread, 1e-9);
    }
    if (i % 8000 == 7999) spread = 1e-3;
  }
  return value;
}

Shape random_shape(ShapeKind kind, std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto v = [&] { return Vector3d(u(random), u(random), u(random)); };
  if (kind == ShapeKind::hull) {
    std::vector<Vector3d> points(12);
    for (Vector3d& p : points) p = v();
    return convex_hull(points);
  }
  const Vector3d from = v();
  return {kind, from, from + 2 * v(), 0.3 + 0.2 * u(random)};
}

TEST(Clearance, AgainstTheWidestGapBetweenPlanes) {
  std::mt19937 random(7);
  double largest = 0;
  int apart = 0;
  for (int i = 0; i < 160; ++i) {
    const Shape a = random_shape(static_cast<ShapeKind>(i % 4), random);
    Shape b = random_shape(static_cast<ShapeKind>(i / 4 % 4), random);
    b.move(Vector3d(2.5, -1, 0.5));
    const double expected = widest_gap(a, b, random);
    // The same in space, each in axes of its own.
    std::vector<BodyMotion> bodies(2);
    std::vector<std::vector<Shape>> shapes;
    for (int k = 0; k < 2; ++k) {
      BodyMotion& body = bodies[k];
      body.rotation = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
      body.position = Vector3d(1000, 2 * k, -k);
      Shape s = k == 0 ? a : b;
      const auto local = [&](const Vector3d& p) -> Vector3d {
        return body.rotation.transpose() *
               (p + Vector3d(1000, 0, 0) - body.position);
      };
      s.from = local(s.from);
      s.to = local(s.to);
      for (Vector3d& p : s.points) p = local(p);
      shapes.push_back({s});
    }
    Clearance clearance(shapes, {{0, 1}});
    const double found = clearance.distances(bodies)[0];
    if (expected < 1e-3) {
      EXPECT_LE(found, std::max(expected, 0.0) + 1e-3) << i;
      continue;
    }
    ++apart;
    largest = std::max(largest, std::abs(found - expected));
    // clearance.hpp
    EXPECT_NEAR(found, expected, 1e-5 * (1 + expected))
        << i % 4 << ' ' << i / 4 % 4;
  }
  std::printf("largest error of %d distances: %.1e m\n", apart, largest);
  EXPECT_GT(apart, 60);
}

TEST(Clearance, BodiesOfSeveralSolids) {
  const Shape ball{ShapeKind::capsule, {0, 0, 0}, {0, 0, 0}, 0.5};
  Shape far = ball;
  far.move(Vector3d(3, 0, 0));
  std::vector<BodyMotion> bodies(3, {Vector3d::Zero(), Vector3d::Zero(),
                                     Matrix3d::Identity(), Vector3d::Zero()});
  bodies[1].position = Vector3d(5, 0, 0);
  bodies[2].position = Vector3d(0.4, 0, 0);
  Clearance clearance({{ball, far}, {ball}, {ball}}, {{0, 1}, {0, 2}});
  const auto d = clearance.distances(bodies);
  EXPECT_NEAR(d[0], 1, 1e-6);
  EXPECT_EQ(d[1], 0);
}

}  // namespace
