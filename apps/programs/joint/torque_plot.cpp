#include "programs/joint/torque_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "cli/joint/laws.hpp"
#include "cli/plot.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/quantities/tables.hpp"
#include "programs/joint/solution_row.hpp"

namespace hinge_joint {
namespace {

// Labels of the curves of a plot: what they share, and how they differ.
class Labels {
 public:
  Labels(const Setup& setup, const Inputs& inputs, bool over_angle)
      : reaction_(inputs.question() == Question::reaction),
        over_textbook_(over_textbook(setup)),
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
    std::string text = shared_title(setup.given, "");
    if (setup.given[0].spec.name.empty() || text.empty()) {
      text = "friction moment";
    }
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
    if (!joint.differences.empty()) add(difference_label(joint.differences));
    if (laws_) add(joint.law);
    if (pressures_) add(joint.pressure);
    return text;
  }
  cli::Axis x() const {
    if (over_angle_) {
      return {reaction_ ? "angle β between R and Δω" : "slip axis angle α",
              "deg"};
    }
    return axis(reaction_ ? "reaction" : "normal_force");
  }
  cli::Axis y() const {
    if (!over_textbook_) return axis("friction_moment");
    return {reaction_ ? "friction moment over f₀Rρ"
                      : "friction moment over f₀Rₙρ"};
  }
  // Divides by the textbook moment: this shows the difference, which is small
  // compared with both.
  double drawn(double moment, const Answer& a) const {
    return over_textbook_ ? moment / a.solution().textbook_moment : moment;
  }
  // Laws have their own colours if curves differ only in the law.
  int colour(const NamedJoint& joint, int place) const {
    const int law = cli::law_colour(joint.law);
    return laws_ && !members_ && !pressures_ && law > 0 ? law : place;
  }

 private:
  static bool over_textbook(const Setup& setup) {
    return std::ranges::all_of(setup.joints, [](const NamedJoint& joint) {
      const auto* dry =
          std::get_if<contact::FrictionLaw>(&joint.joint.contact().friction());
      return dry != nullptr && dry->coefficient() > 0;
    });
  }
  static cli::Axis axis(std::string_view key) {
    return cli::axis_of(
        *contact::find_quantity(contact::solution_quantities(), key));
  }
  std::string member_text(double member) const {
    return over_angle_
               ? fmt::format("{} = {} N", reaction_ ? "R" : "Rₙ", member)
               : fmt::format("{} = {}°", reaction_ ? "β" : "α", member);
  }

  bool reaction_;
  bool over_textbook_;
  bool over_angle_;
  bool member_;  // varies and is worth a label: pins have no angles
  bool members_ = false;
  bool laws_ = false;
  bool pressures_ = false;
};

}  // namespace

std::string draw_torque(const Setup& setup, const Inputs& inputs,
                        const std::string& file) {
  // More points than a picture 1,000 dots wide can show.
  constexpr std::size_t most_points = 500;
  const bool reaction = inputs.question() == Question::reaction;
  const bool over_angle = inputs.angles()->size() > inputs.forces()->size();
  const cli::Sweep& x = over_angle ? *inputs.angles() : *inputs.forces();
  const cli::Sweep& family = over_angle ? *inputs.forces() : *inputs.angles();
  const double rate = (*inputs.rates())[0];
  const Labels labels(setup, inputs, over_angle);

  cli::LinePlot plot;
  plot.title = labels.title(setup, family[0]);
  plot.x = labels.x();
  plot.y = labels.y();
  plot.x.logarithmic = x.is_logarithmic();
  const std::size_t most_members = std::max<std::size_t>(
      1, std::min<std::size_t>(6, most_pairs_of_laws / setup.joints.size()));
  int colour = 0;
  for (const NamedJoint& joint : setup.joints) {
    for (const double member : cli::spread(family, most_members)) {
      const std::string label = labels.curve(joint, member);
      ++colour;
      const int own = labels.colour(joint, colour);
      cli::Curve solved{label.empty() ? "solved" : label, {}, {}, false, own};
      cli::Curve traditional{
          colour == 1 ? "R as the normal force" : "", {}, {}, true, own};
      for (const double value : cli::spread(x, most_points)) {
        const Answer a = answer(joint, inputs.question(),
                                over_angle ? inputs.at(member, value, rate)
                                           : inputs.at(value, member, rate));
        const double moment = contact::magnitude(a.solution().friction_moment);
        solved.x.push_back(value);
        solved.y.push_back(labels.drawn(moment, a));
        traditional.x.push_back(value);
        traditional.y.push_back(labels.drawn(a.traditional, a));
      }
      plot.curves.push_back(std::move(solved));
      if (reaction) plot.curves.push_back(std::move(traditional));
    }
  }
  plot.y.logarithmic = plot.x.logarithmic && cli::is_wide(plot.curves);
  return cli::draw(plot, file);
}

}  // namespace hinge_joint
