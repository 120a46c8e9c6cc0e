// Joints whose contact ends: seats with rims, pins of finite length.
#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"

namespace contact_python {
namespace {

// The one row of a solution; unpickled ones have none.
template <class Solution>
const Solution& single(const Answers<Solution>& solution) {
  if (solution.rows.size() == 1) return solution.rows[0];
  throw contact::Error(contact::detail::must_be(
      "solution", "a single row that has not been pickled"));
}

using contact::FinitePinSolution;
using Eigen::Vector2d;

class FinitePin {
 public:
  explicit FinitePin(const FileJoint& joint)
      : name_(joint.spec().name), pin_(joint.spec()), limits_(joint.limits()) {}

  const std::string& name() const { return name_; }
  const contact::FinitePin& pin() const { return pin_; }
  const contact::ContactLimits& limits() const { return limits_; }

 private:
  std::string name_;
  contact::FinitePin pin_;
  contact::ContactLimits limits_;
};

Answers<FinitePinSolution> solve_pin(const FinitePin& self,
                                     const Numbers& reaction,
                                     const Numbers& rate,
                                     const std::optional<Numbers>& tilt,
                                     const std::optional<Numbers>& place,
                                     const std::optional<Numbers>& along) {
  if (tilt && place) {
    throw contact::Error(
        contact::detail::must_be("tilt", "left out beside place"));
  }
  static const Vector2d level = Vector2d::Zero();
  static constexpr double still = 0;
  const Argument lie = place  ? Argument("place", *place, 0)
                       : tilt ? Argument("tilt", *tilt, 2)
                              : Argument(level.data(), 2, {});
  const Argument velocity =
      along ? Argument("axial_velocity", *along, 0) : Argument(&still, 0, {});
  contact::LargestContact largest;
  auto all = answers<FinitePinSolution>(
      {{"reaction", reaction, 2}, {"rate", rate, 0}, lie, velocity},
      [&](const double* const* at) {
        const Vector2d force(at[0]);
        const contact::FinitePin::Motion motion{*at[1], *at[3]};
        const FinitePinSolution s =
            place ? self.pin().solve_at(force, *at[2], motion)
                  : self.pin().solve(force, Vector2d(at[2]), motion);
        largest.add(s.contact.largest());
        return s;
      });
  warn_of(self.limits(), largest);
  return all;
}

py::object pressure_of_pin(const FinitePin& self,
                           const Answers<FinitePinSolution>& solution,
                           const Numbers& z, const Numbers& theta) {
  const contact::FinitePinState& state = single(solution).contact;
  const Rows rows({{"z", z, 0}, {"theta", theta, 0}});
  py::array_t<double> result(rows.shape());
  double* to = result.mutable_data();
  rows.for_each([&](const double* const* at) {
    *to++ = self.pin().pressure(state, *at[0], *at[1]);
  });
  return returned(result);
}

}  // namespace

void bind_seat(py::module_& m) {
  bind_answers(m, "SeatSolution", contact::seat_joint_quantities(),
               "What SeatCycle.solution has.");
}

void bind_finite_pin(py::module_& m) {
  bind_answers(m, "FinitePinSolution", contact::finite_pin_quantities(),
               "What FinitePin.solve() returns.");
  py::class_<FinitePin> type(m, "FinitePin", R"(FinitePin(joint)
--

A pin of finite length whose axis may be tilted in its hole, with the relief of
its ends (libcontact's docs/finite_pin.md).

joint: a Joint of a pin that needs a wall with a backing, with dry friction.)");
  type.def(py::init([](const FileJoint& joint) {
             const Unlocked unlocked;
             return std::make_unique<FinitePin>(joint);
           }),
           py::arg("joint"));
  type.def("__repr__", [](const FinitePin& p) {
    return py::str("<libcontact.FinitePin of {!r}>").format(p.name());
  });
  type.def(
          "solve", &solve_pin, py::arg("reaction"), py::arg("rate"),
          py::kw_only(), py::arg("tilt") = py::none(),
          py::arg("place") = py::none(), py::arg("axial_velocity") = py::none(),
          R"(solve(self, reaction, rate, *, tilt=None, place=None, axial_velocity=None)
--

The pin under a reaction while the body turns and slides along it. Returns a
FinitePinSolution, to 1e-8; NaN beyond the law of its slices.

reaction: R on the body across the axis, N, (..., 2).
rate: of the body about z, rad/s, (...): its sign counts.
tilt: known slope of the pin's axis, (..., 2); level without it.
place: of the reaction along the pin, from its middle, m, (...): the tilt is
    found.
axial_velocity: of the body along z, m/s, (...); 0 without it.)")
      .def("pressure", &pressure_of_pin, py::arg("solution"), py::arg("z"),
           py::arg("theta"),
           R"(pressure(self, solution, z, theta)
--

Pressures of one row, Pa, (...): 0 outside the contact.

solution: a single FinitePinSolution.
z: places along the pin, from its middle, m, (...).
theta: angles about z from x, rad, (...).)");
}

}  // namespace contact_python
