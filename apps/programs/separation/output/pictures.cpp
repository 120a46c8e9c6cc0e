#include "programs/separation/output/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/plot.hpp"

namespace separation {
namespace {

using multibody::HingeMode;

// A column over time. Curves of a hinge end where it breaks.
cli::Curve curve(const Rows& rows, const std::string& label,
                 const std::string& column) {
  cli::Curve result{label, {}, {}, false};
  const std::size_t j = rows.column(column);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.x.push_back(rows.at(i, 0));
    result.y.push_back(rows.at(i, j));
  }
  return result;
}

// While the hinge is in this mode.
template <class F>
void end_curve(const Rows& rows, const std::string& body, F goes_on,
               cli::Curve& c) {
  const std::size_t mode = rows.column(body + ".mode");
  std::size_t end = 0;
  while (end < rows.size() && goes_on(static_cast<HingeMode>(
                                  static_cast<int>(rows.at(end, mode))))) {
    ++end;
  }
  c.x.resize(end);
  c.y.resize(end);
}
void end_at_release(const Rows& rows, const std::string& body, cli::Curve& c) {
  end_curve(
      rows, body, [](HingeMode mode) { return mode != HingeMode::released; },
      c);
}

template <class F>
void for_hinged(const Case& c, F call) {
  for (const Body& body : c.bodies) {
    if (body.hinge.kind != multibody::HingeKind::none) {
      call(body, column_name(body.rigid.name));
    }
  }
}

cli::LinePlot plot_of(const Case& c, cli::Axis y) {
  cli::LinePlot plot;
  plot.title = c.name;
  plot.x = {"time", "s"};
  plot.y = std::move(y);
  return plot;
}

cli::LinePlot hinges(const Case& c, const Rows& rows, cli::Axis y,
                     const char* quantity) {
  cli::LinePlot plot = plot_of(c, std::move(y));
  for_hinged(c, [&](const Body& body, const std::string& column) {
    plot.curves.push_back(curve(rows, body.rigid.name, column + quantity));
    end_at_release(rows, column, plot.curves.back());
  });
  return plot;
}

cli::LinePlot reactions(const Case& c, const Rows& rows) {
  cli::LinePlot plot = plot_of(c, {"reaction", "N"});
  int bodies = 0;
  for_hinged(c, [&](const Body& body, const std::string& column) {
    plot.curves.push_back(curve(rows, body.rigid.name, column + ".reaction_N"));
    plot.curves.back().colour = ++bodies;
    end_at_release(rows, column, plot.curves.back());
    cli::Curve lock =
        curve(rows, body.rigid.name + ", lock", column + ".lock_reaction_N");
    end_curve(
        rows, column, [](HingeMode mode) { return mode == HingeMode::locked; },
        lock);
    if (lock.x.empty()) return;
    lock.dashed = true;
    lock.colour = plot.curves.back().colour;
    plot.curves.push_back(std::move(lock));
  });
  return plot;
}

cli::LinePlot clearances(const Case& c, const Rows& rows) {
  cli::LinePlot plot = plot_of(c, {"clearance", "m"});
  for (const Case::Pair& pair : c.clearance) {
    const std::string name = pair.name.empty() ? "" : pair.name + ": ";
    plot.curves.push_back(
        curve(rows,
              fmt::format("{}{}, {}", name, c.rigid_body(pair.a).name,
                          c.rigid_body(pair.b).name),
              clearance_column(c, pair) + "_m"));
  }
  // The logarithmic scale shows small distances beside distances of bodies that
  // drift far apart.
  plot.y.logarithmic = cli::is_wide(plot.curves);
  return plot;
}

std::string picture_name(const std::string& file, const char* what) {
  const std::size_t dot = file.rfind('.');
  return fmt::format("{}_{}{}", file.substr(0, dot), what, file.substr(dot));
}

}  // namespace

std::vector<std::string> picture_names(const Case& c, bool clearance,
                                       const std::string& file) {
  std::vector<std::string> names;
  if (c.has_hinges()) {
    for (const char* what : {"angles", "rates", "reactions"}) {
      names.push_back(picture_name(file, what));
    }
  }
  if (clearance && !c.clearance.empty()) {
    names.push_back(picture_name(file, "clearance"));
  }
  return names;
}

std::string draw_pictures(const Case& c, const Rows& rows, bool clearance,
                          const std::string& file) {
  std::vector<cli::LinePlot> plots;
  if (c.has_hinges()) {
    plots = {hinges(c, rows, {"angle of the hinge", "deg"}, ".angle_deg"),
             hinges(c, rows, {"rate of the hinge", "deg/s"}, ".rate_deg_per_s"),
             reactions(c, rows)};
  }
  if (clearance && !c.clearance.empty()) plots.push_back(clearances(c, rows));
  const auto names = picture_names(c, clearance, file);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    std::string problem = cli::draw(plots[i], names[i]);
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace separation
