// Joints whose contact ends: seats with rims, pins of finite length.
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <set>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/duty/seat_pv.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/seat/joint.hpp"
#include "libcontact/seat/table.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"

namespace contact_python {
namespace {

using contact::SeatJointSolution;
using contact::SeatRestSolution;
using contact::SeatTable;

// A joint whose contact is confined to its [seat].
class Seat {
 public:
  Seat(const FileJoint& joint,
       const std::optional<std::pair<double, double>>& loads,
       const std::optional<std::string>& table)
      : spec_(joint.spec()), limits_(joint.limits()) {
    if (loads && table) {
      throw contact::Error(
          contact::detail::must_be("loads", "left out beside table"));
    }
    const Unlocked unlocked;
    joint_ = std::make_unique<contact::SeatJoint>(spec_);
    if (table) {
      table_ =
          std::make_shared<const SeatTable>(joint_->contact(), spec_, *table);
    } else if (loads) {
      table_ = std::make_shared<const SeatTable>(
          joint_->contact(),
          SeatTable::Options{
              .least_load = loads->first,
              .most_load = loads->second,
              .progress = [](double /*share*/) { Rows::heed_signals(); }});
    }
    joint_->use(table_);
  }

  const std::string& name() const { return spec_.name; }
  const contact::SeatJoint& joint() const { return *joint_; }
  const contact::ContactLimits& limits() const { return limits_; }
  std::optional<py::bytes> table() const {
    if (!table_) return {};
    return table_->bytes(spec_);
  }
  std::optional<double> table_error() const {
    if (!table_) return {};
    return table_->check().error();
  }

 private:
  contact::JointSpec spec_;
  contact::ContactLimits limits_;
  std::unique_ptr<contact::SeatJoint> joint_;
  std::shared_ptr<const SeatTable> table_;
};

// Notes of rows, and the largest contact.
struct Said {
  std::set<std::string> notes;
  contact::LargestContact largest;

