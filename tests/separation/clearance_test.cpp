// Distances of solids against closed forms, against all pairs of corners, edges
// and faces, and against what proves them: two points and two planes.
#include "separation/clearance/clearance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "separation/case/case_reader.hpp"
#include "separation/clearance/pair_way.hpp"
#include "separation/clearance/passage.hpp"
#include "separation/results/run.hpp"
#include "support/numbers.hpp"
#include "support/toml_text.hpp"

namespace contact::test::clearance_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyMotion;
using separation::box;
using separation::Clearance;
using separation::convex_hull;
using separation::Nearest;
using separation::nearest;
using separation::RelativePlace;
using separation::Shape;
using separation::ShapeKind;
using separation::Solid;

// Solids and places: generic ones, and typical ones of drawings with round
// numbers and right angles, exact and slightly perturbed.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double number(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  int whole(int from, int to) {
    return std::uniform_int_distribution<int>(from, to)(random_);
  }
  Vector3d vector(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  // Multiples of a quarter.
  Vector3d round_vector(int quarters) {
    return 0.25 * Vector3d(whole(-quarters, quarters),
                           whole(-quarters, quarters),
                           whole(-quarters, quarters));
  }
  Matrix3d rotation() {
    const Eigen::Vector4d q(normal_(random_), normal_(random_),
                            normal_(random_), normal_(random_));
    return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
  }
  // One of the 24, with entries 0, 1 and -1.
  Matrix3d right_angles() {
    Matrix3d turn = Matrix3d::Identity();
    for (int i = 0; i < 4; ++i) {
      const int axis = whole(0, 2);
      Matrix3d quarter = Matrix3d::Zero();
      quarter(axis, axis) = 1;
      quarter((axis + 1) % 3, (axis + 2) % 3) = -1;
      quarter((axis + 2) % 3, (axis + 1) % 3) = 1;
      if (whole(0, 1) == 1) turn = (quarter * turn).eval();
    }
    return turn;
  }
  std::vector<Vector3d> shuffled(std::vector<Vector3d> points) {
    std::shuffle(points.begin(), points.end(), random_);
    return points;
  }

  // Solid of flat faces, on round numbers or not.
  Shape polyhedron(int kind, bool round) {
    if (kind == 0) {
      const Vector3d size =
          round
              ? Vector3d(0.5 * Vector3d(whole(1, 4), whole(1, 4), whole(1, 4)))
              : Vector3d(number(0.2, 2), number(0.2, 2), number(0.2, 2));
      return box(round ? round_vector(4) : vector(1), size,
                 round ? right_angles() : rotation());
    }
    std::vector<Vector3d> points;
    if (kind == 1) {  // a prism
      const int sides = whole(3, 12);
      for (int i = 0; i < sides; ++i) {
        const double t = 2 * pi * i / sides;
        points.emplace_back(std::cos(t), std::sin(t), -0.25);
        points.emplace_back(std::cos(t), std::sin(t), 0.5);
      }
    } else {
      for (int i = 0; i < 12; ++i) points.push_back(vector(1));
    }
    return convex_hull(shuffled(points));
  }
  Shape solid(bool round) {
    const int kind = whole(0, 6);
    if (kind < 3) return polyhedron(kind, round);
    const Vector3d from = round ? round_vector(4) : vector(1);
    if (kind == 3) return {ShapeKind::capsule, from, from, number(0.1, 0.5)};
    const Vector3d span =
        round ? Vector3d(0.5 * whole(1, 4) * right_angles().col(0)) : vector(2);
    return {static_cast<ShapeKind>(kind - 4), from, from + span,
            round ? 0.25 * whole(1, 3) : number(0.1, 0.5)};
  }
  // 0 generic, 1 with right angles, 2 with nearly right angles.
  RelativePlace place(int kind) {
    if (kind == 0) return {rotation(), vector(4)};
    const RelativePlace right{right_angles(), round_vector(16)};
    if (kind == 1) return right;
    const double little = std::pow(10, number(-12, -2));
    return {Eigen::AngleAxisd(little, vector(1).normalized()) * right.rotation,
            right.position + little * vector(1)};
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

// Largest n . x over a solid; n is a unit vector.
double support(const Shape& s, const Vector3d& n) {
  if (s.kind == ShapeKind::hull) {
    double largest = n.dot(s.points[0]);
    for (const Vector3d& p : s.points) largest = std::max(largest, n.dot(p));
    return largest;
  }
  const double ends = std::max(n.dot(s.from), n.dot(s.to));
  if (s.kind == ShapeKind::capsule) return ends + s.radius;
  const double across = s.radius * n.cross((s.to - s.from).normalized()).norm();
  if (s.kind == ShapeKind::cylinder) return ends + across;
  return std::max(n.dot(s.to), n.dot(s.from) + across);
}

// How far a point is outside at least one of the surfaces; negative inside.
double outside(const Shape& s, const Vector3d& p) {
  if (s.kind == ShapeKind::hull) {
    double farthest = -1e9;
    for (const auto& [i, j, k] : s.faces) {
      const Vector3d normal =
          (s.points[j] - s.points[i]).cross(s.points[k] - s.points[i]);
      farthest = std::max(farthest, normal.normalized().dot(p - s.points[i]));
    }
    return farthest;
  }
  const double length = (s.to - s.from).norm();
  const Vector3d axis = (s.to - s.from).stableNormalized();
  const double z = axis.dot(p - s.from);
  if (s.kind == ShapeKind::capsule) {
    const Vector3d core = s.from + std::clamp(z, 0., length) * axis;
    return (p - core).norm() - s.radius;
  }
  const double across = (p - s.from - z * axis).norm();
  if (s.kind == ShapeKind::cylinder) {
    return std::max({-z, z - length, across - s.radius});
  }
  const double slope = std::hypot(s.radius, length);
  return std::max(-z, (across - s.radius * (1 - z / length)) * length / slope);
}

Vector3d inside(const Shape& s, Draw& draw) {
  if (s.kind != ShapeKind::hull) {
    return s.from + draw.number(0.05, 0.95) * (s.to - s.from);
  }
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (const Vector3d& p : s.points) {
    const double weight = draw.number(0.01, 1);
    sum += weight * p;
    weights += weight;
  }
  return sum / weights;
}

Shape placed(Shape s, const RelativePlace& place) {
  const auto to_place = [&](Vector3d& p) {
    p = place.rotation * p + place.position;
  };
  to_place(s.from);
  to_place(s.to);
  for (Vector3d& p : s.points) to_place(p);
  return s;
}

double size_of(const Shape& a, const Shape& b, const RelativePlace& place) {
  return separation::reach(a) + separation::reach(b) + place.position.norm();
}

Nearest nearest_of(const Shape& a, const Shape& b, const RelativePlace& place) {
  return nearest(Solid(a), Solid(b), place, INFINITY);
}

// Points in the solids and planes between them prove a distance from above and
// from below, independent of the algorithm.
TEST(Clearance, TenThousandDistancesAreProven) {
  Draw draw(1);
  double widest = 0;
  double farthest_out = 0;
  int apart = 0;
  for (int i = 0; i < 12000; ++i) {
    const Shape a = draw.solid(i % 3 > 0);
    const Shape b = draw.solid(i % 3 > 0);
    const RelativePlace place = draw.place(i % 3);
    const Nearest found = nearest_of(a, b, place);
    ASSERT_FALSE(std::isnan(found.distance)) << i;
    if (found.distance == 0) continue;
    ++apart;
    const double size = size_of(a, b, place);
    const Shape there = placed(b, place);
    EXPECT_NEAR((found.on_b - found.on_a).norm(), found.distance, 1e-14 * size);
    EXPECT_NEAR(found.normal.norm(), 1, 1e-14);
    farthest_out = std::max({farthest_out, outside(a, found.on_a) / size,
                             outside(there, found.on_b) / size});
    const double planes =
        -support(there, -found.normal) - support(a, found.normal);
    EXPECT_GT(planes, 0) << i;
    widest = std::max(widest, (found.distance - planes) / size);
  }
  std::printf(
      "%d distances: planes within %.1e, points outside by %.1e of the size\n",
      apart, widest, farthest_out);
  EXPECT_GT(apart, 10000);
  EXPECT_LE(widest, 1e-8);  // clearance/nearest.hpp
  EXPECT_LE(farthest_out, 1e-14);
}

// Solids that share a point are not apart, and solids with a plane between
// them do not overlap.
TEST(Clearance, OverlapsAreToldFromGaps) {
  Draw draw(2);
  for (int i = 0; i < 12000; ++i) {
    const Shape a = draw.solid(i % 3 > 0);
    const Shape b = draw.solid(i % 3 > 0);
    RelativePlace place = draw.place(i % 3);
    place.position = inside(a, draw) - place.rotation * inside(b, draw);
    EXPECT_EQ(nearest_of(a, b, place).distance, 0) << i;

    const Vector3d n =
        i % 3 == 0 ? draw.vector(1).normalized() : draw.right_angles().col(0);
    const double between = -support(placed(b, place), -n) - support(a, n);
    const double gap = std::pow(10, draw.number(-6, 1));
    place.position += (gap - between) * n;
    EXPECT_GE(nearest_of(a, b, place).distance,
              gap - 1e-14 * size_of(a, b, place))
        << i;
  }
}

BodyMotion at_rest(const Vector3d& position, const Matrix3d& rotation) {
  return {position, Vector3d::Zero(), rotation, Vector3d::Zero()};
}

// Along axes, described in any axes of right angles, far from the origin.
TEST(Clearance, BoxesAgainstTheirClosedForm) {
  Draw draw(3);
  const auto sizes = [&] {
    return Vector3d(0.25 * Vector3d(draw.whole(1, 12), draw.whole(1, 12),
                                    draw.whole(1, 12)));
  };
  double largest = 0;
  for (int i = 0; i < 6000; ++i) {
    const Vector3d half_a = sizes() / 2;
    const Vector3d half_b = sizes() / 2;
    const Vector3d apart = draw.round_vector(16);
    const Vector3d gaps = (apart.cwiseAbs() - half_a - half_b).cwiseMax(0);
    std::vector<std::vector<Shape>> shapes;
    std::vector<BodyMotion> bodies;
    for (const auto& [half, place] :
         {std::pair<Vector3d, Vector3d>{half_a, Vector3d::Zero()},
          {half_b, apart}}) {
      const Matrix3d turn = draw.right_angles();
      const Vector3d centre = draw.round_vector(4);
      Shape shape = box(centre, 2 * half, turn.transpose());
      if (i % 2 == 0) shape = convex_hull(draw.shuffled(shape.points));
      shapes.push_back({shape});
      bodies.push_back(
          at_rest(Vector3d(1000, -500, 0) + place - turn * centre, turn));
    }
    const double found = Clearance(shapes, {{0, 1}}).distance(0, bodies);
    largest = std::max(largest, std::abs(found - gaps.norm()));
    EXPECT_EQ(found == 0, gaps.norm() == 0);
  }
  std::printf("largest error of boxes: %.1e m\n", largest);
  EXPECT_LE(largest, 1e-9);
}

// Distance of the segments from p to q and from r to s, whose nearest points
// are within both, or at an end.
double between_edges(const Vector3d& p, const Vector3d& q, const Vector3d& r,
                     const Vector3d& s) {
  const Vector3d u = q - p;
  const Vector3d v = s - r;
  const auto to_segment = [](const Vector3d& x, const Vector3d& from,
                             const Vector3d& along) {
    const double t = along.dot(x - from) / along.squaredNorm();
    return (from + std::clamp(t, 0., 1.) * along - x).norm();
  };
  double least = std::min({to_segment(p, r, v), to_segment(q, r, v),
                           to_segment(r, p, u), to_segment(s, p, u)});
  const Vector3d normal = u.cross(v);
  const double square = normal.squaredNorm();
  const double t = (r - p).cross(v).dot(normal) / square;
  const double w = (r - p).cross(u).dot(normal) / square;
  if (t > 0 && t < 1 && w > 0 && w < 1) {
    least = std::min(least, std::abs(normal.dot(r - p)) / std::sqrt(square));
  }
  return least;
}

// From a corner to the triangle right below it; infinity if there is none.
double above_face(const Vector3d& x, const Vector3d& a, const Vector3d& b,
                  const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a).normalized();
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
    if (normal.dot((to - from).cross(x - from)) < 0) return INFINITY;
  }
  return std::abs(normal.dot(x - a));
}

