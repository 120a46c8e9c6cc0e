#include "libcontact/c/quantity.h"

#include <string>
#include <vector>

#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/joint.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/quantities/tables.hpp"

namespace contact::c {
namespace {

// A table as C has it; made once.
template <class T>
std::vector<contact_quantity> listed(std::span<const Quantity<T>> table) {
  static const std::vector<std::string> units = [table] {
    std::vector<std::string> all;
    for (const auto& q : table) all.push_back(unit_text(q.dimension));
    return all;
  }();
  std::vector<contact_quantity> all;
  for (const auto& q : table) {
    all.push_back({q.key.data(), q.symbol.data(), units[all.size()].c_str(),
                   q.meaning.data(), q.is_vector() ? 3U : 1U});
  }
  return all;
}

const contact_quantity* at(const std::vector<contact_quantity>& all,
                           std::size_t i) {
  return i < all.size() ? &all[i] : nullptr;
}

// @throws Error for an unknown key
template <class T>
const Quantity<T>& row_of(std::span<const Quantity<T>> table,
                          std::string_view key) {
  if (const auto* q = find_quantity(table, key)) return *q;
  std::vector<std::string> keys;
  for (const auto& q : table) keys.emplace_back(q.key);
  throw Error(detail::unknown("quantity", std::string(key), keys));
}

template <class T>
contact_status get(const Quantity<T>& q, const T& of, double* value) {
  const int size = q.is_vector() ? 3 : 1;
  for (int k = 0; k < size; ++k) {
    value[k] = value_of(q, of, q.is_vector() ? k : whole);
  }
  return CONTACT_OK;
}

}  // namespace
}  // namespace contact::c

using contact::c::call_for;
using contact::c::get;
using contact::c::given;
using contact::c::row_of;

const contact_quantity* contact_solution_quantity(std::size_t i) {
  static const auto all = contact::c::listed(contact::solution_quantities());
  return contact::c::at(all, i);
}

const contact_quantity* contact_rest_quantity(std::size_t i) {
  static const auto all = contact::c::listed(contact::rest_quantities());
  return contact::c::at(all, i);
}

const contact_quantity* contact_patch_quantity(std::size_t i) {
  static const auto all = contact::c::listed(contact::patch_quantities());
  return contact::c::at(all, i);
}

const contact_quantity* contact_rating_quantity(std::size_t i) {
  static const auto all = contact::c::listed(contact::rating_quantities());
  return contact::c::at(all, i);
}

contact_status contact_solution_get(const contact_solution* solution,
                                    const char* key, double* value) {
  return call_for(
      [=] {
        const auto& s = given(solution, "contact_solution_get: solution");
        const auto& q = row_of(contact::solution_quantities(),
                               &given(key, "contact_solution_get: key"));
        return get(q, contact::c::solution_of(s),
                   &given(value, "contact_solution_get: value"));
      },
      value);
}

contact_status contact_rest_get(const contact_rest* rest, const char* key,
                                double* value) {
  return call_for(
      [=] {
        const auto& s = given(rest, "contact_rest_get: rest");
        const auto& q = row_of(contact::rest_quantities(),
                               &given(key, "contact_rest_get: key"));
        return get(q, contact::c::rest_of(s),
                   &given(value, "contact_rest_get: value"));
      },
      value);
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
        const auto& contact =
            given(joint, "contact_rating_get: joint").joint.contact();
        const auto& rate =
            given(slip, "contact_rating_get: slip").angular_velocity;
        const auto& s = given(solution, "contact_rating_get: solution");
        const auto& q = row_of(contact::rating_quantities(),
                               &given(key, "contact_rating_get: key"));
        const contact::JointSolution solved = contact::c::solution_of(s);
        return get(
            q,
            contact::SlidingContact(contact, solved, Eigen::Vector3d(rate))
                .rating(),
            &given(value, "contact_rating_get: value"));
      },
      value);
}
