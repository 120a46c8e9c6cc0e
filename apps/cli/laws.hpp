#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/half_angle.hpp"
#include "libcontact/joint_geometry.hpp"
#include "libcontact/material.hpp"
#include "libcontact/pressure.hpp"

/// The laws of half-angle and pressure that options name. One place for all
/// programs, so that the same mistake has the same message.
namespace cli {

/// A half-angle law under the name by which it was asked for.
struct NamedLaw {
  std::string name;
  std::shared_ptr<const contact::HalfAngleLaw> law;
};

/// A pressure law under the name by which it was asked for.
struct NamedPressure {
  std::string name;
  std::shared_ptr<const contact::PressureLaw> law;
};

/// Names of the half-angle laws that --law asks for: `otherwise` if it was not
/// given, all but paper (which is one of the others) for "all". Throws
/// contact::Error if a name is there twice: columns are called by them.
std::vector<std::string> half_angle_laws(const std::vector<std::string>& asked,
                                         std::vector<std::string> otherwise);
/// The same of --pressure.
std::vector<std::string> pressure_laws(const std::vector<std::string>& asked,
                                       std::vector<std::string> otherwise);

/// Heeds --limit-angle: formula, linear or degrees; "" changes nothing.
/// Throws contact::Error for anything else, and if none of the laws has a
/// limit half-angle to set.
void set_limit_angle(const std::string& text,
                     const std::vector<std::string>& laws,
                     contact::HalfAngleOptions& options);

/// The laws of these names. Throws contact::Error if there is no such law.
std::vector<NamedLaw> make_half_angle_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair, const contact::HalfAngleOptions& options);
std::vector<NamedPressure> make_pressure_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair);

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
