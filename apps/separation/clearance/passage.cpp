#include "separation/clearance/passage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace separation {
namespace {

using SolidLook = Clearance::SolidLook;

double speed_bound(double a, double b) {
  return std::max(a, b) + std::abs(a - b);
}

}  // namespace

double least_between(const SolidLook& from, const SolidLook& to) {
  const double h = to.time - from.time;
  const double way = h * speed_bound(from.speed(), to.speed());
  const double least = (from.distance + to.distance - way) / 2;
  if (!(from.distance > 0) || !(to.distance > 0)) return least;
  // Twice the mean acceleration, plus the acceleration of a rotation at a
  // constant rate. Each bound is lowest at an end.
  const double turn = speed_bound(from.turn.norm(), to.turn.norm());
  const double bend = h * ((to.velocity - from.velocity).norm() +
                           (to.turn - from.turn).norm() * from.radius) +
                      h * h / 2 * turn * turn * from.radius;
  const double after =
      std::min(from.distance, from.distance + h * from.least_rate - bend);
  const double before =
      std::min(to.distance, to.distance - h * to.most_rate - bend);
  return std::max({least, after, before});
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
