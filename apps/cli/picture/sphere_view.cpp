#include "cli/picture/sphere_view.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "cli/number.hpp"
#include "libcontact/base/units.hpp"

namespace cli {

using contact::degree;
using Eigen::Vector2d;
using Eigen::Vector3d;

SphereView::SphereView(const Vector3d& towards_eye) : up(towards_eye) {
  const Vector3d axis = std::abs(up.z()) < 0.9 ? Vector3d::UnitZ().eval()
                                               : Vector3d::UnitY().eval();
  right = axis.cross(up).normalized();
  top = up.cross(right);
}

Vector2d SphereView::at(const Vector3d& point) const {
  const Vector3d flat = point - point.dot(up) * up;
  const double sine = flat.norm();
  if (sine == 0) return {0, 0};
  return (point - up).norm() / sine * Vector2d(flat.dot(right), flat.dot(top));
}

Vector3d SphereView::point(double x, double y) const {
  const double square = x * x + y * y;  // 2 - 2 cos t
  return std::sqrt(1 - square / 4) * (x * right + y * top) +
         (1 - square / 2) * up;
}

std::vector<Vector3d> SphereView::axes() const {
  std::vector<Vector3d> seen;
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) {
      const Vector3d axis = sign * Vector3d::Unit(k);
      if ((axis - up).norm() < 0.95 * radius) seen.push_back(axis);
    }
  }
  return seen;
}

std::string SphereView::axis_labels() const {
  std::string script;
  for (const Vector3d& axis : axes()) {
    const Vector2d place = at(axis);
    Eigen::Index k = 0;
    axis.cwiseAbs().maxCoeff(&k);
    script += fmt::format(
        "set label '{}{}' at {},{} front point pt 7 ps 0.4 lc rgb '#ee6677' "
        "offset 0.4,0.4 textcolor rgb '#ee6677'\n",
        axis[k] < 0 ? "−" : "", "XYZ"[k], number_text(place.x()),
        number_text(place.y()));
  }
  return script;
}

Vector2d SphereView::free_place(double size) const {
  const auto distance = [this](const Vector2d& place) {
    double nearest = 2;
    for (const Vector3d& axis : axes()) {
      nearest = std::min(nearest, (at(axis) - place).norm());
    }
    return nearest;
  };
  Vector2d best(0, -size);
  constexpr double step = 45 * degree;
  for (int i = 1; i < 8; ++i) {
    const Vector2d place =
        size * Vector2d(std::sin(i * step), -std::cos(i * step));
    // The bottom comes first among places equally far from all axes.
    if (distance(place) > distance(best) + 0.1 * radius) best = place;
  }
  return best;
}

std::string SphereView::circles() const {
  // Readable on every colour of a map.
  std::string script =
      "set style textbox opaque noborder fillcolor rgb '#44ffffff' margins "
      "0.5,0.5\n";
  for (int t = 30; t < 180; t += 30) {
    const double size = 2 * std::sin(t * degree / 2);
    if (size > radius) break;
    const Vector2d place = free_place(size);
    script += fmt::format(
        "set object circle at 0,0 size {0} front fs empty border lc rgb "
        "'#666666' lw 0.7\nset label '{1}°' at {2},{3} center front boxed "
        "textcolor rgb '#444444'\n",
        number_text(size), t, number_text(place.x()), number_text(place.y()));
  }
  return script;
}

}  // namespace cli
