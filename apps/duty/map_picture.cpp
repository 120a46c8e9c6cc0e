#include "duty/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_duty {
namespace {

using contact::degree;
using contact::JointCycle;
using contact::WearMap;
using Eigen::Vector3d;

constexpr double mega = 1e6;

std::string label(const BodyWear& wear) {
  std::string text = fmt::format("{} ({})", wear.surface, wear.body);
  if (!wear.k) return text;
  constexpr double mm = 1e-3;
  return text + fmt::format(": deepest {:.2g} mm",
                            *wear.k * mm * mm * wear.deepest.wear.pv);
}

// Lambert's projection from the sphere, equal in area: at the angle t from
// `up`, 2 sin(t/2) from the middle.
struct View {
  Vector3d up;     // towards the eye
  Vector3d right;  // of the picture
  Vector3d top;
  double radius = 0;  // of what is shown

  explicit View(const BodyWear& wear) {
    up.setZero();
    for (std::size_t i = 0; i < wear.points.size(); ++i) {
      up += wear.wear[i].pv * wear.points[i];
    }
    up.normalize();
    // Z at the top unless the eye looks along it.
    const Vector3d axis = std::abs(up.z()) < 0.9 ? Vector3d::UnitZ().eval()
                                                 : Vector3d::UnitY().eval();
    right = axis.cross(up).normalized();
    top = up.cross(right);
    for (std::size_t i = 0; i < wear.points.size(); ++i) {
      if (wear.wear[i].pv == 0) continue;
      radius = std::max(radius, (wear.points[i] - up).norm());
    }
    radius = std::min(1.1 * radius, 2.0);
  }
  Eigen::Vector2d at(const Vector3d& point) const {
    const Vector3d flat = point - point.dot(up) * up;
    const double sine = flat.norm();
    if (sine == 0) return {0, 0};
    return (point - up).norm() / sine *
           Eigen::Vector2d(flat.dot(right), flat.dot(top));
  }
  Vector3d point(double x, double y) const {
    const double square = x * x + y * y;  // 2 - 2 cos t
    return std::sqrt(1 - square / 4) * (x * right + y * top) +
           (1 - square / 2) * up;
  }
};

// Axes of the body that can be seen.
std::string axis_labels(const View& view) {
  std::string script;
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) {
      const Vector3d axis = sign * Vector3d::Unit(k);
      if ((axis - view.up).norm() >= view.radius) continue;
      const Eigen::Vector2d at = view.at(axis);
      script += fmt::format(
          "set label '{}{}' at {},{} front point pt 7 ps 0.4 lc rgb '#ee6677' "
          "offset 0.4,0.4 textcolor rgb '#ee6677'\n",
          sign < 0 ? "−" : "", "XYZ"[k], cli::number_text(at.x()),
          cli::number_text(at.y()));
    }
  }
  return script;
}

// Circles at 30, 60, ... deg from the middle.
std::string circles(const View& view) {
  std::string script;
  for (int t = 30; t < 180; t += 30) {
    const double radius = 2 * std::sin(t * degree / 2);
    if (radius > view.radius) break;
    script += fmt::format(
        "set object circle at 0,0 size {0} front fs empty border lc rgb "
        "'#888888' lw 0.7\nset label '{1}°' at 0,-{0} center front offset "
        "0,0.5 textcolor rgb '#888888'\n",
        cli::number_text(radius), t);
  }
  return script;
}

std::string data_block(const WearMap& map, const View& view, int number) {
  constexpr int half = 60;  // dots on each side of the middle
  std::string script = fmt::format("$map{} << END\n", number);
  for (int j = -half; j <= half; ++j) {
    for (int i = -half; i <= half; ++i) {
      const double x = view.radius * i / half;
      const double y = view.radius * j / half;
      const double pv =
          std::hypot(x, y) < 2 ? map.at(view.point(x, y)).pv / mega : 0;
      script += cli::number_text(x) + ' ' + cli::number_text(y) + ' ' +
                (pv > 0 ? cli::number_text(pv) : "NaN") + '\n';
    }
  }
  return script + "END\n";
}

std::string draw_balls(const JointCycle& cycle,
                       const std::vector<BodyWear>& wear,
                       const std::string& title, const std::string& file) {
  double largest = 0;
  for (const BodyWear& w : wear) {
    largest = std::max(largest, w.deepest.wear.pv / mega);
  }
  std::string script = fmt::format(
      "set multiplot title {} offset 0,-0.5\nunset border\nunset tics\n"
      "unset key\nunset grid\nset size ratio -1\n"
      "set cbrange [0:{}]\nset cblabel '∫ p v dt, MPa m'\nset cbtics\n"
      "set tmargin at screen 0.78\nset bmargin at screen 0.12\n",
      cli::gnuplot_text(title), cli::number_text(largest));
  std::array<View, 2> views = {View(wear[0]), View(wear[1])};
  const double radius = std::max(views[0].radius, views[1].radius);
  for (int n = 0; n < 2; ++n) {
    const BodyWear& w = wear[n];
    View& view = views[n];
    view.radius = radius;  // to the same scale
    const double left = 0.02 + 0.41 * n;
    script += data_block(WearMap(cycle, w.part), view, n);
    script += axis_labels(view) + circles(view);
    script += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\n"
        "set title {}\nset xrange [-{}:{}]\nset yrange [-{}:{}]\n{}"
        "plot $map{} using 1:2:3 with image\nunset label\nunset object\n",
        left, left + 0.38, cli::gnuplot_text(label(w)), radius, radius, radius,
        radius,
        n == 0 ? "unset colorbox\n"
               : "set colorbox user origin screen 0.84,0.17 size screen "
                 "0.025,0.56\n",
        n);
  }
  return cli::draw_script(script + "unset multiplot\n", file);
}

std::string draw_pins(const std::vector<BodyWear>& wear,
                      const std::string& title, const std::string& file) {
  cli::LinePlot plot{.title = title,
                     .x_label = "β from X towards Y, deg",
                     .y_label = "∫ p v dt, MPa m",
                     .curves = {}};
  for (const BodyWear& w : wear) {
    cli::Curve curve{.label = label(w), .x = {}, .y = {}};
    for (std::size_t i = 0; i < w.points.size(); ++i) {
      curve.x.push_back(std::atan2(w.points[i].y(), w.points[i].x()) / degree);
      curve.y.push_back(w.wear[i].pv / mega);
    }
    // The first one, at -180 deg, may come out as 180.
    curve.x.front() = -180;
    plot.curves.push_back(curve);
  }
  return cli::draw(plot, file);
}

}  // namespace

std::string draw_map(const JointCycle& cycle, const std::vector<BodyWear>& wear,
                     const std::string& title, const std::string& file) {
  if (wear[0].deepest.wear.pv == 0) {
    return fmt::format("no picture {}: nothing wears", file);
  }
  if (cycle.contact().geometry().kind() == contact::JointKind::pin) {
    return draw_pins(wear, title, file);
  }
  return draw_balls(cycle, wear, title, file);
}

}  // namespace hinge_duty
