#include "pressure/pressure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_pressure {
namespace {

constexpr int points = 201;
// What a legend holds.
constexpr std::size_t most_curves = 15;
constexpr double megapascal = 1e6;

// "2000 N", "μ = 0.5"
std::string load_text(const cli::Joint& joint, const LoadedContact& contact) {
  const bool ball = joint.kind == contact::JointKind::ball;
  if (!joint.geometry) {
    return fmt::format("{} = {:.6g}", ball ? "μ" : "λ", contact.load_parameter);
  }
  return fmt::format("{:.6g} {}", contact.load, ball ? "N" : "N/m");
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

}  // namespace

std::string draw(const PressureTable& pressures, const cli::Joint& joint,
                 const LoadedContacts& contacts, const std::string& file) {
  const std::vector<NamedPressure>& laws = joint.pressures;
  const bool pascal = joint.geometry.has_value();
  cli::LinePlot plot;
  plot.title = joint.title();
  if (joint.conditions.loading.is_back()) {
    plot.title += ", loading " + to_string(joint.conditions.loading);
  }
  plot.x_label = "angle from the centre of the contact, deg";
  plot.y_label = pascal ? "pressure, MPa"
                 : joint.kind == contact::JointKind::ball
                     ? "pressure over Rₙ/ρ²"
                     : "pressure over P/ρ";
  // Several laws have the colours, and the title the loads; one law leaves the
  // colours to the loads.
  const bool one_law = laws.size() == 1;
  const auto shown = shown_contacts(
      contacts, std::max<std::size_t>(most_curves / laws.size(), 1));
  plot.family = one_law && shown.size() > 1;
  if (one_law) plot.title += ", " + laws[0].name;
  if (!one_law && contacts.size() > 1) {
    std::string loads;
    for (const LoadedContact& contact : shown) {
      loads += (loads.empty() ? "" : "; ") + load_text(joint, contact);
    }
    plot.title += ": " + loads;
  }
  for (const LoadedContact& contact : shown) {
    for (std::size_t i = 0; i < laws.size(); ++i) {
      const bool first = plot.curves.size() < laws.size();
      cli::Curve curve{one_law ? load_text(joint, contact)
                       : first ? laws[i].name
                               : "",
                       {},
                       {}};
      curve.dashed = !one_law && laws[i].name.starts_with("exact");
      curve.colour = one_law ? 0 : static_cast<int>(i) + 1;
      for (int j = 0; j < points; ++j) {
        const double theta = contact.half_angle * j / (points - 1);
        curve.x.push_back(theta / contact::degree);
        curve.y.push_back(pressures.pressure(laws[i], contact, theta) /
                          (pascal ? megapascal : 1));
      }
      plot.curves.push_back(std::move(curve));
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_pressure
