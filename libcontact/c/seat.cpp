#include "libcontact/c/seat.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/c/joint.hpp"
#include "libcontact/c/numbers.hpp"
#include "libcontact/c/quantity.hpp"
#include "libcontact/duty/seat_pv.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/seat/joint.hpp"
#include "libcontact/seat/table.hpp"

/// Joint in a seat that ends, as C holds it.
struct contact_seat  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  contact_seat(const contact::JointSpec& spec,
               const contact_seat_options& options)
      : joint(spec) {
    if (options.table) {
      table = std::make_shared<contact::SeatTable>(
          joint.contact(), spec,
          std::string_view(options.table, options.table_size));
    } else if (options.least_load != 0 || options.most_load != 0) {
      table = std::make_shared<contact::SeatTable>(
          joint.contact(),
          contact::SeatTable::Options{.least_load = options.least_load,
                                      .most_load = options.most_load});
    }
    if (table) bytes = table->bytes(spec);
    joint.use(table);
  }

  contact::SeatJoint joint;
  std::shared_ptr<const contact::SeatTable> table;
  std::string bytes;
};

/// Last solution of a seat, as C holds it.
struct contact_seat_memory  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  contact::SeatJointSolution last;
};

namespace contact::c {
namespace {

using Eigen::Vector3d;

// The numbers of a solution in both languages.
template <class C, class Cpp, class Copy>
void each_number(C& c, Cpp& s, const Copy& copy) {
  copy(c.evaluations, s.evaluations);
  copy(c.reaction, s.reaction);
  copy(c.seat_force, s.contact.force);
  copy(c.friction_force, s.friction_force);
  copy(c.friction_moment, s.friction_moment);
  copy(c.power, s.power);
  copy(c.moment_coefficient, s.moment_coefficient);
  copy(c.nominal_area, s.nominal_area);
  copy(c.shift, s.contact.shift);
  copy(c.pressure_at_load, s.contact.pressure_at_load);
  copy(c.peak_pressure, s.contact.peak_pressure);
  copy(c.peak_polar_angle, s.contact.peak_place.polar_angle);
  copy(c.peak_longitude, s.contact.peak_place.longitude);
  copy(c.lower_end, s.contact.lower_end);
  copy(c.upper_end, s.contact.upper_end);
  copy(c.half_width, s.contact.half_width);
  copy(c.force_ratio, s.contact.force_ratio);
  copy(c.contact_area, s.contact.area);
  for (const int rim : {0, 1}) {
    copy(c.rims[rim].intensity, s.contact.rims[rim].intensity);
    copy(c.rims[rim].longitude, s.contact.rims[rim].longitude);
    copy(c.rims[rim].half_arc, s.contact.rims[rim].half_arc);
    copy(c.rims[rim].peak_pressure, s.contact.rims[rim].peak_pressure);
    copy(c.rims[rim].reach, s.contact.rims[rim].reach);
    copy(c.rims[rim].distance, s.contact.rims[rim].distance);
    copy(c.rims[rim].gap, s.contact.rims[rim].gap);
  }
}

// The enumerations of C and C++ are cast into each other.
static_assert(CONTACT_SEAT_OK == int(SeatStatus::ok));
static_assert(CONTACT_SEAT_NOT_CONVERGED == int(SeatStatus::not_converged));
static_assert(CONTACT_SEAT_OUT_OF_SEAT == int(SeatStatus::out_of_seat));
static_assert(CONTACT_SEAT_NO_LOAD == int(SeatStatus::no_load));

void put(contact_seat_solution& to, const SeatJointSolution& s) {
  to.status = static_cast<contact_seat_status>(s.contact.status);
  to.is_free = s.contact.is_free ? 1 : 0;
  each_number(to, s, ToC());
}

SeatJointSolution cpp_solution(const contact_seat_solution& from) {
  SeatJointSolution s;
  s.contact.status = static_cast<SeatStatus>(from.status);
  s.contact.is_free = from.is_free != 0;
  each_number(from, s, FromC());
  return s;
}

contact_status reported(const SeatJoint& joint, const SeatJointSolution& s,
                        const std::string& function) {
  if (s.contact.status == SeatStatus::ok) return CONTACT_OK;
  const std::string why = function + ": " + joint.notes(s).front();
  return contact_report(s.contact.status == SeatStatus::not_converged
                            ? CONTACT_NOT_CONVERGED
                            : CONTACT_OUT_OF_RANGE,
                        why.c_str());
}

contact_status solve(const SeatJoint& joint, const contact_slip& at,
                     SeatJointSolution& last, contact_seat_solution& to,
                     const char* function) {
  SeatJointSolution s =
      joint.solve({.reaction = Vector3d(at.reaction),
                   .angular_velocity = Vector3d(at.angular_velocity)},
                  last);
  put(to, s);
  const contact_status status = reported(joint, s, function);
  if (status == CONTACT_OK) last = std::move(s);
  return status;
}

}  // namespace

template <>
struct Refused<contact_seat_solution> {
  static void write(contact_seat_solution* s,
                    contact_status /*status*/) noexcept {
    s->status = CONTACT_SEAT_NO_LOAD;
    s->is_free = 0;
    const SeatJointSolution none;
    each_number(*s, none, ToNan());
  }
};
template <>
struct Refused<contact_seat_rating> {
  static void write(contact_seat_rating* rating,
                    contact_status /*status*/) noexcept {
    ToNan()(rating->pv_total, 0);
    ToNan()(rating->pv_max, 0);
    ToNan()(rating->pv_max_place, 0);
  }
};
template <>
struct Refused<contact_seat_rest> {
  static void write(contact_seat_rest* rest, contact_status status) noexcept {
    ToNan()(rest->utilisation, 0);
    ToNan()(rest->direction, 0);
    Refused<contact_seat_solution>::write(&rest->slip, status);
  }
};

}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::cpp_solution;
using contact::c::given;
using Eigen::Vector3d;

