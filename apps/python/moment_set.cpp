// Moment sets, for iterative solvers of several bodies.
#include <pybind11/stl.h>

#include <numeric>

#include "libcontact/quantities/tables.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"
#include "python/rows/starts.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using contact::MomentSet;
using Eigen::Vector3d;

// Moments that the contacts of solutions can hold, at fixed n, R_n and theta0.
class MomentSets {
 public:
  MomentSets(const JointSet& joints, const Answers<Solved>& solution) {
    joints.require_friction();
    if (joints.size() > 0 && joints[0].is_pin()) {
      throw contact::Error(contact::detail::must_be(
          "the joint of moment_set()", "a ball, whose moments are a set"));
    }
    require_rows(solution);
    std::vector<double> numbers(solution.rows.size());
    std::iota(numbers.begin(), numbers.end(), 0.0);
    const Rows rows({joints.argument(), {numbers.data(), 0, solution.shape}});
    shape_ = rows.shape();
    rows.for_each(
        [&](const double* const* at) {
          const Solved& s = solution.rows[static_cast<std::size_t>(*at[1])];
          numbers_.push_back(static_cast<double>(sets_.size()));
          sets_.push_back(joints(at).moment_set(s));
        },
        joints.at_once());
  }

  Argument argument() const { return {numbers_.data(), 0, shape_}; }
  const Shape& shape() const { return shape_; }
  // The set with the index at[0].
  const MomentSet& operator()(const double* const* at) const {
    return sets_[static_cast<std::size_t>(*at[0])];
  }

 private:
  Shape shape_;
  std::vector<MomentSet> sets_;  // their joints are kept by Python
  std::vector<double> numbers_;
};

py::object prox(const MomentSets& self, const Numbers& inertia,
                const Numbers& free, const WantedRows& wanted) {
  const Rows rows({self.argument(),
                   Argument::matrix("inertia", inertia),
                   {"free", free, 3}});
  return answered(rows, contact::prox_quantities(), wanted, [&] {
    return [&](const double* const* at, std::size_t /*i*/) {
      return self(at).prox(matrix_at(at[1]), vector_at(at[2]));
    };
  });
}

// NAME(argument) of a set.
template <class Value>
void bind_of_set(py::class_<MomentSets>& type, const char* name,
                 const char* argument,
                 Value (MomentSet::*of)(const Vector3d&) const noexcept,
                 const std::string& doc) {
  type.def(
      name,
      [argument, of](const MomentSets& self, const Numbers& numbers,
                     const py::object& out, int threads) {
        return evaluate({self.argument(), {argument, numbers, 3}},
                        [&](const double* const* at) {
                          return (self(at).*of)(vector_at(at[1]));
                        },
                        {out, threads});
      },
      py::arg(argument), py::kw_only(), py::arg("out") = py::none(),
      py::arg("threads") = 1,
      (std::string(name) + "(self, " + argument +
       ", *, out=None, threads=1)\n--\n\n" + doc + "\n\n" CONTACT_NUMBERS_DOC)
          .c_str());
}

constexpr const char* prox_doc =
    R"(prox(self, inertia, free, *, fields=None, out=None, threads=1)
--

The motion with friction: W (alpha - free) = M_t(alpha), with alpha exactly 0 if
the set holds W free.

inertia: W, inertia about the joint (of velocities: over the time step),
    symmetric and positive definite, (..., 3, 3).
free: relative angular acceleration or velocity without friction, (..., 3).
)" CONTACT_ROWS_DOC R"(
Returns a Prox.)";

}  // namespace

void bind_moment_set(py::module_& m, py::class_<JointSet>& joints) {
  bind_answers(m, "Prox", contact::prox_quantities(),
               "What MomentSet.prox() returns.");
  py::class_<MomentSets> type(
      m, "MomentSet",
      "The friction moments of contacts whose normal, normal force and "
      "half-angle are\nfixed, see Joint.moment_set().");
  bind_of_set(type, "support", "angular_velocity", &MomentSet::support,
              "The largest M . Dw of the set, W; Dw in rad/s, (..., 3).");
  bind_of_set(type, "moment", "angular_velocity", &MomentSet::moment,
              "The moment of the set that opposes Dw most, N m; Dw in rad/s, "
              "(..., 3).");
  bind_of_set(type, "utilisation", "moment", &MomentSet::utilisation,
              "The share of the set that a moment needs: it is held if it is "
              "<= 1. moment: M on\nthe body, N m, (..., 3).");
  bind_of_set(type, "project", "moment", &MomentSet::project,
              "The moment of the set that is nearest. moment: M on the body, N "
              "m, (..., 3).");
  type.def("__repr__", [](const MomentSets& self) {
    return py::str("<libcontact.MomentSet of shape {}>")
        .format(py::tuple(py::cast(self.shape())));
  });
  type.def(
      "prox",
      [](const MomentSets& self, const Numbers& inertia, const Numbers& free,
         const Fields& fields, const Out& out, int threads) {
        return prox(self, inertia, free, {fields, out, threads});
      },
      py::arg("inertia"), py::arg("free"), py::kw_only(),
      py::arg("fields") = py::none(), py::arg("out") = py::none(),
      py::arg("threads") = 1, prox_doc);
  joints.def(
      "moment_set",
      [](const JointSet& self, const Answers<Solved>& solution) {
        return std::make_unique<MomentSets>(self, solution);
      },
      py::arg("solution"), py::keep_alive<0, 1>(),
      R"(moment_set(self, solution)
--

Moments that the contact of a ball can hold at fixed n, R_n and theta0, for
iterative solvers of several bodies. A contact at a rim of a seat is solved again,
30 ms.

solution: a result of solve().

Returns a MomentSet, whose functions broadcast against the solution's rows.)");
}

}  // namespace contact_python
