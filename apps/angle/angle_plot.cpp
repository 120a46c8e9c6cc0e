#include "angle/angle_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_angle {
namespace {

std::string load_label(LoadVariable variable, contact::JointKind kind) {
  const bool ball = kind == contact::JointKind::ball;
  switch (variable) {
    case LoadVariable::load:
      return ball ? "normal force, N" : "force per unit length, N/m";
    case LoadVariable::x:
      return ball ? "x = cbrt(μ)" : "x = 2 sqrt(λ)";
    case LoadVariable::load_parameter:
      break;
  }
  return ball ? "load parameter μ" : "load parameter λ";
}

// What a picture of some 1,000 dots across can show.
std::vector<double> shown_values(const cli::Sweep& values) {
  constexpr std::size_t most_points = 1000;
  const std::size_t count = values.size();
  const std::size_t points = std::min(count, most_points);
  std::vector<double> shown;
  for (std::size_t i = 0; i < points; ++i) {
    shown.push_back(values[points == 1 ? 0 : i * (count - 1) / (points - 1)]);
  }
  return shown;
}

// A round number above the largest error of all laws but hertz,
// which leaves any scale near x = 1.
double error_range(const std::vector<cli::Curve>& curves) {
  double largest = 0;
  for (const cli::Curve& curve : curves) {
    if (curve.label == "hertz") continue;
    for (const double y : curve.y) {
      if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    }
  }
  const double power = std::pow(10, std::floor(std::log10(1.05 * largest)));
  for (const double step : {1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (step * power >= 1.05 * largest) return step * power;
  }
  return largest > 0 ? 10 * power : 1;
}

// Percent of the exact half-angle at the same load, in the colours of the
// curves above.
cli::LowerPanel error_panel(const std::vector<cli::Curve>& curves,
                            const cli::Curve& exact) {
  cli::LowerPanel panel{"error, %", 1, {}};
  for (const cli::Curve& curve : curves) {
    if (curve.label == exact.label) continue;
    cli::Curve error = curve;
    for (std::size_t i = 0; i < error.y.size(); ++i) {
      error.y[i] = 100 * (curve.y[i] / exact.y[i] - 1);
    }
    panel.curves.push_back(std::move(error));
  }
  panel.half_range = error_range(panel.curves);
  return panel;
}

}  // namespace

std::string draw(const Loads& scale, const Input& input,
                 const cli::Joint& joint, const std::string& file) {
  const std::vector<double> values = shown_values(input.values);
  cli::LinePlot plot;
  plot.title = joint.title();
  plot.x_label = load_label(input.variable, joint.kind);
  plot.y_label = "contact half-angle θ₀, deg";
  // Laws reach a half-angle at loads that are decades apart.
  plot.logarithmic_x = input.inverse || input.values.is_logarithmic();
  const bool has_tanh =
      std::any_of(joint.laws.begin(), joint.laws.end(),
                  [](const NamedLaw& law) { return law.name == "tanh"; });
  for (const NamedLaw& law : joint.laws) {
    // A ball's blend: the same curve twice.
    if (has_tanh && law.law->name() == "blend:0") continue;
    cli::Curve curve{law.name, {}, {}, law.name == "exact"};
    curve.colour = static_cast<int>(plot.curves.size()) + 1;
    for (const double value : values) {
      if (input.inverse) {
        curve.x.push_back(scale.convert(
            LoadVariable::load_parameter,
            law.law->load_parameter(value * contact::degree).load_parameter,
            input.variable));
        curve.y.push_back(value);
      } else {
        curve.x.push_back(value);
        curve.y.push_back(
            law.law
                ->half_angle(scale.convert(input.variable, value,
                                           LoadVariable::load_parameter))
                .half_angle /
            contact::degree);
      }
    }
    plot.curves.push_back(std::move(curve));
  }
  const auto exact =
      std::find_if(plot.curves.begin(), plot.curves.end(),
                   [](const cli::Curve& c) { return c.label == "exact"; });
  if (exact != plot.curves.end() && plot.curves.size() > 1 && !input.inverse) {
    plot.lower = error_panel(plot.curves, *exact);
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_angle
