#include "libcontact/c/quantity.h"

#include "libcontact/c/joint.hpp"
#include "libcontact/c/quantity.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/quantities/tables.hpp"

using contact::c::call_for;
using contact::c::get;
using contact::c::given;
using contact::c::row_of;

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
