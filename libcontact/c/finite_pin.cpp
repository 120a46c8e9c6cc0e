#include "libcontact/c/finite_pin.h"

#include "libcontact/c/joint.hpp"
#include "libcontact/c/numbers.hpp"
#include "libcontact/c/quantity.hpp"
#include "libcontact/c/slip.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/quantities/finite_pin.hpp"

/// Pin that ends, as C holds it.
struct contact_finite_pin  // NOLINT(readability-identifier-naming)
    : contact::c::Handle {
  explicit contact_finite_pin(const contact::JointSpec& spec) : pin(spec) {}

  const contact::FinitePin pin;
};

namespace contact::c {
namespace {

// The numbers of a solution in both languages, but for the stiffness.
template <class C, class Cpp, class Copy>
void each_number(C& c, Cpp& s, const Copy& copy) {
  copy(c.iterations, s.contact.iterations);
  copy(c.pieces, s.contact.pieces);
  copy(c.residual, s.contact.residual);
  copy(c.shift, s.contact.shift);
  copy(c.tilt, s.contact.tilt);
  copy(c.force, s.contact.force);
  copy(c.force_moment, s.contact.force_moment);
  copy(c.energy, s.contact.energy);
  copy(c.stiffness, s.contact.stiffness);
  copy(c.low, s.contact.low);
  copy(c.high, s.contact.high);
  copy(c.peak_pressure, s.contact.peak_pressure);
  copy(c.peak_place, s.contact.peak_place);
  copy(c.largest_half_angle, s.contact.largest_half_angle);
  copy(c.half_angle_place, s.contact.half_angle_place);
  copy(c.end_pressure, s.contact.end_pressure);
  copy(c.end_half_angle, s.contact.end_half_angle);
  copy(c.friction_force, s.friction_force);
  copy(c.axial_friction_force, s.axial_friction_force);
  copy(c.moment, s.moment);
}

FinitePinSolution cpp_solution(const contact_finite_pin_solution& from) {
  FinitePinSolution s;
  s.contact.status = cpp_status(from.status);
  each_number(from, s, FromC());
  return s;
}

FinitePinSolution solved(const FinitePin& pin,
                         const contact_finite_pin_load& load) {
  const Eigen::Vector2d reaction(load.reaction);
  const FinitePin::Motion motion{load.rate, load.axial_velocity};
  return load.is_placed
             ? pin.solve_at(reaction, load.place, motion)
             : pin.solve(reaction, Eigen::Vector2d(load.tilt), motion);
}

}  // namespace

template <>
struct Refused<contact_finite_pin_solution> {
  static void write(contact_finite_pin_solution* s,
                    contact_status status) noexcept {
    s->status = status;
    const FinitePinSolution none = {};
    each_number(*s, none, ToNan());
  }
};

}  // namespace contact::c

using contact::c::call;
using contact::c::call_for;
using contact::c::given;

contact_status contact_finite_pin_make(const contact_joint* joint,
                                       contact_finite_pin** pin) {
  return call([=] {
    contact_finite_pin** const to =
        contact::c::emptied(pin, "contact_finite_pin_make: pin");
    *to = new contact_finite_pin(
        given(joint, "contact_finite_pin_make: joint").spec);
    return CONTACT_OK;
  });
}

void contact_finite_pin_free(contact_finite_pin* pin) {
  contact::c::give_back(pin);
}

contact_status contact_finite_pin_solve(const contact_finite_pin* pin,
                                        const contact_finite_pin_load* load,
                                        contact_finite_pin_solution* solution) {
  return call_for(
      [=] {
        const auto s =
            contact::c::solved(given(pin, "contact_finite_pin_solve: pin").pin,
                               given(load, "contact_finite_pin_solve: load"));
        auto& to = given(solution, "contact_finite_pin_solve: solution");
        to.status = contact::c::status_of(s.contact.status);
        contact::c::each_number(to, s, contact::c::ToC());
        return contact::c::reported(to.status, "contact_finite_pin_solve");
      },
      solution);
}

const contact_quantity* contact_finite_pin_quantity(std::size_t i) {
  return contact::c::row<contact::finite_pin_quantities>(i);
}

contact_status contact_finite_pin_get(
    const contact_finite_pin_solution* solution, const char* key,
    double* value) {
  return contact::c::get_of<contact::finite_pin_quantities>(
      "contact_finite_pin_get", "solution", solution, contact::c::cpp_solution,
      key, value);
}
