#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/factory.hpp"

/// Half-angle laws and pressure laws named by options.
namespace cli {

/// A half-angle law, and the name under which it was asked for; the name
/// includes a loading through the back: "exact_back:20".
struct NamedLaw {
  std::string name;
  std::shared_ptr<const contact::HalfAngleLaw> law;
};

/// A pressure law, and the name under which it was asked for; the name includes
/// the loading if the law depends on it.
struct NamedPressure {
  std::string name;
  std::shared_ptr<const contact::PressureLaw> law;
};

/// Loading given by --loading, else `otherwise`. Throws contact::Error for
/// anything but centre and back:PSI.
contact::InnerLoading parse_loading(const std::string& text,
                                    const contact::InnerLoading& otherwise);

/// Names of the half-angle laws given by --law, else `otherwise`. "all" selects
/// the laws that allow the conditions, except paper (it equals one of the
/// others). Throws contact::Error for repeated names, because columns carry
/// them.
std::vector<std::string> half_angle_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions);
/// As above, for --pressure.
std::vector<std::string> pressure_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions);

/// Applies --limit-angle: formula, linear or degrees; "" changes nothing.
/// Throws contact::Error for anything else, and if none of the laws has an
/// adjustable limit half-angle.
void set_limit_angle(const std::string& text,
                     const std::vector<std::string>& laws,
                     contact::HalfAngleOptions& options);

/// A law's name, with the loading if the law depends on it.
std::string with_loading(const std::string& name,
                         const contact::InnerLoading& loading);

/// Notes on half-angle laws outside their ranges. Each reason appears once with
/// its laws: "law tanh, blend: the limit half-angle is ..."
std::vector<std::string> law_notes(const std::vector<NamedLaw>& laws,
                                   const contact::ElasticPair& pair);

/// A law's colour in all pictures, a line type of plots/style.gp; 0 if it has
/// none.
int law_colour(std::string_view name);

}  // namespace cli
