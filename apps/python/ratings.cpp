// p v and heat over the contact.
#include <pybind11/stl.h>

#include <array>

#include "libcontact/quantities/tables.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/rows_doc.hpp"
#include "python/starts.hpp"

namespace contact_python {
namespace {

using contact::JointSolution;
using contact::SlidingContact;
using Eigen::Vector3d;

py::object pv(const JointSet& self, const Numbers& reaction,
              const Numbers& angular_velocity, const WantedRows& wanted) {
  self.require_friction();
  const Rows rows({self.argument(),
                   {"reaction", reaction, 3},
                   {"angular_velocity", angular_velocity, 3}});
  LargestContacts largest(self);
  py::object all = answered(rows, contact::rating_quantities(), wanted, [&] {
    return [&](const double* const* at, std::size_t /*i*/) {
      const Vector3d rate = vector_at(at[2]);
      const contact::Joint& joint = self(at);
      const JointSolution s = joint.solve({vector_at(at[1]), rate});
      largest.add(at, s);
      return SlidingContact(joint.contact(), s, rate).rating();
    };
  });
  largest.warn();
  return all;
}

// Over places of the contact of one state.
py::dict pv_at(const FileJoint& self, const Vector3d& reaction,
               const Vector3d& rate, const Numbers& places) {
  const contact::Joint& joint = self.joint();
  const JointSolution s = joint.solve({reaction, rate});
  warn_of(self.limits(), {s.half_angle, s.peak_pressure});
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
    R"(pv(self, reaction, angular_velocity, *, fields=None, out=None, threads=1)
--

p v and heat over the contact while the halves turn: their largest values with
the place, means, sums. Arguments as in solve().
)" CONTACT_ROWS_DOC R"(
Returns a Rating.)";

void bind_pv(py::class_<JointSet>& type) {
  type.def(
      "pv",
      [](const JointSet& self, const Numbers& reaction, const Numbers& rate,
         const Fields& fields, const Out& out, int threads) {
        return pv(self, reaction, rate, {fields, out, threads});
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::kw_only(),
      py::arg("fields") = py::none(), py::arg("out") = py::none(),
      py::arg("threads") = 1, pv_doc);
}

void bind_places(py::class_<FileJoint, JointSet>& type) {
  type.def(
      "pv_at",
      [](const FileJoint& self, std::array<double, 3> reaction,
         std::array<double, 3> rate, const Numbers& places) {
        return pv_at(self, vector_at(reaction.data()), vector_at(rate.data()),
                     places);
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::arg("places"),
      R"(pv_at(self, reaction, angular_velocity, places)
--

A dict of "pressure" (Pa), "pv" and "heat_flux" (W/m^2) at places of the
contact of one state; pressure and heat flux are 0 outside of it.

reaction, angular_velocity: as in solve(), (3,).
places: unit vectors from the joint's centre, (..., 3).)");
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
