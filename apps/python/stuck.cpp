// Joints before they slide.
#include <pybind11/stl.h>

#include <algorithm>

#include "libcontact/quantities/stuck.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"

namespace contact_python {
namespace {

py::object stuck(const FileJoint& self, const Numbers& normal_force,
                 const WantedRows& wanted) {
  const contact::JointContact& contact = self.joint().contact();
  const auto half_angle = [&](double force) {
    return contact.half_angle(force).half_angle;
  };
  const Rows rows({self.argument(), {"normal_force", normal_force, 0}});
  LargestContacts largest(self);
  double most = 0;
  rows.for_each([&](const double* const* at) {
    most = std::max(most, *at[1]);
    largest.add(at, half_angle(*at[1]), 0);
  });
  constexpr std::size_t slow = 16;  // rows between two looks at Ctrl-C
  py::object all = answered(
      rows, contact::stuck_quantities(), wanted,
      [&] {
        return [&](const double* const* at, std::size_t /*i*/) {
          return stuck_joint(self.spec(), contact, *at[1], half_angle(*at[1]));
        };
      },
      slow);
  largest.warn();
  for (const auto& note : stuck_notes(self.spec(), half_angle(most))) {
    warn_of(note);
  }
  return all;
}

constexpr const char* stuck_doc =
    R"(stuck(self, normal_force, *, fields=None, out=None, threads=1)
--

Stiffness of the joint while friction holds it, the parameters for LuGre and Dahl,
and the rotation at which it slides: docs/explanation/presliding.md. Some 10 ms a
row.

normal_force: R_n, N, (...), above 0.
)" CONTACT_ROWS_DOC R"(
Returns a Stuck; stiffnesses are accurate to 5e-4, shape_exponent to 0.2. NaN: the
held_stiffness of a pin in an infinite hole, the spin_stiffness of a pin, and all
results with interference and for half-angles outside 0.01 to 3.1 rad. A
ContactWarning reports if the stiffness also depends on the shaft, or if rims are
ignored.)";

}  // namespace

void bind_stuck(py::module_& m, py::class_<FileJoint, JointSet>& joint) {
  bind_answers(m, "Stuck", contact::stuck_quantities(),
               "What Joint.stuck() returns.");
  joint.def(
      "stuck",
      [](const FileJoint& self, const Numbers& normal_force,
         const Fields& fields, const Out& out, int threads) {
        return stuck(self, normal_force, {fields, out, threads});
      },
      py::arg("normal_force"), py::kw_only(), py::arg("fields") = py::none(),
      py::arg("out") = py::none(), py::arg("threads") = 1, stuck_doc);
}

}  // namespace contact_python