  // Rows without a solution say so by their status.
  void add(const Seat& seat, const SeatJointSolution& s) {
    if (s.contact.status != contact::SeatStatus::ok) return;
    for (std::string& note : seat.joint().notes(s)) {
      notes.insert(std::move(note));
    }
    largest.add(0, s.contact.peak_pressure);
  }
  void warn(const Seat& seat) const {
    warn_of(seat.limits(), largest);
    for (const std::string& note : notes) warn_of(note);
  }
};

// Contacts take long, and their grids memory, which pressure() makes anew.
constexpr std::size_t at_once = 1;

Answers<SeatJointSolution> solve(const Seat& self, const Numbers& reaction,
                                 const Numbers& angular_velocity) {
  Said said;
  SeatJointSolution last;
  auto all = answers<SeatJointSolution>(
      {{"reaction", reaction, 3}, {"angular_velocity", angular_velocity, 3}},
      [&](const double* const* at) {
        last = self.joint().solve({.reaction = vector_at(at[0]),
                                   .angular_velocity = vector_at(at[1])},
                                  last);
        said.add(self, last);
        SeatJointSolution row = last;
        row.contact.solution = nullptr;
        return row;
      },
      at_once);
  said.warn(self);
  return all;
}

Answers<SeatRestSolution> at_rest(const Seat& self, const Numbers& reaction,
                                  const Numbers& moment) {
  Said said;
  auto all = answers<SeatRestSolution>(
      {{"reaction", reaction, 3}, {"moment", moment, 3}},
      [&](const double* const* at) {
        SeatRestSolution row = self.joint().at_rest(
            {.reaction = vector_at(at[0]), .moment = vector_at(at[1])});
        said.add(self, row.slip);
        row.slip.contact.solution = nullptr;
        return row;
      },
      at_once);
  said.warn(self);
  return all;
}

// The one row of a solution; unpickled ones have none.
template <class Solution>
const Solution& single(const Answers<Solution>& solution) {
  if (solution.rows.size() == 1) return solution.rows[0];
  throw contact::Error(contact::detail::must_be(
      "solution", "a single row that has not been pickled"));
}

py::object pressure(const Seat& self,
                    const Answers<SeatJointSolution>& solution,
                    const Numbers& places) {
  std::vector<Eigen::Vector3d> at;
  const Rows rows({{"places", places, 3}});
  rows.for_each(
      [&](const double* const* row) { at.push_back(vector_at(row[0])); });
  py::array_t<double> result(rows.shape());
  std::ranges::copy(self.joint().pressures(single(solution), at),
                    result.mutable_data());
  return returned(result);
}

Answers<contact::SeatPv> pv(const Seat& self,
                            const Answers<SeatJointSolution>& solution,
                            const Numbers& angular_velocity) {
  const SeatJointSolution& s = single(solution);
  contact::SeatState near;
  return answers<contact::SeatPv>(
      {{"angular_velocity", angular_velocity, 3}},
      [&](const double* const* at) {
        return contact::seat_pv(self.joint(), s, vector_at(at[0]), near);
      },
      at_once);
}

void bind_functions(py::class_<Seat>& type) {
  type.def("solve", &solve, py::arg("reaction"), py::arg("angular_velocity"),
           R"(solve(self, reaction, angular_velocity)
--

Friction under a reaction while the halves turn, in the axes of the body that
has the seat. Returns a SeatSolution; NaN where its status is not OK. A
ContactWarning beside a rim says what the model leaves out there.

reaction: R on the body, N, (..., 3).
angular_velocity: Dw of the body against the carrier, rad/s, (..., 3).)")
      .def("at_rest", &at_rest, py::arg("reaction"), py::arg("moment"),
           R"(at_rest(self, reaction, moment)
--

Whether the joint rests while holding a moment. Returns a SeatRestSolution.

reaction: R on the body, N, (..., 3).
moment: M on the body that friction has to supply, N m, (..., 3).)")
      .def("pressure", &pressure, py::arg("solution"), py::arg("places"),
           R"(pressure(self, solution, places)
--

Pressures of one row, Pa, (...): 0 outside the contact, infinite at a rim that is
reached; 3e-3 of the largest away from rims. A contact at a rim is found anew.

solution: a single SeatSolution.
places: unit vectors from the ball's centre, (..., 3).)")
      .def("pv", &pv, py::arg("solution"), py::arg("angular_velocity"),
           R"(pv(self, solution, angular_velocity)
--

p v of one row: a SeatRating, total to 1e-3, largest to 5e-3 at report_distance
(0.02 radii) or more from rims, where it is infinite. A contact at a rim is found
anew.

solution: a single SeatSolution.
angular_velocity: Dw of that solution, rad/s, (..., 3).)")
      .def(
          "notes",
          [](const Seat& self, const Answers<SeatJointSolution>& solution) {
            return self.joint().notes(single(solution));
          },
          py::arg("solution"),
          R"(notes(self, solution)
--

Why one row has no solution, or what the model leaves out beside a rim, a
sentence each.

solution: a single SeatSolution.)");
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
               "What Seat.solve() returns.");
  bind_answers(m, "SeatRestSolution", contact::seat_rest_quantities(),
               "What Seat.at_rest() returns.");
  py::class_<Seat> type(m, "Seat", R"(Seat(joint, loads=None, table=None)
--

A joint of a ball whose contact is confined to its [seat]: a ring, a cup, a
socket (libcontact's docs/seats.md).

joint: a Joint with dry or viscous friction.
loads: the least and the largest, N, of a table of contacts at rims, made in 7 to
    20 s; each is then read in some 10 us, to 1e-3 of the load.
table: that of another Seat of the same joint, bytes, instead.)");
  type.def(py::init<const FileJoint&,
                    const std::optional<std::pair<double, double>>&,
                    const std::optional<std::string>&>(),
           py::arg("joint"), py::arg("loads") = py::none(),
           py::arg("table") = py::none());
  type.def("__repr__", [](const Seat& s) {
    return py::str("<libcontact.Seat of {!r}>").format(s.name());
  });
  type.def_property_readonly("table", &Seat::table,
                             "The table as bytes to keep; None without one.");
  type.def_property_readonly(
      "table_error", &Seat::table_error,
      "Largest error of 100 random states of the table, over the load.");
  bind_functions(type);
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
