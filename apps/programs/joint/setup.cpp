#include "programs/joint/setup.hpp"

#include <optional>

#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

// Dry friction whose f0 is to be found.
contact::FrictionLaw adhesion_alone(
    const Options& options,
    const std::optional<contact::FrictionModel>& of_joint) {
  const std::string& adhesion = options.friction.adhesion;
  if (!adhesion.empty()) {
    return contact::FrictionLaw(0, cli::parse_adhesion(adhesion));
  }
  if (!of_joint) return contact::FrictionLaw(0);
  const auto* dry = std::get_if<contact::FrictionLaw>(&*of_joint);
  if (dry == nullptr) {
    cli::refuse_without("--measured-moment",
                        "--adhesion: the joint's friction is not dry");
  }
  return contact::FrictionLaw(0, dry->adhesion());
}

contact::FrictionModel friction_of(
    const Options& options,
    const std::optional<contact::FrictionModel>& of_joint) {
  return options.measured_moment.empty()
             ? make_friction(options.friction, of_joint, options.joint)
             : adhesion_alone(options, of_joint);
}

}  // namespace

Setup make_setup(const Options& options) {
  Setup setup{.given = make_joints(options.joint), .joints = {}};
  for (const cli::Joint& joint : setup.given) {
    if (joint.kind() != setup.given[0].kind()) {
      throw contact::Error(contact::detail::must_be(
          "the joints of --joint and --set", "all balls or all pins"));
    }
    const contact::FrictionModel friction =
        friction_of(options, joint.spec.friction);
    for (std::size_t i = 0; i < joint.laws.size(); ++i) {
      const cli::NamedLaw& law = joint.laws[i];
      for (std::size_t j = 0; j < joint.pressures.size(); ++j) {
        NamedJoint& added = setup.joints.emplace_back(
            NamedJoint{law.name,
                       joint.pressures[j].name,
                       contact::Joint(joint.contact(friction, i, j)),
                       {},
                       joint.differences,
                       options.pv});
        if (cli::JointApproach::of(*law.law)) {
          added.approach.emplace(law.law, joint);
        }
      }
    }
  }
  return setup;
}

}  // namespace hinge_joint
