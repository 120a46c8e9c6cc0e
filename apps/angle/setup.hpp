#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

/// The parts of the program hinge-angle.
namespace hinge_angle {

/// The command line of hinge-angle as it was written.
struct Options {
  std::string joint;
  std::string pair;
  std::string radius;
  std::string clearance;
  std::string modulus_ratio;
  std::string poisson1 = "0.3";
  std::string poisson2 = "0.3";

  std::string load;
  std::string load_parameter;
  std::string x;
  bool inverse = false;
  std::string theta0;
  bool compare = false;
  std::string tolerance = "0.1";

  // Without these: what the joint file says, or the program's defaults.
  std::vector<std::string> laws;
  std::string limit_angle;
  std::string loading;
  std::string pressure;
  cli::OutputOptions output;
};

/// What is known of a joint: without its geometry only dimensionless loads
/// and pressures.
struct Setup {
  contact::JointKind kind;
  contact::ElasticPair pair;
  std::optional<contact::JointGeometry> geometry = {};
  contact::HalfAngleOptions half_angle_options = {};
  std::vector<std::string> half_angle_laws = {
      std::string(contact::default_half_angle_law)};
  std::string pressure_law = "cosine";
  contact::ContactConditions conditions = {};
  /// Percent of theta0: what --compare calls good enough.
  double tolerance = 0.1;
  /// Of the joint file, or kind of the joint and name of the pair file; "" of
  /// bare numbers.
  std::string name = {};

  /// Of pictures.
  std::string title() const {
    return name.empty() ? to_string(kind) + " joint" : name;
  }

  /// What is to say about the geometry.
  std::vector<std::string> geometry_notes() const {
    return geometry ? geometry->validity_notes() : std::vector<std::string>();
  }
};

/// The joint, laws and limit angle that the options describe. Throws
/// contact::Error if they do not fit together or a value is not allowed.
Setup make_setup(const Options& options);

}  // namespace hinge_angle
