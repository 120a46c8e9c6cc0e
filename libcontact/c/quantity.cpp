#include "libcontact/c/quantity.h"

#include <cmath>

#include "libcontact/c/joint.hpp"
#include "libcontact/c/quantity.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/quantities/stuck.hpp"
#include "libcontact/quantities/tables.hpp"

using contact::c::call_for;
using contact::c::get;
using contact::c::given;
using contact::c::row_of;

namespace contact::c {
namespace {

StuckJoint stuck_of(const contact_stuck& s) {
  return {s.load_stiffness, s.held_stiffness, s.spin_stiffness,
          s.friction_moment, s.shape};
}

}  // namespace
}  // namespace contact::c

const contact_quantity* contact_solution_quantity(std::size_t i) {
  return contact::c::row<contact::solution_quantities>(i);
}

const contact_quantity* contact_rest_quantity(std::size_t i) {
  return contact::c::row<contact::rest_quantities>(i);
}

const contact_quantity* contact_patch_quantity(std::size_t i) {
  return contact::c::row<contact::patch_quantities>(i);
}

const contact_quantity* contact_rating_quantity(std::size_t i) {
  return contact::c::row<contact::rating_quantities>(i);
}

contact_status contact_solution_get(const contact_solution* solution,
                                    const char* key, double* value) {
  return contact::c::get_of<contact::solution_quantities>(
      "contact_solution_get", "solution", solution, contact::c::solution_of,
      key, value);
}

contact_status contact_rest_get(const contact_rest* rest, const char* key,
                                double* value) {
  return contact::c::get_of<contact::rest_quantities>(
      "contact_rest_get", "rest", rest, contact::c::rest_of, key, value);
}

contact_status contact_patch_get(const contact_joint* joint,
                                 double normal_force, const char* key,
                                 double* value) {
  return call_for(
      [=] {
        const auto& contact =
            given(joint, "contact_patch_get: joint").joint.contact();
        const auto& q = row_of(contact::patch_quantities(),
                               &given(key, "contact_patch_get: key"));
        return get(q,
                   {contact, normal_force,
                    contact.half_angle(normal_force).half_angle},
                   &given(value, "contact_patch_get: value"));
      },
      value);
}

contact_status contact_rating_get(const contact_joint* joint,
                                  const contact_slip* slip,
                                  const contact_solution* solution,
                                  const char* key, double* value) {
  return call_for(
      [=] {
        const contact::Joint& j =
            given(joint, "contact_rating_get: joint").joint;
        const auto& rate =
            given(slip, "contact_rating_get: slip").angular_velocity;
        const auto& s = given(solution, "contact_rating_get: solution");
        const auto& q = row_of(contact::rating_quantities(),
                               &given(key, "contact_rating_get: key"));
        return get(q,
                   contact::rating_of(j, contact::c::whole(j, s),
                                      Eigen::Vector3d(rate)),
                   &given(value, "contact_rating_get: value"));
      },
      value);
}

contact_status contact_joint_stuck(const contact_joint* joint,
                                   double normal_force, contact_stuck* stuck) {
  return call_for(
      [=] {
        const contact_joint& j = given(joint, "contact_joint_stuck: joint");
        const contact::JointContact& contact = j.joint.contact();
        const double half_angle = contact.half_angle(normal_force).half_angle;
        const contact::StuckJoint s =
            contact::stuck_joint(j.spec, contact, normal_force, half_angle);
        given(stuck, "contact_joint_stuck: stuck") = {
            s.load_stiffness, s.held_stiffness, s.spin_stiffness,
            s.friction_moment, s.shape};
        if (!std::isnan(s.load_stiffness)) return CONTACT_OK;
        std::string why = contact::stuck_refusal(j.spec, half_angle);
        if (why.empty()) {
          why = "normal_force must be a number, and the bodies held";
        }
        return contact_report(CONTACT_OUT_OF_RANGE,
                              ("contact_joint_stuck: " + why).c_str());
      },
      stuck);
}

const contact_quantity* contact_stuck_quantity(std::size_t i) {
  return contact::c::row<contact::stuck_quantities>(i);
}

contact_status contact_stuck_get(const contact_stuck* stuck, const char* key,
                                 double* value) {
  return contact::c::get_of<contact::stuck_quantities>(
      "contact_stuck_get", "stuck", stuck, contact::c::stuck_of, key, value);
}

contact_status contact_joint_stuck_notes(const contact_joint* joint,
                                         double normal_force, char* text,
                                         std::size_t size) {
  return contact::c::call([=] {
    if (size > 0) given(text, "contact_joint_stuck_notes: text");
    const contact_joint& j = given(joint, "contact_joint_stuck_notes: joint");
    return contact::c::hand_over_notes(
        contact::stuck_notes(
            j.spec, j.joint.contact().half_angle(normal_force).half_angle),
        text, size);
  });
}
