#include "separation/clearance/nearest.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <initializer_list>

#include "libcontact/base/constants.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;

using contact::detail::infinity;
using contact::detail::nan;

// Shares of the size. The search goes on until points and planes agree to
// `wanted`, which costs two iterations more than 1e-7 would; rounding may stop
// it earlier where directions are noise of the root of a double's, and at
// `required` it must have arrived. Coordinates have rounding errors of some
// 1e-16.
constexpr double wanted = 1e-10;
constexpr double required = 1e-7;
constexpr double rounding = 1e-14;

// Limit beyond which the squares of areas would overflow, m.
constexpr double largest_size = 1e70;

// Near its end the points come no nearer in doubles while the planes still do.
constexpr int patience = 4;
constexpr int most_iterations = 1000;

// A point of the difference of the cores, which is the set of all a - b, and
// the a that it is made of.
struct Corner {
  Vector3d difference;
  Vector3d on_a;
};

// Some corners with weights whose sum is 1: a point of the difference.
class Simplex {
 public:
  Vector3d point() const { return mean(&Corner::difference); }
  Vector3d on_a() const { return mean(&Corner::on_a); }

  /// Adds a corner and keeps only those corners which the point of their hull
  /// that is nearest to 0 needs. The new corner is always one of them; but for
  /// rounding the point comes nearer then.
  void add(const Corner& corner);
  bool is_empty() const { return count_ == 0; }
  /// Four corners are around 0.
  bool is_full() const { return count_ == 4; }

 private:
  Vector3d mean(Vector3d Corner::*of) const {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < count_; ++i) sum += weights_[i] * (corners_[i].*of);
    return sum;
  }
  void offer(std::initializer_list<int> corners,
             std::initializer_list<double> weights, Simplex& best) const;
  void offer_edges(Simplex& best) const;
  void offer_faces(Simplex& best) const;
  void offer_inside(Simplex& best) const;

  std::array<Corner, 4> corners_;
  std::array<double, 4> weights_{};
  int count_ = 0;
  double square_ = infinity;  // squared distance of the point
};

// The last corner with these: better if all weights are positive and the point
// is nearer.
void Simplex::offer(std::initializer_list<int> corners,
                    std::initializer_list<double> weights,
                    Simplex& best) const {
  Simplex part;
  double rest = 1;
  const double* weight = weights.begin();
  for (const int i : corners) {
    if (!(*weight > 0)) return;
    rest -= *weight;
    part.corners_[part.count_] = corners_[i];
    part.weights_[part.count_++] = *weight++;
  }
  if (!(rest > 0)) return;
  part.corners_[part.count_] = corners_[count_ - 1];
  part.weights_[part.count_++] = rest;
  part.square_ = part.point().squaredNorm();
  if (part.square_ < best.square_) best = part;
}

void Simplex::offer_edges(Simplex& best) const {
  const Vector3d& last = corners_[count_ - 1].difference;
  for (int i = 0; i + 1 < count_; ++i) {
    const Vector3d edge = corners_[i].difference - last;
    offer({i}, {-last.dot(edge) / edge.squaredNorm()}, best);
  }
}

void Simplex::offer_faces(Simplex& best) const {
  const Vector3d& last = corners_[count_ - 1].difference;
  for (int i = 0; i + 1 < count_; ++i) {
    for (int j = i + 1; j + 1 < count_; ++j) {
      const Vector3d e = corners_[i].difference - last;
      const Vector3d f = corners_[j].difference - last;
      const Vector3d normal = e.cross(f);
      const double square = normal.squaredNorm();
      offer({i, j},
            {f.cross(last).dot(normal) / square,
             last.cross(e).dot(normal) / square},
            best);
    }
  }
}

// All four, around 0.
void Simplex::offer_inside(Simplex& best) const {
  const Vector3d& last = corners_[3].difference;
  const Vector3d e = corners_[0].difference - last;
  const Vector3d f = corners_[1].difference - last;
  const Vector3d g = corners_[2].difference - last;
  const double volume = e.dot(f.cross(g));
  offer({0, 1, 2},
        {-last.dot(f.cross(g)) / volume, -last.dot(g.cross(e)) / volume,
         -last.dot(e.cross(f)) / volume},
        best);
}

void Simplex::add(const Corner& corner) {
  corners_[count_++] = corner;
  Simplex best;
  offer({}, {}, best);
  offer_edges(best);
  offer_faces(best);
  if (count_ == 4) offer_inside(best);
  *this = best;
}

// The corner of the difference that is farthest against a direction.
Corner farthest_against(const Vector3d& direction, const Solid& a,
                        const Solid& b, const RelativePlace& place) {
  const Vector3d on_a = a.farthest(-direction);
  const Vector3d on_b =
      place.rotation * b.farthest(place.rotation.transpose() * direction) +
      place.position;
  return {on_a - on_b, on_a};
}

}  // namespace

Nearest nearest(const Solid& a, const Solid& b, const RelativePlace& b_in_a,
                double limit) {
  const double margin = a.margin() + b.margin();
  const double size = b_in_a.position.norm() + a.reach() + b.reach();
  if (!(size < largest_size)) return {nan};
  const double touching = margin + rounding * size;
  // Distances of the cores: the planes are so far apart, two points so near.
  double planes = 0;
  double points = infinity;
  Vector3d normal = Vector3d::Zero();
  Simplex simplex;
  Simplex best;
  Vector3d direction = -b_in_a.position;
  if (direction.isZero()) direction = Vector3d::UnitX();
  for (int i = 0, idle = 0; i < most_iterations && idle < patience; ++i) {
    const Corner corner = farthest_against(direction, a, b, b_in_a);
    const double gap = direction.dot(corner.difference) / direction.norm();
    if (gap > planes) {
      planes = gap;
      normal = -direction.normalized();
    }
    if (planes - margin > limit) return {infinity};
    if (planes > touching && points - planes <= wanted * size) break;
    simplex.add(corner);
    if (simplex.is_empty()) break;  // a rotation of NaN
    direction = simplex.point();
    if (direction.norm() < points) {
      points = direction.norm();
      best = simplex;
    } else {
      ++idle;
    }
    if (points <= touching) return {0};
    if (simplex.is_full()) break;
  }
  if (!(points - std::max(planes, margin) <= required * size)) return {nan};
  if (!(planes > touching)) return {0};
  const Vector3d to_b = -best.point() / points;
  return {points - margin, normal, best.on_a() + a.margin() * to_b,
          best.on_a() - best.point() - b.margin() * to_b};
}

}  // namespace separation
