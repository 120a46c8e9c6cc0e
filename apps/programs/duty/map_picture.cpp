#include "programs/duty/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/sphere_view.hpp"
#include "cli/picture/text_size.hpp"
#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_duty {
namespace {

using contact::degree;
using contact::WearMap;
using Eigen::Vector3d;

// From above the middle of the wear.
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

// Axis of the numbers of a body: its depth, m, if k is known.
cli::Axis axis_of(const BodyWear& wear) {
  if (!wear.k) return {"∫ p v dt", "Pa m"};
  return {"depth in 10⁶ cycles", "m"};
}
double number_of(const BodyWear& wear, const WearMap::Wear& at) {
  constexpr double millimetre = 1e-3;
  return wear.k ? 1e6 * millimetre * wear.depth(at) : at.pv;
}

std::string label(const BodyWear& wear) {
  std::string text = fmt::format("{} ({})", wear.surface, wear.body);
  if (!wear.k) return text;
  const double depth = number_of(wear, wear.deepest.wear);
  const cli::Prefix prefix = cli::prefix_of(axis_of(wear), {0, depth});
  return text + fmt::format(": {:.3g} {}m in 10⁶ cycles", prefix.factor * depth,
                            prefix.name);
}

// Numbers at the dots of a square, row by row from the bottom; 0: no wear. Fine
// dots within a coarse cell are interpolated, and computed only where the wear
// ends: each takes 20 us.
class Dots {
 public:
  static constexpr int cells = 200, fine = 3, size = cells * fine + 1;

  template <class At>  // double(int i, int j) of a fine dot
  explicit Dots(const At& at) : numbers_(size * size) {
    for (int j = 0; j < size; j += fine) {
      for (int i = 0; i < size; i += fine) number(i, j) = at(i, j);
    }
    for (int j = 0; j + 1 < size; j += fine) {
      for (int i = 0; i + 1 < size; i += fine) fill(i, j, at);
    }
  }
  double& number(int i, int j) { return numbers_[j * size + i]; }

 private:
  template <class At>
  void fill(int i, int j, const At& at) {
    const std::array<double, 4> corners = {number(i, j), number(i + fine, j),
                                           number(i, j + fine),
                                           number(i + fine, j + fine)};
    const auto worn =
        std::ranges::count_if(corners, [](double n) { return n > 0; });
    if (worn == 0) return;
    for (int v = 0; v <= fine; ++v) {
      for (int u = 0; u <= fine; ++u) {
        if (u % fine == 0 && v % fine == 0) continue;
        const double x = double(u) / fine, y = double(v) / fine;
        number(i + u, j + v) =
            worn == 4 ? std::lerp(std::lerp(corners[0], corners[1], x),
                                  std::lerp(corners[2], corners[3], x), y)
                      : at(i + u, j + v);
      }
    }
  }

