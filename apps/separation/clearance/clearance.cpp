#include "separation/clearance/clearance.hpp"

#include <cmath>
#include <limits>
#include <numeric>

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
  for (Pair& pair : pairs_) {
    for (auto [body, of] : {std::pair{pair.a, &pair.a_shapes},
                            std::pair{pair.b, &pair.b_shapes}}) {
      if (!of->empty()) continue;
      of->resize(solids_[body].size());
      std::iota(of->begin(), of->end(), 0);
    }
  }
}

namespace {

RelativePlace place_in(const BodyMotion& a, const BodyMotion& b) {
  return {a.rotation.transpose() * b.rotation,
          a.rotation.transpose() * (b.position - a.position)};
}

}  // namespace

std::size_t Clearance::solid_pairs(std::size_t pair) const {
  return pairs_[pair].a_shapes.size() * pairs_[pair].b_shapes.size();
}

Clearance::SolidLook Clearance::look(std::size_t pair, std::size_t solids,
                                     double time, const BodyMotion& a,
                                     const BodyMotion& b) const {
  const Pair& of = pairs_[pair];
  const std::size_t count = of.b_shapes.size();
  const Solid& solid_a = solids_[of.a][of.a_shapes[solids / count]];
  const Solid& solid_b = solids_[of.b][of.b_shapes[solids % count]];
  const RelativePlace place = place_in(a, b);
  const Nearest found =
      nearest(solid_a, solid_b, place, std::numeric_limits<double>::infinity());
  const Vector3d apart = b.position - a.position;
  return {time,
          found.distance,
          a.rotation.transpose() *
              (b.velocity - a.velocity - a.angular_velocity.cross(apart)),
          a.rotation.transpose() * (b.angular_velocity - a.angular_velocity),
          &solid_b,
          place,
          found.normal};
}

Nearest Clearance::nearest_of(const Pair& pair,
                              std::span<const BodyMotion> bodies) const {
  const BodyMotion& a = bodies[pair.a];
  const BodyMotion& b = bodies[pair.b];
  const RelativePlace b_in_a = place_in(a, b);
  Nearest best{std::numeric_limits<double>::infinity()};
  for (const int of_a : pair.a_shapes) {
    for (const int of_b : pair.b_shapes) {
      const Nearest found = nearest(
          solids_[pair.a][of_a], solids_[pair.b][of_b], b_in_a, best.distance);
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