// The widest gap across a face or along two edges tells whether they are apart;
// then the nearest of all corners, edges and faces are as far.
double of_all_features(const Shape& a, const Shape& b) {
  const auto face_normals = [](const Shape& s) {
    std::vector<Vector3d> normals;
    for (const auto& [i, j, k] : s.faces) {
      normals.push_back(
          (s.points[j] - s.points[i]).cross(s.points[k] - s.points[i]));
    }
    return normals;
  };
  double gap = -1e9;
  const auto try_direction = [&](Vector3d n) {
    if (!(n.norm() > 1e-9)) return;
    n.normalize();
    gap = std::max({gap, -support(b, -n) - support(a, n),
                    -support(a, -n) - support(b, n)});
  };
  for (const Vector3d& n : face_normals(a)) try_direction(n);
  for (const Vector3d& n : face_normals(b)) try_direction(n);
  double least = INFINITY;
  for (const auto& f : a.faces) {
    for (const auto& g : b.faces) {
      for (int i = 0; i < 3; ++i) {
        const Vector3d& p = a.points[f[i]];
        const Vector3d& q = a.points[f[(i + 1) % 3]];
        least = std::min(least, above_face(p, b.points[g[0]], b.points[g[1]],
                                           b.points[g[2]]));
        least = std::min(least, above_face(b.points[g[i]], a.points[f[0]],
                                           a.points[f[1]], a.points[f[2]]));
        for (int j = 0; j < 3; ++j) {
          const Vector3d& r = b.points[g[j]];
          const Vector3d& s = b.points[g[(j + 1) % 3]];
          try_direction((q - p).cross(s - r));
          least = std::min(least, between_edges(p, q, r, s));
        }
      }
    }
  }
  return gap > 0 ? least : gap;
}

