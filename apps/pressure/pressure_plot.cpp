#include "pressure/pressure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "cli/plot.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_pressure {
namespace {

constexpr int points = 201;
constexpr double megapascal = 1e6;

// "2000 N", "μ = 0.5"
std::string load_text(const cli::Joint& joint, const LoadedContact& contact) {
  const bool ball = joint.kind == contact::JointKind::ball;
  if (!joint.geometry) {
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

// What the curves of a picture have in common and in what they differ.
struct Labels {
  bool joints;
  bool laws;
  bool loads;

  std::string operator()(const cli::Joint& joint, const LoadedContact& contact,
                         const NamedPressure& law) const {
    std::string text = difference_text(joint.differences);
    const auto add = [&text](bool wanted, const std::string& part) {
      if (wanted) text += (text.empty() ? "" : ", ") + part;
    };
    add(loads, load_text(joint, contact));
    add(laws, law.name);
    return text;
  }
  std::string title(const cli::Joint& joint,
                    const LoadedContact& contact) const {
    std::string text = joints ? "" : joint.title();
    const auto add = [&text](bool wanted, const std::string& part) {
      if (wanted) text += (text.empty() ? "" : ", ") + part;
    };
    add(joint.conditions.loading.is_back(),
        "loading " + to_string(joint.conditions.loading));
    add(!loads, load_text(joint, contact));
    add(!laws, joint.pressures[0].name);
    return text;
  }
};

cli::Curve curve_of(const PressureTable& table, const NamedPressure& law,
                    const LoadedContact& contact, double unit) {
  cli::Curve curve;
  for (int j = 0; j < points; ++j) {
    const double theta = contact.half_angle * j / (points - 1);
    curve.x.push_back(theta / contact::degree);
    curve.y.push_back(table.pressure(law, contact, theta) / unit);
  }
  return curve;
}

}  // namespace

void check_curves(const std::vector<cli::Joint>& joints) {
  const std::size_t curves = joints.size() * joints[0].pressures.size();
  if (curves <= cli::most_curves) return;
  cli::refuse_without("--plot", fmt::format("at most {} curves; these are {}",
                                            cli::most_curves, curves));
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
  // The only curve is called by its load.
  const bool alone = joints.size() == 1 && laws == 1;
  const Labels labels{joints.size() > 1, laws > 1,
                      alone || shown(0).size() > 1};
  cli::LinePlot plot;
  plot.title = labels.title(first, contacts[0][0]);
  plot.x_label = "angle from the centre of the contact, deg";
  plot.y_label = first.geometry ? "pressure, MPa" : "pressure over nominal";
  // Several laws have the colours; one law leaves them to joints and loads.
  plot.family = !labels.laws && joints.size() * shown(0).size() > 1;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    for (const LoadedContact& contact : shown(j)) {
      for (std::size_t i = 0; i < laws; ++i) {
        const NamedPressure& law = joints[j].pressures[i];
        cli::Curve curve =
            curve_of(tables[j], law, contact, first.geometry ? megapascal : 1);
        curve.label = labels(joints[j], contact, law);
        curve.dashed = labels.laws && law.name.starts_with("exact");
        curve.colour = labels.laws ? static_cast<int>(i) + 1 : 0;
        plot.curves.push_back(std::move(curve));
      }
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_pressure
