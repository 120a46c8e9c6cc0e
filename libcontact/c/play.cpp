#include "libcontact/c/play.h"

#include <cmath>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/play/impact.hpp"
#include "libcontact/play/play_joint.hpp"

/// Joint with play that C holds.
struct contact_play  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  contact_play(const contact::JointSpec& spec,
               const contact::PlayJoint::Options& options)
      : impact(spec), joint(spec, options, impact.force_law()) {}

  const contact::JointImpact impact;
  const contact::PlayJoint joint;
};

namespace contact::c {
namespace {

PlayJoint::Options options_of(const contact_play_options* given) {
  PlayJoint::Options options;
  if (!given) return options;
  options.damping = given->restitution == 0
                        ? HuntCrossley(given->damping)
                        : HuntCrossley::from_restitution(
                              given->restitution, given->reference_speed);
  if (given->regularisation_speed != 0) {
    options.regularisation_speed = given->regularisation_speed;
  }
  return options;
}

PlayMotion motion_of(const contact_play_motion& m) {
  const auto vector = [](const double* v) {
    return Eigen::Vector3d(v[0], v[1], v[2]);
  };
  return {vector(m.position), vector(m.velocity), vector(m.angular_velocity),
          vector(m.axis)};
}

contact_status out_of_range(const char* name, double value, double end) {
  return contact_report(
      CONTACT_OUT_OF_RANGE,
      detail::must_be(detail::message("{} = {}", name, value),
                      detail::message("at most {:.4g}, where the force law "
                                      "ends",
                                      end))
          .c_str());
}

}  // namespace
}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::emptied;
using contact::c::given;

contact_status contact_play_make(const contact_joint* joint,
                                 const contact_play_options* options,
                                 contact_play** play) {
  return call([=] {
    contact_play** const to = emptied(play, "contact_play_make: play");
    *to = new contact_play(given(joint, "contact_play_make: joint").spec,
                           contact::c::options_of(options));
    return CONTACT_OK;
  });
}

void contact_play_free(contact_play* play) { contact::c::give_back(play); }

contact_status contact_play_force_law(const contact_play* play,
                                      double penetration,
                                      contact_force_state* state) {
  return call_for(
      [=] {
        const contact::ForceLaw& law =
            given(play, "contact_play_force_law: play").joint.force_law();
        const contact::ForceState s = law.at(penetration);
        given(state, "contact_play_force_law: state") = {
            s.force,      s.slope,       s.energy,
            s.half_angle, s.force_ratio, s.half_angle_slope};
        if (!std::isnan(s.force)) return CONTACT_OK;
        return contact::c::out_of_range("contact_play_force_law: penetration",
                                        penetration, law.largest_penetration());
      },
      state);
}

contact_status contact_play_largest_penetration(const contact_play* play,
                                                double* penetration) {
  return call_for(
      [=] {
        given(penetration, "contact_play_largest_penetration: penetration") =
            given(play, "contact_play_largest_penetration: play")
                .joint.force_law()
                .largest_penetration();
        return CONTACT_OK;
      },
      penetration);
}

contact_status contact_play_impact(const contact_play* play, double mass,
                                   double speed, contact_impact* impact) {
  return call_for(
      [=] {
        const contact_play& of = given(play, "contact_play_impact: play");
        const contact::Impact i = of.impact(of.joint.damping(), mass, speed);
        given(impact, "contact_play_impact: impact") = {
            i.restitution,      i.penetration,     i.elastic_force,
            i.peak_force,       i.half_angle,      i.peak_pressure,
            i.compression_time, i.restitution_time};
        if (!std::isnan(i.penetration)) return CONTACT_OK;
        return contact_report(CONTACT_OUT_OF_RANGE,
                              of.impact.notes(i, 0).front().c_str());
      },
      impact);
}

contact_status contact_play_evaluate(const contact_play* play,
                                     const contact_play_motion* motion,
                                     contact_play_force* force,
                                     double* derivatives) {
  return call_for(
      [=] {
        const contact::PlayJoint& joint =
            given(play, "contact_play_evaluate: play").joint;
        const contact::PlayMotion at = contact::c::motion_of(
            given(motion, "contact_play_evaluate: motion"));
        contact_play_force& to = given(force, "contact_play_evaluate: force");
        contact::PlayDerivatives d;
        const contact::PlayForce f = derivatives ? joint(at, d) : joint(at);
        if (derivatives) {
          Eigen::Map<Eigen::Matrix<double, 6, 9, Eigen::RowMajor>>{
              derivatives} = d;
        }
        to = {{f.force.x(), f.force.y(), f.force.z()},
              {f.moment.x(), f.moment.y(), f.moment.z()},
              f.penetration,
              f.normal_force,
              f.energy,
              f.damping_power,
              f.friction_power};
        if (!std::isnan(f.normal_force)) return CONTACT_OK;
        return contact::c::out_of_range(
            "contact_play_evaluate: penetration", f.penetration,
            joint.force_law().largest_penetration());
      },
      force);
}

contact_status contact_play_motion_notes(const contact_play* play,
                                         const contact_play_motion* motion,
                                         char* text, std::size_t size) {
  return call([=] {
    if (size > 0) given(text, "contact_play_motion_notes: text");
    return contact::c::hand_over_notes(
        given(play, "contact_play_motion_notes: play")
            .joint.notes(contact::c::motion_of(
                given(motion, "contact_play_motion_notes: motion"))),
        text, size);
  });
}

contact_status contact_play_impact_notes(const contact_play* play, double mass,
                                         double speed, double density,
                                         char* text, std::size_t size) {
  return call([=] {
    const contact_play& of = given(play, "contact_play_impact_notes: play");
    if (size > 0) given(text, "contact_play_impact_notes: text");
    return contact::c::hand_over_notes(
        of.impact.notes(of.impact(of.joint.damping(), mass, speed), density),
        text, size);
  });
}
