#include "separation/case/shape.hpp"

#include <Eigen/Geometry>
#include <numbers>

namespace separation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Inertia about another point: from about the centroid, `by` away.
Matrix3d parallel_axes(double mass, const Vector3d& by) {
  return mass * (by.squaredNorm() * Matrix3d::Identity() - by * by.transpose());
}

// A solid of revolution about the line from `from` along `axis`.
SolidProperties revolved(double volume, double centroid, double axial,
                         double transverse, const Vector3d& from,
                         const Vector3d& axis) {
  const Matrix3d along = axis * axis.transpose();
  return {volume, from + centroid * axis,
          axial * along + transverse * (Matrix3d::Identity() - along)};
}

SolidProperties cylinder(const Shape& s) {
  const Vector3d span = s.to - s.from;
  const double l = span.norm();
  const double r2 = s.radius * s.radius;
  const double v = std::numbers::pi * r2 * l;
  return revolved(v, l / 2, v * r2 / 2, v * (r2 / 4 + l * l / 12), s.from,
                  span / l);
}

SolidProperties cone(const Shape& s) {
  const Vector3d span = s.to - s.from;
  const double h = span.norm();
  const double r2 = s.radius * s.radius;
  const double v = std::numbers::pi * r2 * h / 3;
  return revolved(v, h / 4, 0.3 * v * r2, v * (0.15 * r2 + 0.0375 * h * h),
                  s.from, span / h);
}

SolidProperties capsule(const Shape& s) {
  const Vector3d span = s.to - s.from;
  const double l = span.norm();
  const double r = s.radius;
  const double r2 = r * r;
  const double middle = std::numbers::pi * r2 * l;
  const double ball = 4 * std::numbers::pi * r2 * r / 3;  // both ends together
  // A half ball's centroid is 3 r/8 from its flat side; (83/320) m r^2 about
  // it across the axis.
  const double arm = l / 2 + 3 * r / 8;
  const double axial = middle * r2 / 2 + 0.4 * ball * r2;
  const double transverse =
      middle * (r2 / 4 + l * l / 12) + ball * (83.0 / 320 * r2 + arm * arm);
  const Vector3d axis = l > 0 ? Vector3d(span / l) : Vector3d::UnitZ();
  return revolved(middle + ball, l / 2, axial, transverse, s.from, axis);
}

// Sum over the tetrahedra between a corner and the faces.
SolidProperties hull(const Shape& s) {
  const Vector3d origin = s.points.front();
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();  // ∫ r r^T
  for (const auto& face : s.faces) {
    const Vector3d a = s.points[face[0]] - origin;
    const Vector3d b = s.points[face[1]] - origin;
    const Vector3d c = s.points[face[2]] - origin;
    const double v = a.dot(b.cross(c)) / 6;
    const Vector3d sum = a + b + c;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() +
               sum * sum.transpose());
  }
  const Vector3d centroid = first / volume;
  second -= volume * centroid * centroid.transpose();
  return {volume, origin + centroid,
          second.trace() * Matrix3d::Identity() - second};
}

}  // namespace

double reach(const Shape& shape) {
  double ends = std::max(shape.from.norm(), shape.to.norm());
  for (const Eigen::Vector3d& point : shape.points) {
    ends = std::max(ends, point.norm());
  }
  return ends + shape.radius;
}

double reach(const std::vector<Shape>& shapes) {
  double farthest = 0;
  for (const Shape& shape : shapes) farthest = std::max(farthest, reach(shape));
  return farthest;
}

Shape box(const Vector3d& centre, const Vector3d& size,
          const Matrix3d& rotation) {
  Shape shape{ShapeKind::hull};
  // The bits of a corner's number say at which end of each edge it is.
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d place = size / 2;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) place[axis] *= -1;
    }
    shape.points.push_back(centre + rotation * place);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int right = 1 << (axis + 1) % 3;
    const int up = 1 << (axis + 2) % 3;
    const int far = 1 << axis;
    shape.faces.push_back({far, far + right, far + right + up});
    shape.faces.push_back({far, far + right + up, far + up});
    shape.faces.push_back({0, up, right + up});
    shape.faces.push_back({0, right + up, right});
  }
  return shape;
}

void Shape::move(const Vector3d& by) {
  from += by;
  to += by;
  for (Vector3d& point : points) point += by;
}

SolidProperties solid_properties(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::capsule:
      return capsule(shape);
    case ShapeKind::cylinder:
      return cylinder(shape);
    case ShapeKind::cone:
      return cone(shape);
    case ShapeKind::hull:
      break;
  }
  return hull(shape);
}

SolidProperties solid_properties(const std::vector<Shape>& shapes) {
  SolidProperties all{0, Vector3d::Zero(), Matrix3d::Zero()};
  std::vector<SolidProperties> parts;
  for (const Shape& shape : shapes) {
    parts.push_back(solid_properties(shape));
    all.volume += parts.back().volume;
    all.centroid += parts.back().volume * parts.back().centroid;
  }
  all.centroid /= all.volume;
  for (const SolidProperties& part : parts) {
    all.inertia +=
        part.inertia + parallel_axes(part.volume, part.centroid - all.centroid);
  }
  return all;
}

}  // namespace separation
