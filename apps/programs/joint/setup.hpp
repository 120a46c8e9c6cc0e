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

/// Intervals of the values.
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
  /// Whether the contacts of joints with a seat go on beyond its rims.
  bool without_seat = false;
  bool equivalent = false;
  /// Its language "" if no load law is wanted.
  contact::LoadLawOptions kernel = {.language = ""};

  bool trace = false;
  /// A reaction that answers to the friction moment: R = R_0 + M r, with M the
  /// friction moment about Dw of all joints (5.1); r, N per N m.
  std::optional<Eigen::Vector3d> outer;
  int joints = 1;  ///< number of joints that give M
  /// Angular acceleration per moment, deg/s^2 per N m.
  std::optional<double> braking;
  /// Steps of the inner loop in each round, the last number for all further
  /// ones; none: until it has converged.
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
  /// Approach of the bodies, with the exact half-angle law alone.
  std::optional<cli::JointApproach> approach;
  std::vector<cli::Difference> differences = {};
  /// Whether p v and heat are wanted.
  bool pv = false;
  /// Whether it is a pin that ends: with relief, or tilted.
  bool ends = false;

  /// Whether it is in a seat that ends.
  bool has_rims() const { return !joint.is_endless() && !ends; }
  /// Whether it is without clearance or has interference.
  bool has_preload() const {
    return joint.contact().geometry().radial_clearance() <= 0;
  }
};

/// The joints that are asked for, all of one kind, each once for each pair of
/// laws.
struct Setup {
  std::vector<cli::Joint> given;
  std::vector<NamedJoint> joints;

  /// Whether f0 comes from --measured-moment.
  bool friction_found = false;

  template <class Predicate>
  bool has_any(const Predicate& of) const {
    return std::any_of(joints.begin(), joints.end(), of);
  }
  bool has_approach() const {
    return has_any(
        [](const NamedJoint& joint) { return joint.approach.has_value(); });
  }
  /// Whether any of them is without clearance or has interference.
  bool has_preload() const {
    return has_any(std::mem_fn(&NamedJoint::has_preload));
  }
};

/// The joints without the rims of their seats and the ends of their pins.
/// Throws contact::Error if the options do not fit together or a value is not
/// allowed.
Setup make_setup(const Options& options);

/// How states say where a force points.
enum class Pointing {
  nowhere,  ///< a normal force: the contact is in the middle of its seat
  angle,    ///< from Dw, which is along z
  vector,   ///< in the axes of the body with the seat
};

/// Puts the joints that have a seat in it, unless Options::without_seat, and
/// gives pins their ends that have a relief or are tilted: with the laws exact.
/// A relief is ignored by options that require a contact with an axis of
/// symmetry or another law. Throws contact::Error for incompatible options.
void give_ends(const Options& options, Pointing pointing, Setup& setup);

}  // namespace hinge_joint