TEST(Clearance, PolyhedraAgainstAllTheirFeatures) {
  Draw draw(4);
  double largest = 0;
  for (int i = 0; i < 600; ++i) {
    const Shape a = draw.polyhedron(draw.whole(0, 2), i % 3 > 0);
    const Shape b = draw.polyhedron(draw.whole(0, 2), i % 3 > 0);
    const RelativePlace place = draw.place(i % 3);
    const double want = of_all_features(a, placed(b, place));
    const double found = nearest_of(a, b, place).distance;
    if (want > 1e-9) largest = std::max(largest, std::abs(found - want));
    EXPECT_FALSE(want < -1e-9 && found != 0) << i;
  }
  std::printf("largest error of polyhedra: %.1e m\n", largest);
  EXPECT_LE(largest, 1e-9);  // clearance/nearest.hpp, sizes of some metres
}

// A panel and its mirror image, as far from the plane between them as the
// nearest corner, and turned together.
TEST(Clearance, MirroredPanels) {
  Draw draw(5);
  for (int degrees = -85; degrees <= 85; degrees += 5) {
    const double t = degrees * pi / 180;
    std::vector<Vector3d> points;
    for (const double along : {0., 5.}) {
      for (const double wide : {-0.4, 0.4}) {
        for (const double thick : {0., 0.05}) {
          points.emplace_back(along * std::sin(t) + thick * std::cos(t), wide,
                              along * std::cos(t) - thick * std::sin(t));
        }
      }
    }
    double nearest_x = INFINITY;
    for (const Vector3d& p : points) nearest_x = std::min(nearest_x, p.x());
    std::vector<Vector3d> mirrored;
    for (Vector3d& p : points) {
      p.x() += 0.75 - nearest_x;
      mirrored.emplace_back(-p.x(), p.y(), p.z());
    }
    for (const Matrix3d& turn : {draw.right_angles(), draw.rotation()}) {
      const std::vector<BodyMotion> bodies(2, at_rest({3, -2, 1}, turn));
      const Clearance clearance({{convex_hull(draw.shuffled(points))},
                                 {convex_hull(draw.shuffled(mirrored))}},
                                {{0, 1}});
      EXPECT_NEAR(clearance.distance(0, bodies), 1.5, 1e-9) << degrees;
    }
  }
}

