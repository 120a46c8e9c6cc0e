#include "programs/joint/contact_picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "cli/gnuplot.hpp"
#include "cli/number.hpp"
#include "cli/picture/axis.hpp"
#include "cli/picture/canvas.hpp"
#include "cli/picture/sphere_view.hpp"
#include "cli/picture/text_size.hpp"
#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_joint {
namespace {

using Peak = contact::SlidingContact::Peak;
using contact::degree;
using contact::SlidingContact;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double mega = 1e6;

// Largest p, which thin walls may move away from the centre in the direction
// `to`.
Peak largest_pressure(const SlidingContact& contact, double half_angle,
                      const Vector3d& to) {
  Peak peak{0, 0, contact.centre()};
  constexpr int steps = 1000;
  for (int i = 0; i <= steps; ++i) {
    const double theta = half_angle * i / steps;
    const Vector3d place =
        std::cos(theta) * contact.centre() + std::sin(theta) * to;
    const double p = contact.pressure(place);
    if (p > peak.value) peak = {p, theta, place};
  }
  return peak;
}

// The largest |v| over the contact of a ball, m/s.
double largest_slip(const SlidingContact& contact, double half_angle,
                    const Vector3d& rate) {
  const Vector3d w = rate.stableNormalized();
  const Vector3d equator = w.unitOrthogonal();
  const double psi = std::atan2(contact.centre().cross(w).norm(),
                                std::abs(contact.centre().dot(w)));
  return contact.slip(equator).norm() *
         std::sin(std::min(psi + half_angle, 90 * degree));
}

// Dots with p, p v and |v|, empty outside of the contact.
std::string dots(const SlidingContact& contact, double half_angle,
                 const cli::SphereView& view) {
  constexpr int half = 150;  // dots on each side of the middle
  const double edge = 2 * std::sin(half_angle / 2);
  std::string script = "$map << END\n";
  for (int j = -half; j <= half; ++j) {
    for (int i = -half; i <= half; ++i) {
      const double x = view.radius * i / half;
      const double y = view.radius * j / half;
      script += cli::number_text(x) + ' ' + cli::number_text(y);
      if (std::hypot(x, y) > edge) {
        script += " NaN NaN NaN\n";
        continue;
      }
      const Vector3d place = view.point(x, y);
      script += ' ' + cli::number_text(contact.pressure(place) / mega) + ' ' +
                cli::number_text(contact.pv(place) / mega) + ' ' +
                cli::number_text(contact.slip(place).norm()) + '\n';
    }
  }
  return script + "END\n";
}

// Arrows; at a slip of `largest` they are about as long as their spacing.
std::string arrows(const SlidingContact& contact, double half_angle,
                   const cli::SphereView& view, double largest) {
  constexpr int half = 4;
  const double edge = 2 * std::sin(half_angle / 2);
  const double step = edge / (half + 0.5);
  std::string script = "$slip << END\n";
  for (int j = -half; j <= half; ++j) {
    for (int i = -half; i <= half; ++i) {
      const Vector2d middle(step * i, step * j);
      if (middle.norm() + step / 2 > edge) continue;
      const Vector3d place = view.point(middle.x(), middle.y());
      const Vector3d slip = contact.slip(place) / largest;
      constexpr double small = 1e-4;
      const Vector2d arrow =
          0.9 * step / small *
          (view.at((place + small * slip).normalized()) - middle);
      const Vector2d tail = middle - arrow / 2;
      script +=
          fmt::format("{} {} {} {}\n", cli::number_text(tail.x()),
                      cli::number_text(tail.y()), cli::number_text(arrow.x()),
                      cli::number_text(arrow.y()));
    }
  }
  return script + "END\n";
}

// A cross.
std::string mark(const Peak& peak, const cli::SphereView& view) {
  const Vector2d at = view.at(peak.place);
  return fmt::format(
      "set label '' at {},{} front point pt 2 ps 1.2 lw 2 lc rgb 'black'\n",
      cli::number_text(at.x()), cli::number_text(at.y()));
}

std::string draw_ball(const SlidingContact& contact, double half_angle,
                      const Vector3d& rate, const std::string& title,
                      const std::string& file) {
  cli::SphereView view(contact.centre());
  view.radius = std::min(2.2 * std::sin(half_angle / 2), 2.0);
  const Peak p = largest_pressure(contact, half_angle, view.right);
  const Peak& pv = contact.largest_pv();
  const double slip = largest_slip(contact, half_angle, rate);
  struct Panel {
    std::string title;
    double largest;
    std::string over;  // drawing over the dots
    std::string plot;
  };
  // Crosses show where; titles stay short enough for one line.
  const auto peak_title = [](const char* name, const Peak& peak,
                             const char* unit) {
    return fmt::format("{} to {:.3g} {}", name, peak.value / mega, unit);
  };
  const std::array<Panel, 3> panels = {
      Panel{peak_title("p", p, "MPa"), p.value / mega, mark(p, view), ""},
      Panel{peak_title("p v", pv, "MPa m/s"), pv.value / mega, mark(pv, view),
            ""},
      Panel{fmt::format("slip to {:.3g} m/s", slip), slip, "",
            ", $slip using 1:2:3:4 with vectors head filled size graph "
            "0.03,20 lw 1 lc rgb 'white'"}};
  constexpr double width = (cli::canvas_width - 2 * cli::canvas_margin) / 3;
  constexpr double side = width - 1;  // of a map
  constexpr double above = cli::line_step + 0.5, below = 5;
  const cli::Canvas canvas(title, {}, above + side + below);
  const cli::Box& room = canvas.room();
  // Its edge over those of the dots.
  const std::string edge = fmt::format(
      "set object circle at 0,0 size {} front fs empty border lc rgb '#333333' "
      "lw 1.5\n",
      cli::number_text(2 * std::sin(half_angle / 2)));
  std::string script =
      dots(contact, half_angle, view) +
      arrows(contact, half_angle, view, slip) +
      fmt::format(
          "set multiplot\nunset border\nunset xtics\nunset ytics\n"
          "unset key\nunset grid\nset size ratio -1\n"
          "set xrange [-{0}:{0}]\nset yrange [-{0}:{0}]\n",
          cli::number_text(view.radius)) +
      canvas.script();
  for (int n = 0; n < 3; ++n) {
    const Panel& panel = panels[n];
    const double left = room.left + n * width + 0.5;
    const cli::Box box{left, left + side, room.top + above,
                       room.bottom - below};
    const cli::Box colours{left + 1, left + side - 1, room.bottom - 3.5,
                           room.bottom - 2.7};
    const cli::Ticks ticks = cli::ticks_of(
        {}, {0, panel.largest}, cli::Run::across, colours.width(), false);
    script += view.axis_labels() + view.circles() + edge + panel.over +
              canvas.margins(box) + canvas.above(box, panel.title) +
              ticks.script("cb") + "set colorbox horizontal\n" +
              canvas.colour_box(colours) +
              fmt::format(
                  "plot $map using 1:2:{} with image{}\n"
                  "unset label\nunset object\n",
                  n + 3, panel.plot);
  }
  return cli::draw_script(script + "unset multiplot\n", file, canvas.stretch());
}

std::string draw_pin(const SlidingContact& contact, double half_angle,
                     const std::string& title, const std::string& file) {
  const Vector3d& centre = contact.centre();
  const Vector3d along = contact.slip(centre).stableNormalized();
  cli::PanelPlot plot{
      .title = title,
      .x = {"angle from the contact's centre, the way the body slips", "deg"},
      .values = {},
      .panels = {{.axis = {"p", "Pa"}, .y = {}},
                 {.axis = {"p v", "Pa m/s"}, .y = {}},
                 {.axis = {"slip", "m/s"}, .y = {}}}};
  constexpr int half = 200;  // points on each side
  for (int i = -half; i <= half; ++i) {
    const double theta = half_angle * i / half;
    const Vector3d place = std::cos(theta) * centre + std::sin(theta) * along;
    plot.values.push_back(theta / degree);
    plot.panels[0].y.push_back(contact.pressure(place));
    plot.panels[1].y.push_back(contact.pv(place));
    plot.panels[2].y.push_back(contact.slip(place).norm());
  }
  for (cli::Panel& panel : plot.panels) {
    panel.mark = std::ranges::max_element(panel.y) - panel.y.begin();
  }
  // The slip is the same everywhere.
  plot.panels[2].mark = half;
  return cli::draw(plot, file);
}

}  // namespace

std::string draw_contact(const NamedJoint& joint, const Answer& answer,
                         const std::string& title, const std::string& file) {
  const contact::JointSolution& s = answer.solution();
  if (!(s.normal_force > 0) || s.state != contact::JointState::sliding) {
    return fmt::format("no picture {}: no contact slides", file);
  }
  const SlidingContact contact(joint.joint.contact(), s, answer.rate);
  return joint.joint.is_pin()
             ? draw_pin(contact, s.half_angle, title, file)
             : draw_ball(contact, s.half_angle, answer.rate, title, file);
}

}  // namespace hinge_joint