  std::vector<double> numbers_;
};

std::string data_block(const BodyWear& wear, const cli::SphereView& view,
                       double factor, int number) {
  const auto place = [&](int i) {
    return view.radius * (2. * i / (Dots::size - 1) - 1);
  };
  Dots dots([&](int i, int j) {
    const double x = place(i), y = place(j);
    return std::hypot(x, y) < 2 ? number_of(wear, wear.map.at(view.point(x, y)))
                                : 0;
  });
  std::string script = fmt::format("$map{} << END\n", number);
  for (int j = 0; j < Dots::size; ++j) {
    for (int i = 0; i < Dots::size; ++i) {
      const double of = dots.number(i, j);
      fmt::format_to(std::back_inserter(script), "{:.6g} {:.6g} {:.6g}\n",
                     place(i), place(j), of > 0 ? factor * of : NAN);
    }
  }
  return script + "END\n";
}

std::string draw_balls(const std::vector<BodyWear>& wear,
                       const std::string& title, const std::string& file) {
  constexpr double width = (cli::canvas_width - 2 * cli::canvas_margin) / 2;
  constexpr double scale_width = 5;  // colours, their numbers and label
  constexpr double side = width - scale_width - 1;  // of a map
  // Names of axes lie above and below the maps too.
  constexpr double above = 2.5 * cli::line_step, below = cli::line_step;
  const cli::Canvas canvas(title, {}, above + side + below);
  const cli::Box& room = canvas.room();
  std::string script =
      "set multiplot\nunset border\nunset xtics\nunset ytics\nunset key\n"
      "unset grid\nset size ratio -1\n" +
      canvas.script();
  std::array<cli::SphereView, 2> views = {view_of(wear[0]), view_of(wear[1])};
  const double radius = std::max(views[0].radius, views[1].radius);
  for (int n = 0; n < 2; ++n) {
    const BodyWear& w = wear[n];
    const double left = room.left + n * width;
    const cli::Box box{left, left + side, room.top + above,
                       room.bottom - below};
    const cli::Box with_scale{left, left + width - 1, room.top + cli::line_step,
                              room.bottom};
    cli::SphereView& view = views[n];
    view.radius = radius;  // to the same scale
    const cli::Box colours{box.right + 0.5, box.right + 1.3, box.top + 0.5,
                           box.bottom - 0.5};
    const cli::Axis axis = axis_of(w);
    const double largest = number_of(w, w.deepest.wear);
    const cli::Prefix prefix = cli::prefix_of(axis, {0, largest});
    const cli::Ticks ticks =
        cli::ticks_of(axis, {0, prefix.factor * largest}, cli::Run::up,
                      colours.height(), false);
    script += data_block(w, view, prefix.factor, n);
    script += view.axis_labels() + view.circles();
    script += ticks.script("cb") + canvas.margins(box) +
              canvas.above(with_scale, label(w)) + canvas.colour_box(colours) +
              canvas.upward(box.right + scale_width, colours,
                            cli::label_of(axis, prefix)) +
              fmt::format(
                  "set xrange [-{0}:{0}]\nset yrange [-{0}:{0}]\n"
                  "plot $map{1} using 1:2:3 with image\n"
                  "unset label\nunset object\n",
                  cli::number_text(radius), n);
  }
  return cli::draw_script(script + "unset multiplot\n", file, canvas.stretch());
}

// Angle at which the circle is cut for a linear axis, deg: the end of a quarter
// with the least wear.
double cut_of(const std::vector<BodyWear>& wear) {
  const auto at = [&](double beta_deg) {
    double all = 0;
    for (const BodyWear& w : wear) {
      const Vector3d place(std::cos(beta_deg * degree),
                           std::sin(beta_deg * degree), 0);
      const auto nearest = std::ranges::max_element(
          w.points, {},
          [&](const Vector3d& point) { return point.dot(place); });
      all += w.wear[nearest - w.points.begin()].pv;
    }
    return all;
  };
  constexpr std::array<double, 4> quarters = {-180, -90, 0, 90};
  return *std::ranges::min_element(quarters, {}, at);
}

std::string draw_pins(const std::vector<BodyWear>& wear,
                      const std::string& title, const std::string& file) {
  cli::LinePlot plot{.title = title,
                     .x = {"β from X towards Y", "deg"},
                     .y = axis_of(wear[0]),
                     .curves = {}};
  // Depths on one axis if all are known.
  const bool depths = std::ranges::all_of(
      wear, [](const BodyWear& w) { return w.k.has_value(); });
  if (!depths) plot.y = {"∫ p v dt", "Pa m"};
  const double cut = cut_of(wear);
  for (const BodyWear& w : wear) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < w.points.size(); ++i) {
      const double beta = std::atan2(w.points[i].y(), w.points[i].x()) / degree;
      // The point at the cut may fall on either side of it.
      constexpr double rounding = 1e-9;
      const double turns = std::floor((beta - cut + rounding) / 360);
      points.emplace_back(beta - 360 * turns,
                          depths ? number_of(w, w.wear[i]) : w.wear[i].pv);
    }
    std::ranges::sort(points);
    points.emplace_back(points.front().first + 360, points.front().second);
    cli::Curve curve{.label = label(w), .x = {}, .y = {}};
    for (const auto& [beta, number] : points) {
      curve.x.push_back(beta);
      curve.y.push_back(number);
    }
    plot.curves.push_back(std::move(curve));
  }
  return cli::draw(plot, file);
}

}  // namespace

std::string draw_map(bool is_pin, const std::vector<BodyWear>& wear,
                     const std::string& title, const std::string& file) {
  if (wear[0].deepest.wear.pv == 0) {
    return fmt::format("no picture {}: nothing wears", file);
  }
  return is_pin ? draw_pins(wear, title, file) : draw_balls(wear, title, file);
}

}  // namespace hinge_duty