TEST(Clearance, BodiesOfSeveralSolids) {
  const Shape ball{ShapeKind::capsule, {0, 0, 0}, {0, 0, 0}, 0.5};
  Shape far = ball;
  far.move(Vector3d(3, 0, 0));
  std::vector<BodyMotion> bodies(
      3, at_rest(Vector3d::Zero(), Matrix3d::Identity()));
  bodies[1].position = Vector3d(5, 0, 0);
  bodies[2].position = Vector3d(0.4, 0, 0);
  const Clearance clearance({{ball, far}, {ball}, {ball}}, {{0, 1}, {0, 2}});
  EXPECT_NEAR(clearance.distance(0, bodies), 1, 1e-14);
  EXPECT_EQ(clearance.distance(1, bodies), 0);
  EXPECT_FALSE(clearance.nearest_points(bodies, 1));
}

// Numbers that are none, or so large that squares overflow, give no distance.
TEST(Clearance, WhatCannotBeCertifiedIsNaN) {
  const Shape cube =
      box(Vector3d::Zero(), Vector3d::Ones(), Matrix3d::Identity());
  const Clearance clearance({{cube}, {cube}}, {{0, 1}});
  for (const double x : {1e80, 1e160, 1e308, double(INFINITY), double(NAN)}) {
    const std::vector<BodyMotion> bodies = {
        at_rest(Vector3d::Zero(), Matrix3d::Identity()),
        at_rest({x, 0, 0}, Matrix3d::Identity())};
    EXPECT_TRUE(std::isnan(clearance.distance(0, bodies))) << x;
  }
  const std::vector<BodyMotion> turned = {
      at_rest(Vector3d::Zero(), Matrix3d::Identity()),
      at_rest({3, 0, 0}, Matrix3d::Constant(NAN))};
  EXPECT_TRUE(std::isnan(clearance.distance(0, turned)));
}