contact_status contact_seat_make(const contact_joint* joint,
                                 const contact_seat_options* options,
                                 contact_seat** seat) {
  return call([=] {
    contact_seat** const to =
        contact::c::emptied(seat, "contact_seat_make: seat");
    *to = new contact_seat(given(joint, "contact_seat_make: joint").spec,
                           options ? *options : contact_seat_options());
    return CONTACT_OK;
  });
}

void contact_seat_free(contact_seat* seat) { contact::c::give_back(seat); }

const char* contact_seat_table(const contact_seat* seat, std::size_t* size) {
  const bool is_there = seat && seat->table;
  if (size) *size = is_there ? seat->bytes.size() : 0;
  return is_there ? seat->bytes.data() : nullptr;
}

double contact_seat_table_error(const contact_seat* seat) {
  if (!seat || !seat->table) return std::numeric_limits<double>::quiet_NaN();
  return seat->table->check().error();
}

contact_status contact_seat_solve(const contact_seat* seat,
                                  const contact_slip* slip,
                                  contact_seat_solution* solution) {
  return call_for(
      [=] {
        contact::SeatJointSolution none;
        return contact::c::solve(
            given(seat, "contact_seat_solve: seat").joint,
            given(slip, "contact_seat_solve: slip"), none,
            given(solution, "contact_seat_solve: solution"),
            "contact_seat_solve");
      },
      solution);
}

contact_status contact_seat_memory_make(contact_seat_memory** memory) {
  return call([=] {
    contact_seat_memory** const to =
        contact::c::emptied(memory, "contact_seat_memory_make: memory");
    *to = new contact_seat_memory;
    return CONTACT_OK;
  });
}

void contact_seat_memory_free(contact_seat_memory* memory) {
  contact::c::give_back(memory);
}

