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
                   const fcl::CollisionObjectd& b) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = false;
  request.distance_tolerance = 1e-9;
  fcl::DistanceResultd result;
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

void Clearance::place(int body, const BodyMotion& motion,
                      const Vector3d& origin) {
  Isometry3d place = place_of(motion);
  place.translation() -= origin;
  for (Solids::Solid& solid : solids_->of_body[body]) {
    solid.object.setTransform(place * solid.place);
    solid.object.computeAABB();
  }
}

double Clearance::distance(std::size_t pair,
                           std::span<const BodyMotion> bodies) {
  const auto [a_body, b_body] = pairs_[pair];
  // Relative to the first body: far from the origin digits would be lost.
  const Vector3d origin = bodies.front().position;
  for (const int body : {a_body, b_body}) place(body, bodies[body], origin);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Solids::Solid& a : solids_->of_body[a_body]) {
    for (const Solids::Solid& b : solids_->of_body[b_body]) {
      // Their boxes are as far from each other, or nearer.
      if (a.object.getAABB().distance(b.object.getAABB()) > smallest) {
        continue;
      }
      const double d = distance_of(a.object, b.object);
      if (std::isnan(smallest)) continue;
      smallest = std::isnan(d) ? d : std::min(smallest, d);
    }
  }
  return smallest;
}

std::vector<double> Clearance::distances(std::span<const BodyMotion> bodies) {
  std::vector<double> result;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    result.push_back(distance(i, bodies));
  }
  return result;
}

}  // namespace separation
