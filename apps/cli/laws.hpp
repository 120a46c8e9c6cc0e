#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/factory.hpp"

namespace CLI {
class App;
}

/// The laws of half-angle and pressure that options name. One place for all
/// programs, so that the same mistake has the same message.
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

/// What --help says of --loading.
inline constexpr std::string_view loading_help =
    "Loading: centre (the force enters the ball or pin by a stem or shaft, or "
    "is its\n"
    "own weight; the default) or back:PSI (a loose ball or roller pressed from "
    "behind\n"
    "on a patch of half-angle PSI, 0 to 90 deg, by a uniform pressure). Only "
    "the\n"
    "half-angle law exact knows the latter, its name in the output is then\n"
    "exact_back:PSI; the pressure law exact follows it, mixture is refused.\n"
    "Walls and coatings are in joint files: [wall] and [[coating]]. With them "
    "all\n"
    "laws are exact, others are refused.\n";

/// Adds --loading.
void add_loading_option(CLI::App& app, std::string& loading,
                        const std::string& group);
/// What --loading says, `otherwise` if it was not given. Throws contact::Error
/// for a text that is not allowed.
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

/// The laws of these names. Throws contact::Error if there is no such law, or
/// if it does not allow the conditions.
std::vector<NamedLaw> make_half_angle_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair, const contact::HalfAngleOptions& options,
    const contact::ContactConditions& conditions);
NamedPressure make_pressure_law(const std::string& name,
                                contact::JointKind kind,
                                const contact::ElasticPair& pair,
                                const contact::ContactConditions& conditions);
std::vector<NamedPressure> make_pressure_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair,
    const contact::ContactConditions& conditions);

/// The pair of --modulus-ratio, --poisson1 and --poisson2. Throws
/// contact::Error for values that are not allowed.
contact::ElasticPair pair_of_modulus_ratio(std::string_view ratio,
                                           std::string_view poisson1,
                                           std::string_view poisson2);

/// Where half-angle laws are used outside their ranges: each reason once,
/// with the laws that it holds for.
class LawNotes {
 public:
  LawNotes() = default;
  LawNotes(const std::vector<NamedLaw>& laws, const contact::ElasticPair& pair);

  /// "law tanh, blend: the limit half-angle is ..."
  std::vector<std::string> texts() const;

 private:
  std::map<std::string, std::vector<std::string>> laws_by_reason_;
};

/// Warns of the use of a joint and of laws outside their ranges.
/// @param geometry  notes of the joint's geometry, if it has one
void warn_of_validity(std::string_view program,
                      const std::vector<std::string>& geometry,
                      const LawNotes& laws);

}  // namespace cli