// The halves of a fairing, whose faces become parallel, at every row; their
// distance never jumps.
TEST(Clearance, OfAFairingIsContinuous) {
  const separation::Case c = separation::read_case(
      CONTACT_SOURCE_DIR "/tests/separation/fairing.toml");
  const separation::Outcome outcome = separation::run_case(c);
  const separation::Rows& rows = outcome.memory.rows;
  const std::size_t distance = rows.column("clearance.half_1.half_2_m");
  const auto half = [&](std::size_t row, const std::string& name) {
    const auto at = [&](const char* quantity) {
      return rows.at(row, rows.column(name + quantity));
    };
    const int body = name == "half_1" ? 1 : 2;
    return placed(
        c.rigid_body(body).shapes[0],
        {Eigen::Quaterniond(at(".qw"), at(".qx"), at(".qy"), at(".qz"))
             .toRotationMatrix(),
         Vector3d(at(".x_m"), at(".y_m"), at(".z_m"))});
  };
  double fastest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows.at(i, distance),
                of_all_features(half(i, "half_1"), half(i, "half_2")), 1e-9)
        << rows.at(i, 0);
    const double time = i == 0 ? 0 : rows.at(i, 0) - rows.at(i - 1, 0);
    if (!(time > 0)) continue;
    fastest = std::max(
        fastest,
        std::abs(rows.at(i, distance) - rows.at(i - 1, distance)) / time);
  }
  // Both tips separate with 4.4 m/s each when the hinges are released.
  EXPECT_LT(fastest, 9);
}

