#include "programs/joint/setup.hpp"

#include <optional>

#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

// With --measured-moment f0 is to be found.
contact::FrictionModel friction_of(
    const Options& options,
    const std::optional<contact::FrictionModel>& of_joint) {
  if (!options.measured_moment) {
    return make_friction(options.friction, of_joint, options.joint);
  }
  const std::optional<double>& adhesion = options.friction.adhesion;
  if (adhesion) return contact::FrictionLaw(0, *adhesion);
  cli::FrictionOptions none;
  none.coefficient = 0;
  return dry_friction(none, of_joint, "--measured-moment",
                      "--adhesion: the joint's friction is not dry");
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
