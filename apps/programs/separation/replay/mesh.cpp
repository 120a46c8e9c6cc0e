#include "programs/separation/replay/mesh.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "libcontact/base/linear/turn.hpp"

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int sides = 40;

// A point of the line that is turned about z, and its normal.
struct Point {
  double radius, height;
  double normal_radius, normal_height;
};

// The surface between points of growing height; edges need a new strip.
class Lathe {
 public:
  Lathe(Mesh& mesh, const Vector3d& from, const Vector3d& span)
      : mesh_(mesh),
        from_(from),
        turn_(span.norm() > 0 ? contact::detail::turn_of_z(span)
                              : Matrix3d::Identity()) {}

  void add(const std::vector<Point>& strip) const {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    constexpr std::uint32_t row = sides + 1;
    for (const Point& p : strip) {
      for (int i = 0; i <= sides; ++i) {
        const double t = 2 * std::numbers::pi * i / sides;
        const auto place = [&](double r, double h) {
          return Vector3d(turn_ *
                          Vector3d(r * std::cos(t), r * std::sin(t), h));
        };
        mesh_.positions.emplace_back(
            (from_ + place(p.radius, p.height)).cast<float>());
        mesh_.normals.emplace_back(
            place(p.normal_radius, p.normal_height).cast<float>());
      }
    }
    for (std::uint32_t j = 0; j + 1 < strip.size(); ++j) {
      for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = first + j * row + i;
        for (const std::uint32_t k :
             {a, a + 1, a + row + 1, a, a + row + 1, a + row}) {
          mesh_.corners.push_back(k);
        }
      }
    }
  }

 private:
  Mesh& mesh_;
  Vector3d from_;
  Matrix3d turn_;
};

void add_cylinder(Mesh& mesh, const Shape& s) {
  const double l = (s.to - s.from).norm();
  const double r = s.radius;
  const Lathe lathe(mesh, s.from, s.to - s.from);
  lathe.add({{0, 0, 0, -1}, {r, 0, 0, -1}});
  lathe.add({{r, 0, 1, 0}, {r, l, 1, 0}});
  lathe.add({{r, l, 0, 1}, {0, l, 0, 1}});
}

void add_cone(Mesh& mesh, const Shape& s) {
  const double h = (s.to - s.from).norm();
  const double r = s.radius;
  const double slope = std::hypot(r, h);
  const Lathe lathe(mesh, s.from, s.to - s.from);
  lathe.add({{0, 0, 0, -1}, {r, 0, 0, -1}});
  lathe.add({{r, 0, h / slope, r / slope}, {0, h, h / slope, r / slope}});
}

void add_capsule(Mesh& mesh, const Shape& s) {
  const double l = (s.to - s.from).norm();
  const Lathe lathe(mesh, s.from, s.to - s.from);
  std::vector<Point> strip;
  constexpr int quarter = sides / 4;
  const auto add_ring = [&](double height, int i) {
    const double t = std::numbers::pi / 2 * i / quarter;
    strip.push_back({s.radius * std::cos(t), height + s.radius * std::sin(t),
                     std::cos(t), std::sin(t)});
  };
  for (int i = -quarter; i <= 0; ++i) add_ring(0, i);
  for (int i = 0; i <= quarter; ++i) add_ring(l, i);
  lathe.add(strip);
}

void add_hull(Mesh& mesh, const Shape& s) {
  for (const auto& face : s.faces) {
    const Vector3d& a = s.points[face[0]];
    const Vector3d normal =
        (s.points[face[1]] - a).cross(s.points[face[2]] - a).normalized();
    for (const int k : face) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.emplace_back(s.points[k].cast<float>());
      mesh.normals.emplace_back(normal.cast<float>());
    }
  }
}

}  // namespace

void Mesh::add(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::capsule:
      return add_capsule(*this, shape);
    case ShapeKind::cylinder:
      return add_cylinder(*this, shape);
    case ShapeKind::cone:
      return add_cone(*this, shape);
    case ShapeKind::hull:
      return add_hull(*this, shape);
  }
}

Mesh cross_mesh(double length) {
  Mesh mesh;
  for (const Vector3d axis :
       {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}) {
    const Vector3d end = length / 2 * axis;
    mesh.add({.kind = ShapeKind::cylinder,
              .from = -end,
              .to = end,
              .radius = length / 40});
  }
  return mesh;
}

}  // namespace separation
