#include "pressure/pressure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/plot.hpp"
#include "libcontact/units.hpp"

namespace hinge_pressure {
namespace {

constexpr int points = 201;
// What a legend holds.
constexpr std::size_t most_curves = 15;
constexpr double megapascal = 1e6;

std::string label(const hinge_angle::Setup& setup, const std::string& law,
                  const LoadedContact& contact, bool one_load) {
  if (one_load) return law;
  const bool ball = setup.kind == contact::JointKind::spherical;
  if (!setup.geometry) {
    return fmt::format("{}, {} = {:.3g}", law, ball ? "μ" : "λ",
                       contact.load_parameter);
  }
  return fmt::format("{}, {:.3g} {}", law, contact.load, ball ? "N" : "N/m");
}

}  // namespace

std::string draw(const PressureTable& pressures,
                 const hinge_angle::Setup& setup,
                 const std::vector<NamedPressure>& laws,
                 const LoadedContacts& contacts, const std::string& file) {
  const bool pascal = setup.geometry.has_value();
  cli::LinePlot plot;
  plot.title = fmt::format("{} joint", to_string(setup.kind));
  if (setup.loading.is_back()) {
    plot.title += ", loading " + to_string(setup.loading);
  }
  plot.x_label = "angle from the centre of the contact, deg";
  plot.y_label = pascal ? "pressure, MPa"
                 : setup.kind == contact::JointKind::spherical
                     ? "pressure over Rₙ/ρ²"
                     : "pressure over P/ρ";
  const std::size_t loads =
      std::clamp(most_curves / laws.size(), std::size_t{1}, contacts.size());
  for (std::size_t k = 0; k < loads; ++k) {
    const LoadedContact contact =
        contacts[loads == 1 ? 0 : k * (contacts.size() - 1) / (loads - 1)];
    for (std::size_t i = 0; i < laws.size(); ++i) {
      cli::Curve curve{
          label(setup, laws[i].name, contact, contacts.size() == 1), {}, {}};
      curve.dashed = laws[i].name.starts_with("exact");
      curve.colour = static_cast<int>(i) + 1;
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
