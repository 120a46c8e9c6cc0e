#include "libcontact/c/joint.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/files/joint_file.hpp"

namespace contact::c {
namespace {

JointKind kind_of(int kind) {
  switch (kind) {
    case CONTACT_BALL:
      return JointKind::ball;
    case CONTACT_PIN:
      return JointKind::pin;
  }
  throw Error(detail::must_be("contact_joint_make: kind",
                              "CONTACT_BALL or CONTACT_PIN"));
}

FrictionModel friction_of(const contact_joint_numbers& n) {
  if (n.viscous) return ViscousLaw(n.viscous_constant, n.viscous_slope);
  return FrictionLaw(n.coefficient, n.adhesion);
}

JointSpec spec_of(const contact_joint_numbers& n) {
  const JointBody inner =
      n.body_has_inner ? JointBody::body : JointBody::carrier;
  const auto material = [](const auto& m) {
    return Material{m.youngs_modulus, m.poissons_ratio};
  };
  const auto name = [](const char* given) { return given ? given : ""; };
  return {
      .geometry = kind_of(n.kind) == JointKind::ball
                      ? JointGeometry::ball(n.radius, n.radial_clearance, inner)
                      : JointGeometry::pin(n.radius, n.radial_clearance,
                                           n.length, inner),
      .inner = material(n.inner),
      .outer = material(n.outer),
      .friction = friction_of(n),
      .half_angle_law = name(n.half_angle_law),
      .pressure_law = name(n.pressure_law)};
}

// OK if all results are numbers; else the argument is to blame.
contact_status status_of(std::initializer_list<double> results,
                         std::string_view name, double argument,
                         std::string_view rule = "in the range of the laws") {
  if (std::ranges::none_of(results, [](double x) { return std::isnan(x); })) {
    return CONTACT_OK;
  }
  return contact_report(
      CONTACT_OUT_OF_RANGE,
      detail::must_be(detail::message("{} = {}", name, argument), rule)
          .c_str());
}

const JointContact& contact_of(const contact_joint* joint, const char* name) {
  return given(joint, name).joint.contact();
}

}  // namespace
}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::contact_of;
using contact::c::emptied;
using contact::c::given;
using contact::c::hand_over;
using contact::c::status_of;

contact_status contact_joint_read(const char* path,
                                  const contact_setting* settings,
                                  std::size_t count, contact_joint** joint) {
  return call([=] {
    contact_joint** const to = emptied(joint, "contact_joint_read: joint");
    return hand_over(
        to, contact::read_joint(&given(path, "contact_joint_read: path"),
                                contact::c::settings_of(settings, count,
                                                        "contact_joint_read")));
  });
}

contact_status contact_joint_parse(const char* text, const char* folder,
                                   const contact_setting* settings,
                                   std::size_t count, contact_joint** joint) {
  return call([=] {
    contact_joint** const to = emptied(joint, "contact_joint_parse: joint");
    return hand_over(
        to, contact::parse_joint(
                &given(text, "contact_joint_parse: text"), "joint",
                contact::c::settings_of(settings, count, "contact_joint_parse"),
                folder ? folder : ""));
  });
}

contact_status contact_joint_make(const contact_joint_numbers* numbers,
                                  contact_joint** joint) {
  return call([=] {
    contact_joint** const to = emptied(joint, "contact_joint_make: joint");
    return hand_over(
        to, contact::c::spec_of(given(numbers, "contact_joint_make: numbers")));
  });
}

void contact_joint_free(contact_joint* joint) { contact::c::give_back(joint); }

contact_status contact_joint_get_size(const contact_joint* joint,
                                      contact_joint_size* size) {
  return call([=] {
    const auto& contact = contact_of(joint, "contact_joint_get_size: joint");
    const contact::JointGeometry& g = contact.geometry();
    given(size, "contact_joint_get_size: size") = {
        g.kind() == contact::JointKind::ball ? CONTACT_BALL : CONTACT_PIN,
        g.inner_body() == contact::JointBody::body,
        g.radius(),
        g.radial_clearance(),
        g.length(),
        contact.pair().effective_modulus(),
        contact.geometry().seat().has_value()};
    return CONTACT_OK;
  });
}

const char* contact_joint_note(const contact_joint* joint, std::size_t i) {
  return joint && i < joint->notes.size() ? joint->notes[i].c_str() : nullptr;
}

contact_status contact_joint_contact_notes(const contact_joint* joint,
                                           double half_angle,
                                           double peak_pressure, char* text,
                                           std::size_t size) {
  return call([=] {
    if (size > 0) given(text, "contact_joint_contact_notes: text");
    contact::LargestContact largest;
    largest.add(half_angle, peak_pressure);
    return contact::c::hand_over_notes(
        contact_of(joint, "contact_joint_contact_notes: joint")
            .limits()
            .notes(largest),
        text, size);
  });
}

