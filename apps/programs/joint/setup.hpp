#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "cli/joint/friction_options.hpp"
#include "cli/joint/joint_approach.hpp"
#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"
#include "libcontact/joint/joint.hpp"

namespace hinge_joint {

/// The command line of hinge-joint as it was written; "" for options that
/// were not given.
struct Options {
  cli::JointOptions joint = {.use = cli::JointUse::friction};
  cli::FrictionOptions friction;
  std::string measured_moment;

  std::string reaction_xyz;
  std::string rate_xyz;
  std::string moment_xyz;
  std::string reaction;
  std::string beta;
  std::string normal_force;
  std::string alpha;
  std::string rate;
  std::string points;

  bool trace = false;
  std::string outer;
  std::string joints;
  std::string braking;
  std::string inner_steps;

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
  /// Of the half-angle law exact.
  std::optional<cli::JointApproach> approach;
  std::vector<cli::Difference> differences = {};
  /// Whether p v and heat are wanted.
  bool pv = false;
};

/// The joints that are asked for, all of one kind, each once for each pair of
/// laws.
struct Setup {
  std::vector<cli::Joint> given;
  std::vector<NamedJoint> joints;

  /// Whether f0 is that of --measured-moment.
  bool friction_found = false;

  /// Whether any of them has one.
  bool has_approach() const {
    return std::ranges::any_of(joints, [](const NamedJoint& joint) {
      return joint.approach.has_value();
    });
  }
};

/// Throws contact::Error if the options do not fit together or a value is not
/// allowed.
Setup make_setup(const Options& options);

}  // namespace hinge_joint
