#pragma once

#include <cstddef>

#include "cli/joint/joint_options.hpp"
#include "libcontact/half_angle/law.hpp"
#include "programs/angle/input.hpp"
#include "programs/angle/loads.hpp"

/// The parts of the program hinge-pressure.
namespace hinge_pressure {

/// A load and its contact.
struct LoadedContact {
  /// In the unit of hinge_angle::Loads; in dimensionless runs the load
  /// parameter.
  double load;
  double load_parameter;
  double half_angle;  ///< rad; NaN if the half-angle law has none
  contact::Status status;
};

/// The contacts for all loads of a sweep, computed on demand: a long sweep
/// takes no memory.
class LoadedContacts {
 public:
  /// @param input  a sweep of loads, not of half-angles; must outlive this, as
  ///               must the joint
  /// @param joint  with one half-angle law
  LoadedContacts(const hinge_angle::Input& input, const cli::Joint& joint)
      : input_(input), loads_(joint), law_(*joint.laws[0].law) {}

  std::size_t size() const { return input_.values.size(); }
  LoadedContact operator[](std::size_t index) const;
  const hinge_angle::Loads& loads() const { return loads_; }

 private:
  const hinge_angle::Input& input_;
  hinge_angle::Loads loads_;
  const contact::HalfAngleLaw& law_;
};

}  // namespace hinge_pressure
