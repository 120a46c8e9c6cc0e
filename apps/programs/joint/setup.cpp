#include "programs/joint/setup.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/seat/contact.hpp"

namespace hinge_joint {
namespace {

// With --measured-moment f0 is computed later.
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

bool are_several(const std::vector<std::string>& laws) {
  return laws.size() > 1 || (laws.size() == 1 && laws[0] == "all");
}

// The option that requires an axisymmetric contact; "" if there is none.
std::string_view endless_question(const Options& o) {
  const std::pair<bool, std::string_view> questions[] = {
      {o.trace, "--trace"},
      {o.outer.has_value(), "--outer"},
      {o.equivalent, "--equivalent"},
      {!o.kernel.language.empty(), "--kernel"},
      {o.measured_moment.has_value(), "--measured-moment"},
      {!o.map.empty(), "--map"},
      {are_several(o.joint.laws), "several --law"},
      {are_several(o.joint.pressures), "several --pressure"},
      {!o.joint.limit_angle.empty(), "--limit-angle"}};
  for (const auto& [asked, question] : questions) {
    if (asked) return question;
  }
  return {};
}

// The joint in its seat.
NamedJoint in_seat(const Options& options, const cli::Joint& joint,
                   contact::SharedLaws& laws) {
  const contact::JointSpec spec =
      asked_spec(joint, *joint.spec.friction, options.joint);
  NamedJoint confined{spec.half_angle_law,        spec.pressure_law,
                      contact::Joint(spec, laws), {},
                      joint.differences,          options.pv};
  confined.approach.emplace(laws.half_angle(spec), joint);
  return confined;
}

bool has_relief(const contact::JointSpec& spec) {
  return spec.relief.kind() != contact::Relief::Kind::none;
}

// True if the contact is not without end, whatever ends it.
bool asks_model(const Options& options, const contact::JointSpec& spec) {
  if (options.tilt.given()) return true;
  const auto is_exact = [](const std::vector<std::string>& laws) {
    return laws.empty() || (laws.size() == 1 && laws[0] == "exact");
  };
  return !spec.without_seat().is_endless() &&
         endless_question(options).empty() && is_exact(options.joint.laws) &&
         is_exact(options.joint.pressures);
}

// The joint by its own model, which has the exact laws; the same where there is
// none after all, as contact() then notes.
NamedJoint modelled(const Options& options, contact::JointSpec spec,
                    const NamedJoint& endless, contact::SharedLaws& laws) {
  spec.half_angle_law = spec.pressure_law = "exact";
  spec.half_angle_options = {};
  const contact::Joint model(spec, laws);
  if (model.is_endless() && !options.tilt.given()) return endless;
  NamedJoint ends{"exact", "exact", model, {}, endless.differences, endless.pv};
  ends.ends = true;
  return ends;
}

void check_in_seat(const Options& options, Pointing pointing,
                   const contact::SeatZone& seat) {
  if (const auto question = endless_question(options); !question.empty()) {
    cli::refuse_without(std::string(question) + " with a [seat]",
                        "--without-seat");
  }
  if (pointing == Pointing::angle && !seat.is_about_z()) {
    const bool points = !options.points.empty();
    cli::refuse_without(
        std::string(points ? "b_deg of --points" : "--reaction") +
            " with a seat about another axis than z",
        points ? "vectors or --without-seat"
               : "--reaction-xyz or --without-seat");
  }
}

}  // namespace

void give_ends(const Options& options, Pointing pointing, Setup& setup) {
  const auto any = [&](const auto& has) {
    return std::any_of(setup.given.begin(), setup.given.end(),
                       [&](const cli::Joint& j) { return has(j.spec); });
  };
  const auto has_seat = [](const contact::JointSpec& spec) {
    return spec.geometry.seat().has_value();
  };
  if (options.without_seat && !any(has_seat)) {
    cli::refuse_without("--without-seat", "a joint with a [seat]");
  }
  if (options.without_relief && !any(has_relief)) {
    cli::refuse_without("--without-relief", "a joint with a [relief]");
  }
  const bool in_seats = !options.without_seat && pointing != Pointing::nowhere;
  contact::SharedLaws laws;
  auto joint = setup.joints.begin();
  for (cli::Joint& given : setup.given) {
    const std::size_t pairs = given.laws.size() * given.pressures.size();
    const contact::JointSpec spec =
        options.without_relief ? given.spec.without_relief() : given.spec;
    if (const auto& seat = spec.geometry.seat(); seat && in_seats) {
      check_in_seat(options, pointing, *seat);
      *joint = in_seat(options, given, laws);
      given.laws = {{joint->law, laws.half_angle(given.spec)}};
    } else if (asks_model(options, spec)) {
      *joint = modelled(options, spec, *joint, laws);
      if (joint->ends) {
        given.spec = given.spec.endless();  // so that no end is noted
        given.laws = {{joint->law, laws.half_angle(given.spec)}};
      }
    }
    joint += static_cast<std::ptrdiff_t>(pairs);
  }
}

Setup make_setup(const Options& options) {
  Setup setup{.given = make_joints(options.joint), .joints = {}};
  for (cli::Joint& joint : setup.given) {
    if (joint.kind() != setup.given[0].kind()) {
      throw contact::Error(contact::detail::must_be(
          "the joints of --joint and --set", "all balls or all pins"));
    }
    const contact::FrictionModel friction =
        friction_of(options, joint.spec.friction);
    joint.spec.friction = friction;
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
