#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/joint/friction_options.hpp"
#include "cli/joint/joint_approach.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/joint/tilted_pins.hpp"
#include "cli/program.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/load_law/load_law.hpp"

namespace hinge_joint {

/// Ranges of the values.
inline constexpr cli::Allowed allowed_force{0, 1e100, "N"};
inline constexpr cli::Allowed allowed_rate{0, 1e100, "rad/s"};
inline constexpr cli::Allowed allowed_beta{0, 180, "deg"};
inline constexpr cli::Allowed allowed_alpha{-90, 90, "deg"};

/// The command line of hinge-joint as it was written; "" for options that
/// were not given.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::friction};
  cli::FrictionOptions friction;
  std::optional<double> measured_moment;  ///< N m

  std::optional<Eigen::Vector3d> reaction_xyz;
  std::optional<Eigen::Vector3d> rate_xyz;
  std::optional<Eigen::Vector3d> moment_xyz;
  std::string reaction;
  std::string beta;
  std::string normal_force;
  std::string alpha;
  std::string rate;
  std::string points;
  cli::TiltOptions tilt;
  std::optional<double> slide;  ///< m/s
  /// True: the contacts of joints with a seat extend beyond its rims.
  bool without_seat = false;
  bool without_relief = false;
  bool equivalent = false;
  /// An empty language means that no load law is wanted.
  contact::LoadLawOptions kernel = {.language = ""};

  bool trace = false;
  /// A reaction that depends on the friction moment: R = R_0 + M r, where M is
  /// the friction moment of all joints about Dw (5.1); r in N per N m.
  std::optional<Eigen::Vector3d> outer;
  int joints = 1;  ///< number of joints whose moments add up to M
  /// Angular acceleration per moment, deg/s^2 per N m.
  std::optional<double> braking;
  /// Steps of the inner loop in each round; the last number applies to all
  /// further rounds. Empty: until convergence.
  std::vector<int> inner_steps;

  bool summary = false;
  bool pv = false;
  std::string map;
  std::string beside;
  cli::OutputOptions output;
};

/// A joint with one half-angle law and one pressure law.
struct NamedJoint {
  std::string law;
  std::string pressure;
  contact::Joint joint;
  /// Approach of the bodies; only with the exact half-angle law.
  std::optional<cli::JointApproach> approach;
  std::vector<cli::Difference> differences = {};
  /// True if p v and heat are wanted.
  bool pv = false;
  /// True for a finite-length pin: with relief, or tilted.
  bool ends = false;

  /// True if the joint is in a seat that ends.
  bool has_rims() const { return !joint.is_endless() && !ends; }
  /// True without clearance or with interference.
  bool has_preload() const {
    return joint.contact().geometry().radial_clearance() <= 0;
  }
};

/// The joints asked for, all of one kind, each once for each pair of laws.
struct Setup {
  std::vector<cli::Joint> given;
  std::vector<NamedJoint> joints;

  /// True if f0 follows from --measured-moment.
  bool friction_found = false;

  template <class Predicate>
  bool has_any(const Predicate& of) const {
    return std::any_of(joints.begin(), joints.end(), of);
  }
  bool has_approach() const {
    return has_any(
        [](const NamedJoint& joint) { return joint.approach.has_value(); });
  }
  /// True if one of them has no clearance or has interference.
  bool has_preload() const {
    return has_any(std::mem_fn(&NamedJoint::has_preload));
  }
};

/// The joints, without the rims of their seats and the ends of their pins.
/// Throws contact::Error for options that conflict and values that are not
/// allowed.
Setup make_setup(const Options& options);

/// How states give the direction of a force.
enum class Pointing {
  nowhere,  ///< a normal force: contact in the middle of the seat
  angle,    ///< angle from Dw, which is along z
  vector,   ///< in the axes of the body with the seat
};

/// Adds the seats of joints, unless Options::without_seat, and the ends of pins
/// that have a relief or are tilted; these need the laws exact. A relief is
/// ignored by options that require an axisymmetric contact or another law.
/// Throws contact::Error for incompatible options.
void give_ends(const Options& options, Pointing pointing, Setup& setup);

}  // namespace hinge_joint
