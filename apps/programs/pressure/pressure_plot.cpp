#include "programs/pressure/pressure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "cli/plot.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_pressure {
namespace {

constexpr int curve_points = 201;

// "2000 N", "μ = 0.5"
std::string load_text(const cli::Joint& joint, const LoadedContact& contact) {
  const bool ball = joint.kind() == contact::JointKind::ball;
  if (!joint.has_size) {
    return fmt::format("{} = {:.6g}", ball ? "μ" : "λ", contact.load_parameter);
  }
  return fmt::format("{:.6g} {}", contact.load,
                     hinge_angle::Loads(joint).unit());
}

// At most `most` of the contacts, evenly spread.
std::vector<LoadedContact> shown_contacts(const LoadedContacts& contacts,
                                          std::size_t most) {
  const std::size_t count = std::min(most, contacts.size());
  std::vector<LoadedContact> shown;
  for (std::size_t k = 0; k < count; ++k) {
    shown.push_back(
        contacts[count == 1 ? 0 : k * (contacts.size() - 1) / (count - 1)]);
  }
  return shown;
}

// Common and distinct properties of curves. With two laws the second is dashed,
// and colours distinguish joints and loads; with more laws colours distinguish
// the laws, and the title lists the loads.
struct Labels {
  bool joints;
  bool loads;
  std::size_t laws;

  bool laws_have_colours() const {
    return laws > 2 || (laws == 2 && !family());
  }
  bool family() const { return joints || loads; }

  std::string curve(const cli::Joint& joint, const LoadedContact& contact,
                    std::size_t law) const {
    if (laws_have_colours()) return joint.pressures[law].name;
    if (law > 0) return "";
    std::string text = difference_label(joint.differences);
    if (loads || !joints) {
      text += (text.empty() ? "" : ", ") + load_text(joint, contact);
    }
    return text;
  }
  std::string title(const std::vector<cli::Joint>& all,
                    const std::vector<LoadedContact>& contacts) const {
    const cli::Joint& joint = all[0];
    std::string text = shared_title(all, "");
    if (text.empty()) text = "pressure";
    if (joint.spec.loading.is_back()) {
      text += ", loading " + to_string(joint.spec.loading);
    }
    if (laws == 1) text += ", " + joint.pressures[0].name;
    if (laws == 2 && family()) {
      text += fmt::format(", {}; dashed: {}", joint.pressures[0].name,
                          joint.pressures[1].name);
    }
    const bool loads_in_title = laws_have_colours() ? loads : joints && !loads;
    for (std::size_t i = 0; loads_in_title && i < contacts.size(); ++i) {
      text += (i == 0 ? ": " : "; ") + load_text(joint, contacts[i]);
    }
    return text;
  }
};

cli::Curve curve_of(const PressureTable& table, std::size_t law,
                    const LoadedContact& contact) {
  cli::Curve curve;
  for (int j = 0; j < curve_points; ++j) {
    const double theta = contact.half_angle * j / (curve_points - 1);
    curve.x.push_back(theta / contact::degree);
    curve.y.push_back(table.pressure(law, contact, theta));
  }
  return curve;
}

}  // namespace

void check_curves(const std::vector<cli::Joint>& joints) {
  const std::size_t laws = joints[0].pressures.size();
  if (joints.size() > 1 && laws > 2) {
    cli::refuse_without("--plot", "one joint, or at most two pressure laws");
  }
  cli::check_curves(joints.size() * laws);
}

std::string draw(const std::vector<PressureTable>& tables,
                 const std::vector<cli::Joint>& joints,
                 const std::vector<LoadedContacts>& contacts,
                 const std::string& file) {
  const cli::Joint& first = joints[0];
  const std::size_t laws = first.pressures.size();
  const auto shown = [&](std::size_t j) {
    return shown_contacts(contacts[j], cli::most_curves / laws / joints.size());
  };
  const Labels labels{joints.size() > 1, shown(0).size() > 1, laws};
  cli::LinePlot plot;
  plot.title = labels.title(joints, shown(0));
  plot.x = {"angle from the centre of the contact", "deg"};
  plot.y = first.has_size ? cli::Axis{"pressure", "Pa"}
                          : cli::Axis{"pressure over nominal"};
  plot.family = labels.family() && laws == 1;
  int group = 0;  // a joint and a load
  for (std::size_t j = 0; j < joints.size(); ++j) {
    for (const LoadedContact& contact : shown(j)) {
      ++group;
      for (std::size_t i = 0; i < laws; ++i) {
        const NamedPressure& law = joints[j].pressures[i];
        cli::Curve curve = curve_of(tables[j], i, contact);
        const bool by_law = labels.laws_have_colours();
        if (!by_law || group == 1) {
          curve.label = labels.curve(joints[j], contact, i);
        }
        curve.dashed = by_law ? law.name.starts_with("exact") : i == 1;
        if (!plot.family) {
          const int colour = cli::law_colour(law.name);
          curve.colour = !by_law      ? group
                         : colour > 0 ? colour
                                      : static_cast<int>(i) + 1;
        }
        plot.curves.push_back(std::move(curve));
      }
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_pressure
