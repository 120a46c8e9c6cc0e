#include "separation/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/plot.hpp"

namespace separation {
namespace {

using multibody::HingeMode;

// A column over time; `scale` turns its unit into the picture's. Curves of a
// hinge end where it breaks.
cli::Curve curve(const Rows& rows, const std::string& label,
                 const std::string& column, double scale) {
  cli::Curve result{label, {}, {}, false};
  const std::size_t j = rows.column(column);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.x.push_back(rows.at(i, 0));
    result.y.push_back(scale * rows.at(i, j));
  }
  return result;
}

bool is_flat_zero(const cli::Curve& c) {
  return std::all_of(c.y.begin(), c.y.end(),
                     [](double y) { return y == 0 || std::isnan(y); });
}

void end_at_release(const Rows& rows, const std::string& body, cli::Curve& c) {
  const std::size_t mode = rows.column(body + ".mode");
  std::size_t end = 0;
  while (end < rows.size() &&
         rows.at(end, mode) != static_cast<double>(HingeMode::released)) {
    ++end;
  }
  c.x.resize(end);
  c.y.resize(end);
}

template <class F>
void for_hinged(const Case& c, F call) {
  for (const Load& load : c.loads) {
    if (load.hinge.kind != multibody::JointKind::none) {
      call(load, column_name(load.body.name));
    }
  }
}

cli::LinePlot plot_of(const Case& c, const std::string& y_label) {
  cli::LinePlot plot;
  plot.title = c.name;
  plot.x_label = "time, s";
  plot.y_label = y_label;
  return plot;
}

cli::LinePlot hinges(const Case& c, const Rows& rows, const char* label,
                     const char* quantity) {
  cli::LinePlot plot = plot_of(c, label);
  for_hinged(c, [&](const Load& load, const std::string& column) {
    plot.curves.push_back(curve(rows, load.body.name, column + quantity, 1));
    end_at_release(rows, column, plot.curves.back());
  });
  return plot;
}

cli::LinePlot reactions(const Case& c, const Rows& rows) {
  // kN where anything reaches 1 kN.
  double largest = 0;
  for_hinged(c, [&](const Load&, const std::string& column) {
    for (const char* name : {".reaction_N", ".lock_reaction_N"}) {
      const auto values = curve(rows, "", column + name, 1).y;
      largest =
          std::max(largest, *std::max_element(values.begin(), values.end()));
    }
  });
  const bool kilo = largest >= 1000;
  const double scale = kilo ? 1e-3 : 1;
  cli::LinePlot plot = plot_of(c, kilo ? "reaction, kN" : "reaction, N");
  int loads = 0;
  for_hinged(c, [&](const Load& load, const std::string& column) {
    plot.curves.push_back(
        curve(rows, load.body.name, column + ".reaction_N", scale));
    plot.curves.back().colour = ++loads;
    end_at_release(rows, column, plot.curves.back());
    cli::Curve lock = curve(rows, load.body.name + ", lock",
                            column + ".lock_reaction_N", scale);
    if (is_flat_zero(lock)) return;
    lock.dashed = true;
    lock.colour = plot.curves.back().colour;
    end_at_release(rows, column, lock);
    plot.curves.push_back(std::move(lock));
  });
  return plot;
}

cli::LinePlot clearances(const Case& c, const Rows& rows) {
  cli::LinePlot plot = plot_of(c, "clearance, m");
  for (const auto& [a, b] : c.clearance) {
    const std::string column =
        fmt::format("clearance.{}.{}_m", column_name(c.body(a).name),
                    column_name(c.body(b).name));
    plot.curves.push_back(
        curve(rows, fmt::format("{}, {}", c.body(a).name, c.body(b).name),
              column, 1));
  }
  return plot;
}

}  // namespace

std::string draw_pictures(const Case& c, const Rows& rows,
                          const std::string& file) {
  const std::size_t dot = file.rfind('.');
  const auto name = [&](const char* what) {
    return fmt::format("{}_{}{}", file.substr(0, dot), what, file.substr(dot));
  };
  const auto draw = [&](const cli::LinePlot& plot, const char* what) {
    return plot.curves.empty() ? std::string() : cli::draw(plot, name(what));
  };
  for (const std::string& problem :
       {draw(hinges(c, rows, "angle of the hinge, deg", ".angle_deg"),
             "angles"),
        draw(hinges(c, rows, "rate of the hinge, deg/s", ".rate_deg_per_s"),
             "rates"),
        draw(reactions(c, rows), "reactions"),
        draw(clearances(c, rows), "clearance")}) {
    if (!problem.empty()) return problem;
  }
  return {};
}

}  // namespace separation