contact_status contact_seat_solve_from(const contact_seat* seat,
                                       const contact_slip* slip,
                                       contact_seat_memory* memory,
                                       contact_seat_solution* solution) {
  return call_for(
      [=] {
        return contact::c::solve(
            given(seat, "contact_seat_solve_from: seat").joint,
            given(slip, "contact_seat_solve_from: slip"),
            given(memory, "contact_seat_solve_from: memory").last,
            given(solution, "contact_seat_solve_from: solution"),
            "contact_seat_solve_from");
      },
      solution);
}

contact_status contact_seat_at_rest(const contact_seat* seat,
                                    const contact_hold* hold,
                                    contact_seat_rest* rest) {
  return call_for(
      [=] {
        const auto& joint = given(seat, "contact_seat_at_rest: seat").joint;
        const contact_hold& at = given(hold, "contact_seat_at_rest: hold");
        contact_seat_rest& to = given(rest, "contact_seat_at_rest: rest");
        const auto s = joint.at_rest(
            {.reaction = Vector3d(at.reaction), .moment = Vector3d(at.moment)});
        to.utilisation = s.utilisation;
        contact::c::ToC()(to.direction, s.direction);
        contact::c::put(to.slip, s.slip);
        return contact::c::reported(joint, s.slip, "contact_seat_at_rest");
      },
      rest);
}

contact_status contact_seat_pressure(const contact_seat* seat,
                                     const contact_seat_solution* solution,
                                     const double* places, std::size_t count,
                                     double* pressure) {
  return call([=] {
    const auto& joint = given(seat, "contact_seat_pressure: seat").joint;
    const auto s =
        cpp_solution(given(solution, "contact_seat_pressure: solution"));
    if (count == 0) return CONTACT_OK;
    given(places, "contact_seat_pressure: places");
    given(pressure, "contact_seat_pressure: pressure");
    std::vector<Vector3d> at;
    for (std::size_t i = 0; i < count; ++i) at.emplace_back(places + 3 * i);
    std::ranges::copy(joint.pressures(s, at), pressure);
    return contact::c::reported(joint, s, "contact_seat_pressure");
  });
}

contact_status contact_seat_rate(const contact_seat* seat,
                                 const contact_seat_solution* solution,
                                 const contact_slip* slip,
                                 contact_seat_rating* rating) {
  return call_for(
      [=] {
        const auto& joint = given(seat, "contact_seat_rate: seat").joint;
        const auto s =
            cpp_solution(given(solution, "contact_seat_rate: solution"));
        const contact_slip& at = given(slip, "contact_seat_rate: slip");
        contact_seat_rating& to = given(rating, "contact_seat_rate: rating");
        contact::SeatState near;
        const contact::SeatPv pv =
            contact::seat_pv(joint, s, Vector3d(at.angular_velocity), near);
        to.pv_total = pv.total;
        to.pv_max = pv.largest;
        contact::c::ToC()(to.pv_max_place, pv.place);
        return contact::c::reported(joint, s, "contact_seat_rate");
      },
      rating);
}

contact_status contact_seat_notes(const contact_seat* seat,
                                  const contact_seat_solution* solution,
                                  char* text, std::size_t size) {
  return call([=] {
    if (size > 0) given(text, "contact_seat_notes: text");
    return contact::c::hand_over_notes(
        given(seat, "contact_seat_notes: seat")
            .joint.notes(
                cpp_solution(given(solution, "contact_seat_notes: solution"))),
        text, size);
  });
}

const contact_quantity* contact_seat_solution_quantity(std::size_t i) {
  return contact::c::row<contact::seat_joint_quantities>(i);
}

contact_status contact_seat_solution_get(const contact_seat_solution* solution,
                                         const char* key, double* value) {
  return contact::c::get_of<contact::seat_joint_quantities>(
      "contact_seat_solution_get", "solution", solution, cpp_solution, key,
      value);
}
