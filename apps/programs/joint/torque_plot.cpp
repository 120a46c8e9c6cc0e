#include "programs/joint/torque_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/plot.hpp"
#include "programs/joint/solution_row.hpp"

namespace hinge_joint {
namespace {

// A unit in which the largest value has few digits.
struct Unit {
  double factor;
  const char* prefix;
};
Unit unit_for(double largest, bool logarithmic) {
  if (logarithmic) return {1, ""};
  if (largest >= 1e6) return {1e-6, "M"};
  if (largest >= 1e4) return {1e-3, "k"};
  return {1, ""};
}

// What the curves of a plot have in common and in what they differ.
class Labels {
 public:
  Labels(const Setup& setup, const Inputs& inputs, bool over_angle)
      : reaction_(inputs.question() == Question::reaction),
        over_angle_(over_angle),
        member_(!setup.joints[0].joint.is_pin() || over_angle) {
    const auto& first = setup.joints[0];
    for (const NamedJoint& joint : setup.joints) {
      laws_ |= joint.law != first.law;
      pressures_ |= joint.pressure != first.pressure;
    }
    members_ = (over_angle ? inputs.forces() : inputs.angles())->size() > 1;
  }

  std::string title(const Setup& setup, double member) const {
    const std::string& name = setup.given[0].spec.name;
    std::string text =
        name.empty() || setup.given.size() > 1 ? "friction moment" : name;
    const NamedJoint& first = setup.joints[0];
    if (!members_ && member_) text += ", " + member_text(member);
    if (!laws_) text += ", law " + first.law;
    if (!pressures_) text += ", pressure " + first.pressure;
    return text;
  }
  std::string curve(const NamedJoint& joint, double member) const {
    std::string text;
    const auto add = [&text](const std::string& part) {
      text += (text.empty() ? "" : ", ") + part;
    };
    if (members_) add(member_text(member));
    if (!joint.differences.empty()) add(difference_text(joint.differences));
    if (laws_) add(joint.law);
    if (pressures_) add(joint.pressure);
    return text;
  }
  std::string x(const Unit& unit) const {
    if (over_angle_) {
      return reaction_ ? "angle β between R and Δω, deg"
                       : "slip axis angle α, deg";
    }
    return fmt::format("{}, {}N", reaction_ ? "reaction R" : "normal force",
                       unit.prefix);
  }

 private:
  std::string member_text(double member) const {
    return over_angle_
               ? fmt::format("{} = {} N", reaction_ ? "R" : "Rₙ", member)
               : fmt::format("{} = {}°", reaction_ ? "β" : "α", member);
  }

  bool reaction_;
  bool over_angle_;
  bool member_;  // worth naming: a pin has no angles
  bool members_ = false;
  bool laws_ = false;
  bool pressures_ = false;
};

}  // namespace

std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file) {
  // What a picture of some 1,000 dots across can show.
  constexpr std::size_t most_points = 500;
  const bool reaction = inputs.question() == Question::reaction;
  const bool over_angle = inputs.angles()->size() > inputs.forces()->size();
  const cli::Sweep& x = over_angle ? *inputs.angles() : *inputs.forces();
  const cli::Sweep& family = over_angle ? *inputs.forces() : *inputs.angles();
  const Labels labels(setup, inputs, over_angle);

  cli::LinePlot plot;
  plot.title = labels.title(setup, family[0]);
  plot.logarithmic_x = plot.logarithmic_y = x.is_logarithmic();
  const std::size_t most_members = std::max<std::size_t>(
      1, std::min<std::size_t>(6, most_pairs_of_laws / setup.joints.size()));
  int colour = 0;
  double largest = 0;
  for (const NamedJoint& joint : setup.joints) {
    for (const double member : cli::spread(family, most_members)) {
      const std::string label = labels.curve(joint, member);
      ++colour;
      cli::Curve solved{
          label.empty() ? "solved" : label, {}, {}, false, colour};
      // Without a name: the axis says what is dashed.
      cli::Curve traditional{"", {}, {}, true, colour};
      for (const double value : cli::spread(x, most_points)) {
        const Answer a = answer(
            joint, inputs.question(),
            over_angle ? inputs.at(member, value) : inputs.at(value, member));
        const double moment = a.solution().friction_moment.stableNorm();
        largest = std::max({largest, moment, a.traditional});
        solved.x.push_back(value);
        solved.y.push_back(moment);
        traditional.x.push_back(value);
        traditional.y.push_back(a.traditional);
      }
      plot.curves.push_back(std::move(solved));
      if (reaction) plot.curves.push_back(std::move(traditional));
    }
  }
  const Unit force =
      over_angle ? Unit{1, ""} : unit_for(x[x.size() - 1], plot.logarithmic_x);
  const Unit moment = unit_for(largest, plot.logarithmic_y);
  for (cli::Curve& curve : plot.curves) {
    for (double& value : curve.x) value *= force.factor;
    for (double& value : curve.y) value *= moment.factor;
  }
  plot.x_label = labels.x(force);
  plot.y_label = fmt::format("friction moment, {}N m{}", moment.prefix,
                             reaction ? "; dashed: from R" : "");
  return cli::draw(plot, file);
}

}  // namespace hinge_joint
