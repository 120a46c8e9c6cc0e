#include "joint/torque_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/plot.hpp"
#include "joint/solution_row.hpp"

namespace hinge_joint {
namespace {

// At most `most` values of a sweep, evenly spread, the ends included.
std::vector<double> spread(const cli::Sweep& sweep, std::size_t most) {
  const std::size_t size = std::min(sweep.size(), most);
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i) {
    values.push_back(
        sweep[size == 1 ? 0 : i * (sweep.size() - 1) / (size - 1)]);
  }
  return values;
}

// A unit in which the largest value has few digits.
struct Unit {
  double factor;
  const char* prefix;
};
Unit unit_for(double largest) {
  if (largest >= 1e7) return {1e-6, "M"};
  if (largest >= 1e4) return {1e-3, "k"};
  return {1, ""};
}

std::string laws(const NamedJoint& joint, bool several) {
  if (!several) return "";
  return fmt::format(", {}, {}", joint.law, joint.pressure);
}

}  // namespace

std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file) {
  // What a picture of some 1,000 dots across can show.
  constexpr std::size_t most_curves = 6;
  constexpr std::size_t most_points = 500;
  const bool reaction = inputs.question() == Question::reaction;
  const bool over_angle =
      inputs.forces()->size() == 1 && inputs.angles()->size() > 1;
  const cli::Sweep& x = over_angle ? *inputs.angles() : *inputs.forces();
  const cli::Sweep& family = over_angle ? *inputs.forces() : *inputs.angles();
  const bool several = setup.joints.size() > 1;
  const bool pin = setup.joints[0].joint.is_pin();

  cli::LinePlot plot;
  plot.title = setup.name.empty() ? "friction moment" : setup.name;
  if (!several) {
    plot.title += fmt::format(" (law {}, pressure {})", setup.joints[0].law,
                              setup.joints[0].pressure);
  }
  plot.logarithmic_x = x.is_logarithmic();
  int colour = 0;
  double largest_moment = 0;
  for (const NamedJoint& joint : setup.joints) {
    for (const double member : spread(family, most_curves)) {
      const std::string which =
          over_angle ? fmt::format("{} = {} N", reaction ? "R" : "Rₙ", member)
          : pin      ? std::string("pin")
                     : fmt::format("{} = {}°", reaction ? "β" : "α", member);
      const std::string label = which + laws(joint, several);
      ++colour;
      cli::Curve solved{label, {}, {}, false, colour};
      cli::Curve traditional{label + ", from R", {}, {}, true, colour};
      for (const double value : spread(x, most_points)) {
        const Input input =
            over_angle ? inputs.at(member, value) : inputs.at(value, member);
        const Answer a = answer(joint, inputs.question(), input);
        const double moment = a.solution.friction_moment.stableNorm();
        largest_moment = std::max({largest_moment, moment, a.traditional});
        solved.x.push_back(value);
        solved.y.push_back(moment);
        traditional.x.push_back(value);
        traditional.y.push_back(a.traditional);
      }
      plot.curves.push_back(std::move(solved));
      if (reaction) plot.curves.push_back(std::move(traditional));
    }
  }
  const double largest_x = x[x.size() - 1];
  const Unit force =
      over_angle || plot.logarithmic_x ? Unit{1, ""} : unit_for(largest_x);
  const Unit moment = unit_for(largest_moment);
  for (cli::Curve& curve : plot.curves) {
    for (double& value : curve.x) value *= force.factor;
    for (double& value : curve.y) value *= moment.factor;
  }
  plot.x_label =
      !over_angle ? fmt::format("{}, {}N",
                                reaction ? "reaction R" : "compressive force",
                                force.prefix)
      : reaction  ? "angle β between R and Δω, deg"
                  : "slip axis angle α, deg";
  plot.y_label = fmt::format("friction moment, {}N m", moment.prefix);
  return cli::draw(plot, file);
}

}  // namespace hinge_joint
