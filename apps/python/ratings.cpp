// p v and heat over the contact.
#include <pybind11/stl.h>

#include <array>
#include <cmath>

#include "libcontact/duty/joint_rating.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"
#include "python/rows/starts.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using contact::JointSolution;
using contact::SlidingContact;
using Eigen::Vector3d;

// True if the contact is not axisymmetric: at a rim of its seat, or a pin by
// slices.
bool has_no_axis(const JointSolution& s) {
  return s.status == contact::Status::ok && std::isnan(s.half_angle);
}

py::object pv(const JointSet& self, const Numbers& reaction,
              const Numbers& angular_velocity, const Lies& lies,
              const WantedRows& wanted) {
  self.require_friction();
  const Rows rows(
      lies.behind(self, {self.argument(),
                         {"reaction", reaction, 3},
                         {"angular_velocity", angular_velocity, 3}}));
  LargestContacts largest(self);
  py::object all = answered(
      rows, contact::rating_quantities(), wanted,
      [&] {
        return [&, placements = Placements(lies, 3), near = NearRim()](
                   const double* const* at, std::size_t i) mutable {
          const Vector3d rate = vector_at(at[2]);
          const contact::Joint& joint = self(at);
          const JointSolution s = joint.solve({.reaction = vector_at(at[1]),
                                               .angular_velocity = rate,
                                               .placement = placements(at, i)},
                                              near.begin(joint, nullptr));
          near.keep(joint, s);
          largest.add(at, s);
          return contact::rating_of(joint, s, rate);
        };
      },
      self.at_once());
  largest.warn();
  return all;
}

py::object pressures_of(const contact::Joint& joint, const JointSolution& s,
                        const Numbers& places) {
  const Rows rows({{"places", places, 3}});
  std::vector<Vector3d> at;
  rows.for_each(
      [&](const double* const* row) { at.push_back(vector_at(row[0])); });
  py::array_t<double> all(rows.shape());
  std::ranges::copy(joint.pressures(s, at), all.mutable_data());
  return returned(all);
}

// Pressures of a solution that was stored without its grid.
py::object pressures(const FileJoint& self, const Answers<Solved>& solution,
                     const Numbers& places) {
  if (solution.rows.size() == 1) {
    return pressures_of(self.joint(), solution.rows[0], places);
  }
  throw contact::Error(contact::detail::must_be(
      "solution", "a single row that has not been pickled"));
}

// Pressure, p v and heat flux at places of a contact at a rim.
py::dict pv_at_rim(const contact::Joint& joint, const JointSolution& s,
                   const Vector3d& rate, const Numbers& places) {
  const JointSolution whole = joint.with_grid(s);
  const double radius = joint.contact().geometry().radius();
  py::dict result;
  const py::object pressure = pressures_of(joint, whole, places);
  const auto of_pressure = [&](auto value) {
    return evaluate(
        {{"places", places, 3}, {"pressure", Numbers(pressure), 0}},
        [&](const double* const* at) {
          const double speed =
              radius *
              (joint.is_pin() ? rate : rate.cross(vector_at(at[0]))).norm();
          return value(*at[1], speed);
        });
  };
  result["pressure"] = pressure;
  result["pv"] = of_pressure([](double p, double v) { return p * v; });
  result["heat_flux"] = of_pressure([&](double p, double v) {
    const auto strength = joint.contact().strength(v / radius);
    const double stress =
        strength.pressure_part * p + strength.area_part / (radius * radius);
    return p > 0 ? stress * v : 0;
  });
  return result;
}

