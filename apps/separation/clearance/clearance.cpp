#include "separation/clearance/clearance.hpp"

#include <cmath>
#include <limits>

#include "separation/clearance/nearest.hpp"

namespace separation {

using Eigen::Vector3d;
using multibody::BodyMotion;

Clearance::Clearance(const std::vector<std::vector<Shape>>& shapes,
                     std::vector<Pair> pairs)
    : pairs_(std::move(pairs)) {
  for (const auto& body : shapes) {
    solids_.emplace_back(body.begin(), body.end());
  }
}

Nearest Clearance::nearest_of(const Pair& pair,
                              std::span<const BodyMotion> bodies) const {
  const BodyMotion& a = bodies[pair.a];
  const BodyMotion& b = bodies[pair.b];
  const RelativePlace b_in_a = {
      a.rotation.transpose() * b.rotation,
      a.rotation.transpose() * (b.position - a.position)};
  Nearest best{std::numeric_limits<double>::infinity()};
  for (const Solid& of_a : solids_[pair.a]) {
    for (const Solid& of_b : solids_[pair.b]) {
      const Nearest found = nearest(of_a, of_b, b_in_a, best.distance);
      if (std::isnan(found.distance)) return found;
      if (found.distance < best.distance) best = found;
    }
  }
  return best;
}

double Clearance::distance(std::size_t pair,
                           std::span<const BodyMotion> bodies) const {
  return nearest_of(pairs_[pair], bodies).distance;
}

std::optional<std::pair<Vector3d, Vector3d>> Clearance::nearest_points(
    std::span<const BodyMotion> bodies, std::size_t pair) const {
  const Nearest found = nearest_of(pairs_[pair], bodies);
  if (!(found.distance > 0)) return {};
  const BodyMotion& a = bodies[pairs_[pair].a];
  return std::pair<Vector3d, Vector3d>{a.position + a.rotation * found.on_a,
                                       a.position + a.rotation * found.on_b};
}

}  // namespace separation
