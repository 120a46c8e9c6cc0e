#include "programs/duty/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/plot.hpp"
#include "cli/sphere_view.hpp"
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
  return text +
         fmt::format(": deepest {:.2g} mm", wear.depth(wear.deepest.wear));
}

// Straight above the middle of the wear.
cli::SphereView view_of(const BodyWear& wear) {
  Vector3d middle = Vector3d::Zero();
  for (std::size_t i = 0; i < wear.points.size(); ++i) {
    middle += wear.wear[i].pv * wear.points[i];
  }
  cli::SphereView view(middle.normalized());
  for (std::size_t i = 0; i < wear.points.size(); ++i) {
    if (wear.wear[i].pv == 0) continue;
    view.radius = std::max(view.radius, (wear.points[i] - view.up).norm());
  }
  view.radius = std::min(1.1 * view.radius, 2.0);
  return view;
}

std::string data_block(const WearMap& map, const cli::SphereView& view,
                       int number) {
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
  std::array<cli::SphereView, 2> views = {view_of(wear[0]), view_of(wear[1])};
  const double radius = std::max(views[0].radius, views[1].radius);
  for (int n = 0; n < 2; ++n) {
    const BodyWear& w = wear[n];
    cli::SphereView& view = views[n];
    view.radius = radius;  // to the same scale
    const double left = 0.02 + 0.41 * n;
    script += data_block(WearMap(cycle, w.part), view, n);
    script += view.axis_labels() + view.circles();
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