// Pressure, p v and heat flux at places of the contact of one state.
py::dict pv_at(const FileJoint& self, const Vector3d& reaction,
               const Vector3d& rate, const Numbers& places,
               const std::optional<Numbers>& from_seat) {
  const contact::Joint& joint = self.joint();
  const Lies lies{from_seat};
  const std::vector<Argument> turn = lies.behind(self, {});
  if (!turn.empty() && !turn[0].shape.empty()) {
    throw contact::Error(
        contact::detail::must_be("from_seat", "a single matrix"));
  }
  Placements placements(lies, 0);
  const double* const at = turn.empty() ? nullptr : turn[0].data;
  const JointSolution s = joint.solve({.reaction = reaction,
                                       .angular_velocity = rate,
                                       .placement = placements(&at, 0)});
  warn_of(self, s);
  if (has_no_axis(s)) return pv_at_rim(joint, s, rate, places);
  const SlidingContact sliding(joint.contact(), s, rate);
  const auto over = [&](double (SlidingContact::*of)(const Vector3d&)
                            const noexcept) {
    return evaluate({{"places", places, 3}}, [&](const double* const* row) {
      return (sliding.*of)(vector_at(row[0]));
    });
  };
  py::dict result;
  result["pressure"] = over(&SlidingContact::pressure);
  result["pv"] = over(&SlidingContact::pv);
  result["heat_flux"] = over(&SlidingContact::heat_flux);
  return result;
}

constexpr const char* pv_doc =
    R"(pv(self, reaction, angular_velocity, *, from_seat=None, tilt=None, place=None, axial_velocity=None, fields=None, out=None, threads=1)
--

p v and heat over the contact while the halves turn: largest values with their
places, means, sums. Arguments as in solve(). At a rim of a seat the total is
accurate to 1e-3, the largest to 5e-3 at report_distance (0.02 radii) or more from
it, and the largest heat flux is NaN.
)" CONTACT_ROWS_DOC R"(
Returns a Rating.)";

void bind_pv(py::class_<JointSet>& type) {
  type.def(
      "pv",
      [](const JointSet& self, const Numbers& reaction, const Numbers& rate,
         const std::optional<Numbers>& from_seat,
         const std::optional<Numbers>& tilt,
         const std::optional<Numbers>& place,
         const std::optional<Numbers>& velocity, const Fields& fields,
         const Out& out, int threads) {
        return pv(self, reaction, rate, {from_seat, tilt, place, velocity},
                  {fields, out, threads});
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::kw_only(),
      py::arg("from_seat") = py::none(), py::arg("tilt") = py::none(),
      py::arg("place") = py::none(), py::arg("axial_velocity") = py::none(),
      py::arg("fields") = py::none(), py::arg("out") = py::none(),
      py::arg("threads") = 1, pv_doc);
}

void bind_places(py::class_<FileJoint, JointSet>& type) {
  type.def(
      "pv_at",
      [](const FileJoint& self, std::array<double, 3> reaction,
         std::array<double, 3> rate, const Numbers& places,
         const std::optional<Numbers>& from_seat) {
        return pv_at(self, vector_at(reaction.data()), vector_at(rate.data()),
                     places, from_seat);
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::arg("places"),
      py::kw_only(), py::arg("from_seat") = py::none(),
      R"(pv_at(self, reaction, angular_velocity, places, *, from_seat=None)
--

A dict of "pressure" (Pa), "pv" and "heat_flux" (W/m^2) at places of the
contact of one state; pressure and heat flux are 0 outside of it.

reaction, angular_velocity: as in solve(), (3,).
places: unit vectors from the joint's centre, (..., 3).
from_seat: as in solve(), (3, 3).)");
  type.def("pressures", &pressures, py::arg("solution"), py::arg("places"),
           R"(pressures(self, solution, places)
--

Pressures of one solution, Pa, (...): 0 outside the contact, infinite at a rim that
it reaches; accurate to 3e-3 of the largest away from rims. A contact at a rim is
solved again, in some 30 ms.

solution: a single Solution of this joint.
places: unit vectors from the joint's centre, (..., 3), in its axes.)");
}

}  // namespace

void bind_ratings(py::module_& m, py::class_<JointSet>& joints,
                  py::class_<FileJoint, JointSet>& joint) {
  bind_answers(m, "Rating", contact::rating_quantities(),
               "What Joint.pv() returns.");
  bind_pv(joints);
  bind_places(joint);
}

}  // namespace contact_python
