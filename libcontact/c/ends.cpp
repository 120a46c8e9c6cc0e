#include "libcontact/c/ends.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "libcontact/c/joint.hpp"
#include "libcontact/c/quantity.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"

/// Last solution of a joint, as C holds it.
struct contact_memory  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  contact_memory() {}  // no aggregate: what it is made from is protected
  contact::JointSolution last;
};

namespace contact::c {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Placement placement_of(const contact_placement& from) {
  const std::string place = "contact_joint_get: placement";
  if (from.size != sizeof from) {
    throw Error(detail::must_be(place + ".size", "sizeof(contact_placement)"));
  }
  Placement to;
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> turn(
      from.from_seat);
  if (!turn.isZero(0)) {
    to.from_seat = turn;
    constexpr double single = 1e-5;  // hosts in single precision
    if (!(turn * turn.transpose()).isIdentity(single) ||
        turn.determinant() < 0) {
      throw Error(detail::must_be(place + ".from_seat",
                                  "a rotation, row by row, or all 0"));
    }
  }
  to.tilt = Vector3d(from.tilt);
  if (from.is_placed) to.place = from.place;
  to.axial_velocity = from.axial_velocity;
  return to;
}

// All that can be asked of a slip.
struct Answer {
  JointSolution solution;
  std::optional<RimContact> rims = {};
  std::optional<PinLie> lie = {};
};

// Calls use(quantity, the part of the answer that has it, or null).
template <class Use>
auto with_row(std::string_view key, const Answer* of, const Use& use) {
  if (const auto* q = find_quantity(rim_quantities(), key)) {
    return use(*q, of && of->rims ? &*of->rims : nullptr);
  }
  if (const auto* q = find_quantity(lie_quantities(), key)) {
    return use(*q, of && of->lie ? &*of->lie : nullptr);
  }
  return use(row_of(solution_quantities(), key), of ? &of->solution : nullptr);
}

// Puts a quantity, NaN if it is not there; returns how many numbers it has.
std::size_t put_quantity(std::string_view key, const Answer* of, double* to) {
  return with_row(key, of, [to](const auto& q, const auto* from) {
    const std::size_t size = q.is_vector() ? 3 : 1;
    if (from) {
      get(q, *from, to);
    } else {
      std::fill_n(to, size, std::numeric_limits<double>::quiet_NaN());
    }
    return size;
  });
}

Answer answer(const Joint& joint, const contact_slip& slip,
              const contact_placement* placement, const JointSolution& last) {
  Joint::Slip at = slip_of(slip);
  Placement placed;
  if (placement) {
    placed = placement_of(*placement);
    at.placement = &placed;
  }
  Answer found{joint.solve(at, last)};
  found.rims = joint.rims(found.solution);
  found.lie = joint.lie(found.solution);
  return found;
}

}  // namespace
}  // namespace contact::c

using contact::c::call;
using contact::c::given;
using contact::c::hand_over;

contact_status contact_memory_make(contact_memory** memory) {
  return call([=] {
    return hand_over(
        contact::c::emptied(memory, "contact_memory_make: memory"));
  });
}

void contact_memory_free(contact_memory* memory) {
  contact::c::give_back(memory);
}

contact_status contact_joint_get(const contact_joint* joint,
                                 const contact_slip* slip,
                                 const contact_placement* placement,
                                 contact_memory* memory,
                                 const char* const* keys, std::size_t count,
                                 double* values) {
  const auto put_all = [=](const contact::c::Answer* of) {
    double* to = values;
    for (std::size_t i = 0; i < count; ++i) {
      to += contact::c::put_quantity(
          &given(keys[i], "contact_joint_get: keys[i]"), of, to);
    }
  };
  return call([=] {
    if (count > 0) {
      given(keys, "contact_joint_get: keys");
      given(values, "contact_joint_get: values");
    }
    put_all(nullptr);
    const contact::Joint& j = given(joint, "contact_joint_get: joint").joint;
    contact::JointSolution none;
    contact::JointSolution& last =
        memory ? given(memory, "contact_joint_get: memory").last : none;
    contact::c::Answer found = contact::c::answer(
        j, given(slip, "contact_joint_get: slip"), placement, last);
    put_all(&found);
    const contact_status status =
        contact::c::reported(j, found.solution, "contact_joint_get");
    if (status == CONTACT_OK) last = std::move(found.solution);
    return status;
  });
}

const contact_quantity* contact_joint_quantity(std::size_t i) {
  if (const auto* q = contact_solution_quantity(i)) return q;
  i -= contact::solution_quantities().size();
  if (const auto* q = contact::c::row<contact::rim_quantities>(i)) return q;
  return contact::c::row<contact::lie_quantities>(
      i - contact::rim_quantities().size());
}

contact_status contact_joint_pressures(const contact_joint* joint,
                                       const contact_solution* solution,
                                       const double* places, std::size_t count,
                                       double* pressures) {
  return call([=] {
    const contact::Joint& j =
        given(joint, "contact_joint_pressures: joint").joint;
    const contact::JointSolution s = contact::c::whole(
        j, given(solution, "contact_joint_pressures: solution"));
    if (count == 0) return CONTACT_OK;
    given(places, "contact_joint_pressures: places");
    given(pressures, "contact_joint_pressures: pressures");
    std::vector<Eigen::Vector3d> at;
    for (std::size_t i = 0; i < count; ++i) at.emplace_back(places + 3 * i);
    std::ranges::copy(j.pressures(s, at), pressures);
    return contact::c::reported(j, s, "contact_joint_pressures");
  });
}

contact_status contact_joint_without_seat(const contact_joint* joint,
                                          contact_joint** endless) {
  return call([=] {
    return hand_over(
        contact::c::emptied(endless, "contact_joint_without_seat: endless"),
        given(joint, "contact_joint_without_seat: joint").spec.without_seat());
  });
}

contact_status contact_joint_tabulate(const contact_joint* joint,
                                      double least_load, double most_load,
                                      contact_joint** tabulated) {
  return call([=] {
    contact_joint** const to =
        contact::c::emptied(tabulated, "contact_joint_tabulate: tabulated");
    const auto& of = given(joint, "contact_joint_tabulate: joint");
    return hand_over(to, of.spec,
                     of.joint.tabulated(contact::RimTableOptions{
                         .least_load = least_load, .most_load = most_load}));
  });
}

const char* contact_joint_table(const contact_joint* joint, std::size_t* size) {
  const bool is_there = joint && !joint->table.empty();
  if (size) *size = is_there ? joint->table.size() : 0;
  return is_there ? joint->table.data() : nullptr;
}

double contact_joint_table_error(const contact_joint* joint) {
  const auto check = joint ? joint->joint.table_check() : std::nullopt;
  return check ? check->error() : std::numeric_limits<double>::quiet_NaN();
}

contact_status contact_joint_set_table(const contact_joint* joint,
                                       const char* table, std::size_t size,
                                       contact_joint** tabulated) {
  return call([=] {
    contact_joint** const to =
        contact::c::emptied(tabulated, "contact_joint_set_table: tabulated");
    const auto& of = given(joint, "contact_joint_set_table: joint");
    return hand_over(
        to, of.spec,
        of.joint.tabulated(std::string_view(
            &given(table, "contact_joint_set_table: table"), size)));
  });
}