contact_status contact_joint_patch(const contact_joint* joint,
                                   double normal_force, contact_patch* patch) {
  return call_for(
      [=] {
        const auto& contact = contact_of(joint, "contact_joint_patch: joint");
        contact_patch& p = given(patch, "contact_joint_patch: patch");
        p.load_parameter = contact.load_parameter(normal_force);
        p.half_angle = contact.half_angle(normal_force).half_angle;
        p.peak_pressure = contact.peak_pressure(normal_force, p.half_angle);
        p.mean_pressure = contact.mean_pressure(normal_force, p.half_angle);
        p.area = contact.area(p.half_angle);
        return status_of({p.half_angle, p.peak_pressure, p.mean_pressure},
                         "contact_joint_patch: normal_force", normal_force);
      },
      patch);
}

contact_status contact_joint_normal_force(const contact_joint* joint,
                                          double half_angle,
                                          double* normal_force) {
  return call_for(
      [=] {
        const auto& contact =
            contact_of(joint, "contact_joint_normal_force: joint");
        const contact::LoadScale scale(contact.geometry(), contact.pair());
        double& force =
            given(normal_force, "contact_joint_normal_force: normal_force");
        const auto& geometry = contact.geometry();
        const auto& law = contact.half_angle_law();
        force = geometry.force_from_load(
            scale.load(law.load_parameter(half_angle).load_parameter /
                       law.load_factor(geometry.relative_clearance())));
        // Half-angles of another sign of the clearance.
        if (force < 0) force = std::numeric_limits<double>::quiet_NaN();
        return status_of({force}, "contact_joint_normal_force: half_angle",
                         half_angle);
      },
      normal_force);
}

contact_status contact_joint_pressure(const contact_joint* joint,
                                      double normal_force, double theta,
                                      double* pressure) {
  return call_for(
      [=] {
        const auto& contact =
            contact_of(joint, "contact_joint_pressure: joint");
        double& p = given(pressure, "contact_joint_pressure: pressure");
        p = contact.pressure(theta, normal_force,
                             contact.half_angle(normal_force).half_angle);
        if (std::isnan(theta)) {
          return status_of({theta}, "contact_joint_pressure: theta", theta,
                           "a number");
        }
        return status_of({p}, "contact_joint_pressure: normal_force",
                         normal_force);
      },
      pressure);
}

contact_status contact_joint_approach(const contact_joint* joint,
                                      double normal_force, double* approach,
                                      double* stiffness) {
  return call_for(
      [=] {
        const auto& contact =
            contact_of(joint, "contact_joint_approach: joint");
        double& delta = given(approach, "contact_joint_approach: approach");
        double& slope = given(stiffness, "contact_joint_approach: stiffness");
        const double half_angle = contact.half_angle(normal_force).half_angle;
        const auto value = contact.approach(half_angle);
        delta = value.approach;
        slope = value.stiffness;
        if (normal_force > 0 && !std::isnan(half_angle) && std::isnan(delta)) {
          return contact_report(
              CONTACT_OUT_OF_RANGE,
              "contact_joint_approach: joint must have an approach: the "
              "half-angle law \"exact\", a load through its centre, and no pin "
              "in an infinite hole");
        }
        return status_of({delta, slope}, "contact_joint_approach: normal_force",
                         normal_force, "above 0 and in the range of the laws");
      },
      approach, stiffness);
}

contact_status contact_joint_friction(const contact_joint* joint,
                                      double half_angle, double slip_axis_angle,
                                      contact_friction* friction) {
  return call_for(
      [=] {
        const auto& contact =
            contact_of(joint, "contact_joint_friction: joint");
        if (contact.stress()) {
          throw contact::Error(
              contact::detail::must_be("contact_joint_friction: joint",
                                       "one whose friction coefficients depend "
                                       "on half-angle and slip axis "
                                       "alone, dry or viscous"));
        }
        const auto i = contact.integrals(
            half_angle, contact::SlipAxis::from_angle(slip_axis_angle));
        given(friction, "contact_joint_friction: friction") = {
            {i.coefficient.force, i.coefficient.sliding,
             i.coefficient.spinning},
            {i.area.force, i.area.sliding, i.area.spinning}};
        const auto results = {i.coefficient.force, i.coefficient.sliding,
                              i.coefficient.spinning};
        if (!(std::abs(slip_axis_angle) <= std::numbers::pi / 2)) {
          return status_of(results, "contact_joint_friction: slip_axis_angle",
                           slip_axis_angle, "-pi/2 to pi/2 rad");
        }
        const bool closed =
            contact.has_interference() && half_angle == std::numbers::pi;
        return status_of(results, "contact_joint_friction: half_angle",
                         half_angle,
                         closed ? "below pi rad: coefficients of a contact "
                                  "that is closed all round depend on its load"
                                : "in the range of the laws");
      },
      friction);
}