// A run without a distance that it was to have fails there.
TEST(Clearance, RunsFailWithoutADistance) {
  const auto failure = [](const std::string& position) {
    const separation::Case c = separation::parse_case(R"(
name = "two cubes"; run = { end_time_s = 1, output_step_s = 0.5 }
carrier = { name = "ground", fixed = true, shape = [{ kind = "box", size_m = [1, 1, 1] }] }
[[body]]; name = "cube"; mass_kg = 1
start = { position_m = )"_toml + position + R"( }
shape = [{ kind = "box", size_m = [1, 1, 1] }]
)",
                                                      "cubes.toml");
    separation::Run run(c);
    run.advance_to(1);
    const bool failed = run.status() == separation::Run::Status::failed;
    EXPECT_EQ(failed, !run.message().empty());
    return failed ? run.message()
                  : std::to_string(run.memory().pairs[0].smallest);
  };
  EXPECT_EQ(failure("[2, 0, 1]"), "1.000000");
  EXPECT_EQ(failure("[3, 0, 1]"), "2.000000");
  EXPECT_EQ(failure("[1e160, 0, 0]"),
            "t = 0 s: the distance of ground and cube could not be certified");
}

// From a distance that is known, wherever the bodies have moved since; and of
// none between two distances.
// A rod that turns in its place brings its end nearer.
TEST(PairWay, TurnsAreWaysToo) {
  const Shape rod{.kind = ShapeKind::capsule,
                  .from = {-0.3, 0.1, 0},
                  .to = {0.8, 0, 0.2},
                  .radius = 0.1};
  Clearance clearance({{rod}, {rod}}, {{0, 1}});
  separation::PairWay way({0, 1}, separation::reach(rod));
  const BodyMotion still{Vector3d::Zero(), Vector3d::Zero(),
                         Matrix3d::Identity(), Vector3d::Zero()};
  std::vector<BodyMotion> bodies = {still, still};
  bodies[1].position = Vector3d(2.5, 0, 0);
  way.move_on(0, bodies);
  const double first = clearance.distance(0, bodies);
  way.know(first);
  for (const double angle : {0.1, 0.5, 1.5, 2.0, 3.0}) {
    bodies[1].rotation =
        Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    way.move_on(angle, bodies);
    // As in the next test.
    EXPECT_LE(way.least_now(), clearance.distance(0, bodies) + 2e-8) << angle;
  }
  EXPECT_LT(clearance.distance(0, bodies), first - 0.3);
}

