#include "separation/clearance/clearance.hpp"

#include <fcl/fcl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "separation/case/turn_of_z.hpp"

namespace separation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using multibody::BodyMotion;

// FCL's solids lie along z about their middle (cone: half way up); a hull's
// corners are in body axes.
Isometry3d placed(const Shape& shape) {
  Isometry3d place = Isometry3d::Identity();
  if (shape.kind == ShapeKind::hull) return place;
  const Vector3d span = shape.to - shape.from;
  place.translation() = shape.from + span / 2;
  if (span.norm() > 0) {
    place.linear() = turn_of_z(span);
  }
  return place;
}

std::shared_ptr<fcl::CollisionGeometryd> geometry(const Shape& shape) {
  const double length = (shape.to - shape.from).norm();
  switch (shape.kind) {
    case ShapeKind::capsule:
      return std::make_shared<fcl::Capsuled>(shape.radius, length);
    case ShapeKind::cylinder:
      return std::make_shared<fcl::Cylinderd>(shape.radius, length);
    case ShapeKind::cone:
      return std::make_shared<fcl::Coned>(shape.radius, length);
    case ShapeKind::hull:
      break;
  }
  auto corners = std::make_shared<std::vector<Vector3d>>(shape.points);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& [i, j, k] : shape.faces) {
    faces->insert(faces->end(), {3, i, j, k});
  }
  return std::make_shared<fcl::Convexd>(
      corners, static_cast<int>(shape.faces.size()), faces);
}

Isometry3d place_of(const BodyMotion& body) {
  Isometry3d place = Isometry3d::Identity();
  place.linear() = body.rotation;
  place.translation() = body.position;
  return place;
}

// FCL gives -1 for solids that overlap.
double distance_of(const fcl::CollisionObjectd& a,
                   const fcl::CollisionObjectd& b, bool points,
                   fcl::DistanceResultd& result) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = points;
  request.distance_tolerance = 1e-9;
  try {
    return std::max(0.0, fcl::distance(&a, &b, request, result));
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

struct Clearance::Solids {
  struct Solid {
    Isometry3d place;  // in body axes
    fcl::CollisionObjectd object;
  };
  std::vector<std::vector<Solid>> of_body;
};

Clearance::Clearance(const std::vector<std::vector<Shape>>& shapes,
                     std::vector<Pair> pairs)
    : solids_(std::make_unique<Solids>()), pairs_(std::move(pairs)) {
  for (const auto& body : shapes) {
    auto& solids = solids_->of_body.emplace_back();
    for (const Shape& shape : body) {
      solids.push_back({placed(shape), fcl::CollisionObjectd(geometry(shape))});
    }
  }
}

Clearance::~Clearance() = default;
Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;

// Relative to the first body: far from the origin digits would be lost.
void Clearance::place(const Pair& pair, std::span<const BodyMotion> bodies) {
  for (const int i : {pair.a, pair.b}) {
    Isometry3d body = place_of(bodies[i]);
    body.translation() -= bodies.front().position;
    for (Solids::Solid& solid : solids_->of_body[i]) {
      solid.object.setTransform(body * solid.place);
      solid.object.computeAABB();
    }
  }
}

// Of the solids of a pair of bodies.
struct Clearance::Nearest {
  double distance = std::numeric_limits<double>::infinity();
  const fcl::CollisionObjectd* a = nullptr;
  const fcl::CollisionObjectd* b = nullptr;
};

Clearance::Nearest Clearance::nearest(const Pair& pair) const {
  Nearest nearest;
  for (const Solids::Solid& a : solids_->of_body[pair.a]) {
    for (const Solids::Solid& b : solids_->of_body[pair.b]) {
      // Their boxes are as far from each other, or nearer.
      if (a.object.getAABB().distance(b.object.getAABB()) > nearest.distance) {
        continue;
      }
      fcl::DistanceResultd result;
      const double d = distance_of(a.object, b.object, false, result);
      if (std::isnan(nearest.distance)) continue;
      if (std::isnan(d) || d < nearest.distance) {
        nearest = {d, &a.object, &b.object};
      }
    }
  }
  return nearest;
}

double Clearance::distance(std::size_t pair,
                           std::span<const BodyMotion> bodies) {
  place(pairs_[pair], bodies);
  return nearest(pairs_[pair]).distance;
}

std::vector<double> Clearance::distances(std::span<const BodyMotion> bodies) {
  std::vector<double> result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    result.push_back(distance(i, bodies));
  }
  return result;
}

std::optional<std::pair<Vector3d, Vector3d>> Clearance::nearest_points(
    std::span<const BodyMotion> bodies, std::size_t pair) {
  place(pairs_[pair], bodies);
  const Nearest solids = nearest(pairs_[pair]);
  if (!(solids.distance > 0) || solids.a == nullptr) return {};
  fcl::DistanceResultd result;
  distance_of(*solids.a, *solids.b, true, result);
  const Vector3d& origin = bodies.front().position;
  return std::pair<Vector3d, Vector3d>{result.nearest_points[0] + origin,
                                       result.nearest_points[1] + origin};
}

}  // namespace separation
