#include "separation/clearance/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace separation {
namespace {

using Eigen::Vector3d;
using SolidLook = Clearance::SolidLook;

double speed_bound(double a, double b) {
  return std::max(a, b) + std::abs(a - b);
}

// An affine function of the points r of a solid, body axes: value + slope r.
struct OfPoints {
  double value;
  Vector3d slope;

  OfPoints operator-(const OfPoints& other) const {
    return {value - other.value, slope - other.slope};
  }
  OfPoints operator*(double factor) const {
    return {factor * value, factor * slope};
  }
  double least(const Solid& solid) const {
    return value + slope.dot(solid.farthest(-slope)) -
           solid.margin() * slope.norm();
  }
};

// Coordinates of b's points along a vector in the axes of a, and their rates:
// n (p + R r) and n (v + w x R r).
OfPoints along(const Vector3d& n, const SolidLook& at) {
  return {n.dot(at.place.position), at.place.rotation.transpose() * n};
}
OfPoints rates_along(const Vector3d& n, const SolidLook& at) {
  return {n.dot(at.velocity), at.place.rotation.transpose() * n.cross(at.turn)};
}

// Lower bound between two looks by the planes of one of them. In between a
// point comes nearer than at both by at most h^2/8 times its acceleration,
// taken as twice the mean one: an affine function of the points as well, so
// that points that accelerate, but are far from the planes, do no harm.
double least_beyond(const Vector3d& normal, const SolidLook& planes,
                    const SolidLook& from, const SolidLook& to) {
  const double h = to.time - from.time;
  const OfPoints bend =
      (rates_along(normal, to) - rates_along(normal, from)) * (h / 4);
  double begin = std::numeric_limits<double>::infinity();
  for (const SolidLook* at : {&from, &to}) {
    const OfPoints place = along(normal, *at);
    begin = std::min(
        {begin, place.least(*at->solid), (place - bend).least(*at->solid)});
  }
  return planes.distance + begin - along(normal, planes).least(*planes.solid);
}

}  // namespace

double least_between(const SolidLook& from, const SolidLook& to) {
  const double h = to.time - from.time;
  const double way = h * speed_bound(from.speed(), to.speed());
  const double least = (from.distance + to.distance - way) / 2;
  if (!(from.distance > 0) || !(to.distance > 0)) return least;
  const double turn = speed_bound(from.turn.norm(), to.turn.norm());
  const double acceleration =
      2 *
          ((to.velocity - from.velocity).norm() +
           (to.turn - from.turn).norm() * from.radius()) /
          h +
      turn * turn * from.radius();
  const double rest = h * h / 8 * h * turn * acceleration;
  return std::max({least, least_beyond(from.normal, from, from, to) - rest,
                   least_beyond(to.normal, to, from, to) - rest});
}

void search_passage(const std::function<SolidLook(double time)>& look,
                    const SolidLook& from, const SolidLook& to,
                    const double& known, const double& accuracy) {
  const bool overlap = from.distance <= 0;
  const bool changes = overlap != (to.distance <= 0);
  if (overlap && !changes) return;
  // Nor where a distance has not been found.
  if (!changes && !(least_between(from, to) < known - accuracy)) return;
  const double time = from.time + (to.time - from.time) / 2;
  if (!(from.time < time && time < to.time)) return;
  const SolidLook middle = look(time);
  // The nearer half first: the other one may need no look then.
  const bool first = from.distance < to.distance;
  const auto half = [&](bool before) {
    search_passage(look, before ? from : middle, before ? middle : to, known,
                   accuracy);
  };
  half(first);
  half(!first);
}

}  // namespace separation