TEST(PairWay, IsNeverAboveTheDistance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    return Vector3d(uniform(random), uniform(random), uniform(random));
  };
  const Shape rod{.kind = ShapeKind::capsule,
                  .from = {-0.3, 0.1, 0},
                  .to = {0.8, 0, 0.2},
                  .radius = 0.1};
  Clearance clearance({{rod}, {rod}}, {{0, 1}});
  for (int trial = 0; trial < 300; ++trial) {
    separation::PairWay way({0, 1}, separation::reach(rod));
    std::vector<BodyMotion> bodies;
    for (int i = 0; i < 2; ++i) {
      bodies.push_back({vector() + Vector3d(3. * i, 0, 0), vector(),
                        Matrix3d::Identity(), vector()});
    }
    // Both fly and turn at constant rates: their speeds do not change.
    const double step = 0.3;
    way.move_on(0, bodies);
    way.know(clearance.distance(0, bodies));
    double least = 1e9;
    constexpr int parts = 20;
    const auto start = bodies;
    for (int part = 1; part <= parts; ++part) {
      const double t = step * part / parts;
      for (int i = 0; i < 2; ++i) {
        const Vector3d& w = start[i].angular_velocity;
        bodies[i].position = start[i].position + t * start[i].velocity;
        bodies[i].rotation =
            Eigen::AngleAxisd(t * w.norm(), w.normalized()) * start[i].rotation;
      }
      least = std::min(least, clearance.distance(0, bodies));
    }
    way.move_on(step, bodies);
    const double now = clearance.distance(0, bodies);
    // Accuracy of the distances, by clearance/nearest.hpp.
    constexpr double accuracy = 2e-8;
    EXPECT_LE(way.least_now(), now + accuracy);
    way.know(now);
    EXPECT_EQ(way.least_now(), now);
    EXPECT_LE(way.least_since(), least + accuracy);
  }
}

BodyMotion moved(const BodyMotion& start, double time) {
  BodyMotion now = start;
  const Vector3d turn = time * start.angular_velocity;
  now.position += time * start.velocity;
  now.rotation =
      Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * start.rotation;
  return now;
}

// Arms that turn by half a turn and more pass the other body between two
// evaluations that do not show it: in the axes of a rotating body the other one
// moves.
TEST(Clearance, BoundsKnowWhatTurnsBetweenTwoLooks) {
  const auto capsule = [](const Vector3d& to) {
    return Shape{.kind = ShapeKind::capsule,
                 .from = Vector3d::Zero(),
                 .to = to,
                 .radius = 0.1};
  };
  const Shape arm = capsule({1, 0, 0});
  const Shape ball = capsule({0, 0, 0});
  const BodyMotion still{Vector3d::Zero(), Vector3d::Zero(),
                         Matrix3d::Identity(), Vector3d::Zero()};
  struct Pass {
    Shape a, b;
    double place;  // place of b, m
    double turn_of_a, turn_of_b;
  };
  for (const Pass& pass : {Pass{ball, arm, 1.5, 0, 2 * pi},
                           {arm, ball, -1.5, 2 * pi, 0},
                           {arm, ball, -1.5, 3 * pi, 0}}) {
    BodyMotion a = still;
    BodyMotion b = still;
    b.position.x() = pass.place;
    a.angular_velocity.z() = pass.turn_of_a;
    b.angular_velocity.z() = pass.turn_of_b;
    // Another solid of each is far away.
    const auto far = [](Shape shape, double z) {
      shape.from.z() = shape.to.z() = z;
      return shape;
    };
    const Clearance clearance(
        {{pass.a, far(pass.a, -20)}, {far(pass.b, 20), pass.b}}, {{0, 1}});
    std::vector<std::vector<double>> distance(clearance.solid_pairs(0));
    separation::PairWay way({0, 1}, separation::reach(pass.b));
    double least = 1e9;
    for (int i = 0; i <= 40; ++i) {
      const std::vector<BodyMotion> bodies = {moved(a, i / 40.),
                                              moved(b, i / 40.)};
      double nearest = 1e9;
      for (std::size_t k = 0; k < distance.size(); ++k) {
        distance[k].push_back(
            clearance.look(0, k, i / 40., bodies[0], bodies[1]).distance);
        nearest = std::min(nearest, distance[k].back());
      }
      EXPECT_EQ(nearest, clearance.distance(0, bodies));
      least = std::min(least, nearest);
      if (i % 40 > 0) continue;
      way.move_on(i / 40, bodies);
      way.know(nearest);
    }
    EXPECT_NEAR(least, 0.3, 0.01);
    EXPECT_LE(way.least_since(), least);
    for (std::size_t k = 0; k < distance.size(); ++k) {
      EXPECT_LE(separation::least_between(
                    clearance.look(0, k, 0, a, b),
                    clearance.look(0, k, 1, moved(a, 1), moved(b, 1))),
                *std::ranges::min_element(distance[k]))
          << k;
    }
  }
}

