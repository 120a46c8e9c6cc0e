#include "programs/angle/angle_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/quantities/tables.hpp"

namespace hinge_angle {
namespace {

cli::Axis axis_of(std::string_view key) {
  return cli::axis_of(
      *contact::find_quantity(contact::solution_quantities(), key));
}

cli::Axis load_axis(LoadVariable variable, const cli::Joint& joint) {
  const bool ball = joint.kind() == contact::JointKind::ball;
  switch (variable) {
    case LoadVariable::load:
      if (joint.has_length) return axis_of("normal_force");
      [[fallthrough]];
    case LoadVariable::line_load:
      return {"force per length", "N/m"};
    case LoadVariable::x:
      return {ball ? "x = cbrt(μ)" : "x = 2 sqrt(λ)"};
    case LoadVariable::load_parameter:
      break;
  }
  return {ball ? "load parameter μ" : "load parameter λ"};
}

// Values that a picture of some 1,000 dots across can show.
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
  cli::LowerPanel panel{{"error", "%"}, 1, {}};
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

// A ball's blend beside tanh: the same curve twice.
bool is_twin(const NamedLaw& law, const cli::Joint& joint) {
  return law.law->name() == "blend:0" &&
         std::ranges::any_of(joint.laws, [](const NamedLaw& other) {
           return other.name == "tanh";
         });
}

cli::Curve curve_of(const NamedLaw& law, const cli::Joint& joint,
                    const Input& input) {
  const Loads loads(joint);
  cli::Curve curve{law.name, {}, {}, law.name == "exact"};
  for (const double value : shown_values(input.values)) {
    if (input.inverse) {
      curve.x.push_back(loads.convert(
          LoadVariable::load_parameter,
          law.law->load_parameter(value * contact::degree).load_parameter /
              loads.factor(*law.law),
          input.variable));
      curve.y.push_back(value);
    } else {
      curve.x.push_back(value);
      curve.y.push_back(
          law.law
              ->half_angle(loads.factor(*law.law) *
                           loads.convert(input.variable, value,
                                         LoadVariable::load_parameter))
              .half_angle /
          contact::degree);
    }
  }
  return curve;
}

}  // namespace

void check_curves(const std::vector<cli::Joint>& joints) {
  cli::check_curves(joints.size() * joints[0].laws.size());
}

std::string draw(const std::vector<Input>& inputs,
                 const std::vector<cli::Joint>& joints,
                 const std::string& file) {
  const Input& first = inputs[0];
  const bool several = joints.size() > 1;
  cli::LinePlot plot;
  plot.title = shared_title(joints, joints[0].laws.size() == 1
                                        ? "law " + joints[0].laws[0].name
                                        : "");
  plot.family = several && joints[0].laws.size() == 1;
  plot.x = load_axis(first.variable, joints[0]);
  plot.y = axis_of("half_angle");
  // Laws reach a half-angle at loads that are decades apart.
  plot.x.logarithmic = first.inverse || first.values.is_logarithmic();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (const NamedLaw& law : joints[i].laws) {
      if (is_twin(law, joints[i])) continue;
      cli::Curve curve = curve_of(law, joints[i], inputs[i]);
      if (several) {
        curve.label = difference_label(joints[i].differences) +
                      (plot.family ? "" : ", " + law.name);
      }
      if (plot.family) curve.dashed = false;
      if (!plot.family) {
        const auto place = static_cast<int>(plot.curves.size()) + 1;
        const int colour = several ? 0 : cli::law_colour(law.name);
        curve.colour = colour > 0 ? colour : place;
      }
      plot.curves.push_back(std::move(curve));
    }
  }
  if (plot.curves.size() == 1) plot.curves[0].label = "";  // in the title
  const auto exact =
      std::find_if(plot.curves.begin(), plot.curves.end(),
                   [](const cli::Curve& c) { return c.label == "exact"; });
  if (exact != plot.curves.end() && plot.curves.size() > 1 && !first.inverse) {
    plot.lower = error_panel(plot.curves, *exact);
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_angle
