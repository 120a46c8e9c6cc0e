#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/factory.hpp"

/// The laws of half-angle and pressure that options name.
namespace cli {

/// A half-angle law under the name by which it was asked for; with a loading
/// through the back, that goes with it: "exact_back:20".
struct NamedLaw {
  std::string name;
  std::shared_ptr<const contact::HalfAngleLaw> law;
};

/// A pressure law under the name by which it was asked for, and with the
/// loading if it depends on that.
struct NamedPressure {
  std::string name;
  std::shared_ptr<const contact::PressureLaw> law;
};

/// Loading by --loading, `otherwise` if it is not given. Throws contact::Error
/// for anything but centre and back:PSI.
contact::InnerLoading parse_loading(const std::string& text,
                                    const contact::InnerLoading& otherwise);

/// Names of the half-angle laws that --law asks for: `otherwise` if it was not
/// given; for "all" those that allow the conditions, but paper (which is one of
/// the others). Throws contact::Error if a name is there twice: columns are
/// called by them.
std::vector<std::string> half_angle_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions);
/// The same of --pressure.
std::vector<std::string> pressure_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions);

/// Heeds --limit-angle: formula, linear or degrees; "" changes nothing.
/// Throws contact::Error for anything else, and if none of the laws has a
/// limit half-angle to set.
void set_limit_angle(const std::string& text,
                     const std::vector<std::string>& laws,
                     contact::HalfAngleOptions& options);

/// A name with the loading, if the law depends on it.
std::string with_loading(const std::string& name,
                         const contact::InnerLoading& loading);

/// Notes on half-angle laws outside their ranges: each reason once, with its
/// laws: "law tanh, blend: the limit half-angle is ..."
std::vector<std::string> law_notes(const std::vector<NamedLaw>& laws,
                                   const contact::ElasticPair& pair);

/// A law's colour in all pictures, a line type of plots/style.gp; 0 for a law
/// that has none.
int law_colour(std::string_view name);

}  // namespace cli