// Random solids on random ways, of which every second body turns about a fixed
// point. Planes and points agree to 1e-8 of the size, here up to 20 m.
TEST(Clearance, BoundsHoldBetweenTwoLooks) {
  constexpr int cases = 3000;
  Draw draw(61);
  int apart = 0, useful = 0;
  for (int n = 0; n < cases; ++n) {
    const Clearance clearance({{draw.solid(false)}, {draw.solid(false)}},
                              {{0, 1}});
    const double step = std::pow(10, draw.number(-3, 0));
    std::array<BodyMotion, 2> start;
    std::array<Vector3d, 2> accelerations, pivots;
    for (int i = 0; i < 2; ++i) {
      start[i] = {draw.vector(4), draw.vector(1), draw.rotation(),
                  draw.vector(2)};
      accelerations[i] = draw.vector(1);
      pivots[i] = draw.vector(3);
    }
    const auto at = [&](int i, double time) {
      BodyMotion now = moved(start[i], time);
      if (n % 2 == i) {
        const Vector3d arm =
            now.rotation * (start[i].rotation.transpose() * pivots[i]);
        now.position = start[i].position + pivots[i] - arm;
        now.velocity = -now.angular_velocity.cross(arm);
      } else {
        now.position += time * time / 2 * accelerations[i];
        now.velocity += time * accelerations[i];
      }
      return now;
    };
    const auto look = [&](double time) {
      return clearance.look(0, 0, time, at(0, time), at(1, time));
    };
    const auto from = look(0), to = look(step);
    if (!(from.distance > 0)) continue;
    const double bound = separation::least_between(from, to);
    constexpr double accuracy = 2e-7;
    constexpr int parts = 20;
    double least = from.distance;
    for (int part = 0; part <= parts; ++part) {
      least = std::min(least, look(step * part / parts).distance);
    }
    EXPECT_LE(bound, least + accuracy) << n << ' ' << step;
    ++apart;
    useful += bound > least - 0.01 * step;
  }
  EXPECT_GT(apart, cases / 2);
  EXPECT_GT(useful, 0.35 * apart);  // 0.39
}

// A capsule that turns about the end of its axis keeps its distance of a plate
// below this end. The Lipschitz bound loses h w l, and a bound by the largest
// acceleration h^2 w^2 l/8 = 1.3e-4 m.
TEST(Clearance, BoundsKnowThatAHingeStays) {
  const Clearance clearance({{box({0, 0, -1}, {4, 4, 1}, Matrix3d::Identity())},
                             {{.kind = ShapeKind::capsule,
                               .from = {0, 0, 0},
                               .to = {0, 0, 10},
                               .radius = 0.1}}},
                            {{0, 1}});
  constexpr double h = 0.02, w = 0.5, tilt = 0.3;
  const auto look = [&](double time) {
    const BodyMotion still{Vector3d::Zero(), Vector3d::Zero(),
                           Matrix3d::Identity(), Vector3d::Zero()};
    BodyMotion b = still;
    b.rotation = Eigen::AngleAxisd(tilt + w * time, Vector3d::UnitX());
    b.angular_velocity.x() = w;
    return clearance.look(0, 0, time, still, b);
  };
  const auto from = look(0), to = look(h);
  EXPECT_EQ(from.distance, to.distance);
  // What is left is of third order, h^3 w^3 l/8, and of the end's surface,
  // which turns: h^2 w^2/4 times its radius.
  EXPECT_NEAR(separation::least_between(from, to), from.distance, 4e-6);
}

}  // namespace
}  // namespace contact::test::clearance_test
