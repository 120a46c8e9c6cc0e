// Steps of a simulator, and the response of friction.
#include <pybind11/stl.h>

#include "libcontact/base/text.hpp"
#include "libcontact/joint/derivatives.hpp"
#include "libcontact/joint/step.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"
#include "python/rows/starts.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using contact::JointSolution;
using contact::JointStep;
using contact::RestSolution;
using Eigen::Vector3d;

py::object step(const JointSet& self, const Numbers& reaction,
                const Numbers& angular_velocity, const Numbers& free,
                const Numbers& inertia, const std::optional<Numbers>& axis,
                const Answers<Stepped>* last, const Lies& lies,
                const WantedRows& wanted) {
  self.require_friction();
  const Rows rows(lies.behind(self, {self.argument(),
                                     {"reaction", reaction, 3},
                                     {"angular_velocity", angular_velocity, 3},
                                     {"free", free, 3},
                                     Argument::matrix("inertia", inertia),
                                     axis_argument(axis)}));
  const Starts starts(last, rows);
  LargestContacts largest(self);
  py::object all = answered(
      rows, stepped_table(), wanted,
      [&] {
        return [&, placements = Placements(lies, 6), near = NearRim()](
                   const double* const* at, std::size_t i) mutable {
          const contact::Joint& joint = self(at);
          const contact::StepStart start{vector_at(at[1]), vector_at(at[2]),
                                         vector_at(at[3]), vector_at(at[5]),
                                         placements(at, i)};
          const Eigen::Matrix3d w = matrix_at(at[4]);
          if (!contact::is_inertia(joint, start, w)) {
            throw contact::Error(contact::detail::must_be(
                contact::detail::message("inertia of row {}", i),
                contact::inertia_rule));
          }
          JointStep s;
          if (const JointStep* const before = starts(i)) s = *before;
          near.put(joint, s.solution);
          near.put(joint, s.rest.slip);
          s = contact::step(joint, start, w, s);
          near.keep(joint, s.solution);
          largest.add(at, s.solution);
          return Stepped(joint, s);
        };
      },
      self.at_once());
  largest.warn();
  return all;
}

// Joints of one mechanism: their steps, and the convergence of the moments.
py::tuple step_together(const std::vector<const FileJoint*>& joints,
                        const Numbers& reaction,
                        const Numbers& angular_velocity, const Numbers& free,
                        const Numbers& inertia,
                        const std::optional<Numbers>& axis,
                        const Answers<Stepped>* last, const Lies& lies) {
  std::vector<const contact::Joint*> all;
  for (const FileJoint* joint : joints) {  // null: None
    if (!joint) {
      throw contact::Error(contact::detail::must_be("joints", "all of Joint"));
    }
    all.push_back(&joint->joint());
  }
  if (joints.empty()) {
    throw contact::Error(contact::detail::must_be("joints", "one or more"));
  }
  const Rows rows(
      lies.behind(*joints[0], {{"reaction", reaction, 3},
                               {"angular_velocity", angular_velocity, 3},
                               {"free", free, 3},
                               axis_argument(axis)}));
  Answers<Stepped> result{{static_cast<py::ssize_t>(all.size())}};
  if (rows.shape() != result.shape) {
    throw contact::Error(contact::detail::must_be(
        "the arguments of step()", "(n, 3), a row for each joint"));
  }
  if (inertia.ndim() != 2) {
    throw contact::Error(contact::detail::must_be("inertia", "a matrix"));
  }
  const Starts starts(last, rows);
  std::vector<contact::StepStart> begin;
  std::vector<Placements> placements(all.size(), Placements(lies, 4));
  std::vector<JointStep> steps;
  rows.for_each([&](const double* const* at) {
    const std::size_t i = begin.size();
    const JointStep* const start = starts(i);
    steps.push_back(start ? *start : JointStep());
    begin.push_back({vector_at(at[0]), vector_at(at[1]), vector_at(at[2]),
                     vector_at(at[3]), placements[i](at, i)});
  });
  // Symmetric, so that the order of the numbers has no effect.
  const contact::StepSweeps sweeps =
      contact::step(all, begin,
                    Eigen::Map<const Eigen::MatrixXd>(
                        inertia.data(), inertia.shape(1), inertia.shape(0)),
                    steps);
  for (std::size_t i = 0; i < all.size(); ++i) {
    warn_of(*joints[i], steps[i].solution);
    result.rows.emplace_back(*all[i], steps[i]);
  }
  py::dict told;
  told["status"] = static_cast<int>(sweeps.status);
  told["sweeps"] = sweeps.sweeps;
  told["residual"] = sweeps.residual;
  return py::make_tuple(std::move(result), told);
}

py::dict derivatives(const JointSet& self, const Numbers& reaction,
                     const Numbers& angular_velocity,
                     const std::optional<Numbers>& axis, const Lies& lies,
                     int threads) {
  self.require_friction();
  Wanted{.threads = threads}.check();
  const Rows rows(lies.behind(self, {self.argument(),
                                     {"reaction", reaction, 3},
                                     {"angular_velocity", angular_velocity, 3},
                                     axis_argument(axis)}));
  Shape shape = rows.shape();
  shape.insert(shape.end(), {3, 3});
  py::dict all;
  std::vector<RowMajor*> to;
  for (const char* name : {"over_rate", "over_reaction", "at_contact"}) {
    py::array_t<double> array(shape);
    to.push_back(reinterpret_cast<RowMajor*>(array.mutable_data()));
    all[name] = array;
  }
  rows.for_each(
      threads,
      [&] {
        return [&, placements = Placements(lies, 4)](const double* const* at,
                                                     std::size_t i) mutable {
          const contact::Joint::Slip slip{vector_at(at[1]), vector_at(at[2]),
                                          vector_at(at[3]), placements(at, i)};
          const contact::SlipDerivatives d =
              contact::derivatives(self(at), slip, self(at).solve(slip));
          to[0][i] = d.over_rate;
          to[1][i] = d.over_reaction;
          to[2][i] = d.at_contact;
        };
      },
      self.at_once());
  return all;
}

constexpr const char* step_doc =
    R"(step(self, reaction, angular_velocity, free, inertia, *, axis=None, last=None, from_seat=None, fields=None, out=None, threads=1)
--

One implicit step of a simulator with friction that stops, holds and releases the
joint: M_t = W (Dw - free), M_t opposite to Dw. A torque from solve() alone never
stops a body, which then creeps.

reaction: R on the body in the previous step, N, (..., 3).
angular_velocity: Dw, rad/s, (..., 3); exactly 0: the joint rests.
free: Dw at the end of the step without this friction, rad/s, (..., 3).
inertia: W, inertia about the joint over the time step, N m s, symmetric and
    positive definite, else an Error, (..., 3, 3); for a pin only its part along
    the axis counts.
axis: of a pin, unit vector, (..., 3); the direction of Dw or of free if it is
    None.
last: the Step before, from which this one is found faster.
)" CONTACT_SEAT_DOC CONTACT_ROWS_DOC R"(
Returns a Step; its `solution` is the friction at the start, its `rest` the load
that a resting joint had to hold.)";

constexpr const char* step_together_doc =
    R"(step(joints, reaction, angular_velocity, free, inertia, *, axis=None, last=None, from_seat=None)
--

One implicit step of several coupled joints of one mechanism, by sweeps over the
joints: M_i = sum_j W_ij (Dw_j - free_j).

joints: n of them.
reaction, angular_velocity, free: as in Joint.step(), (n, 3).
inertia: W, mass matrix over the time step in the joints' angular velocities,
    three rows for a ball and one, about its axis, for a pin.
axis: of pins, unit vectors, (n, 3).
last: the Step before, from which this one is found faster.
)" CONTACT_SEAT_DOC R"(
Returns a Step of n rows, and a dict on the convergence: "status", "sweeps" and
"residual", the change of the last sweep over the largest W free.)";

void bind_steps(py::class_<JointSet>& joints) {
  joints.def(
      "step",
      [](const JointSet& self, const Numbers& reaction, const Numbers& rate,
         const Numbers& free, const Numbers& inertia,
         const std::optional<Numbers>& axis, const Answers<Stepped>* last,
         const std::optional<Numbers>& from_seat, const Fields& fields,
         const Out& out, int threads) {
        return step(self, reaction, rate, free, inertia, axis, last,
                    {from_seat}, {fields, out, threads});
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::arg("free"),
      py::arg("inertia"), py::kw_only(), py::arg("axis") = py::none(),
      py::arg("last") = py::none(), py::arg("from_seat") = py::none(),
      py::arg("fields") = py::none(), py::arg("out") = py::none(),
      py::arg("threads") = 1, step_doc);
  joints.def(
      "derivatives",
      [](const JointSet& self, const Numbers& reaction, const Numbers& rate,
         const std::optional<Numbers>& axis,
         const std::optional<Numbers>& from_seat, int threads) {
        return derivatives(self, reaction, rate, axis, {from_seat}, threads);
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::kw_only(),
      py::arg("axis") = py::none(), py::arg("from_seat") = py::none(),
      py::arg("threads") = 1,
      R"(derivatives(self, reaction, angular_velocity, *, axis=None, from_seat=None, threads=1)
--

Derivatives of M_t, a dict of arrays (..., 3, 3) whose rows are components of M_t:
"over_rate", dM_t/dDw under a known reaction, N m s; "over_reaction", dM_t/dR, m;
"at_contact", dM_t/dDw at fixed n, R_n and theta0. NaN at rest and at a rim.

reaction, angular_velocity, axis, from_seat: as in solve().
threads: number of threads that share the rows.)");
}

}  // namespace

void bind_step(py::module_& m, py::class_<JointSet>& joints) {
  auto type =
      bind_answers(m, "Step", stepped_table(), "What Joint.step() returns.");
  type.def_property_readonly(
      "solution",
      [](const Answers<Stepped>& all) {
        return part_of(all, "solution of a Step", [](const Stepped& s) {
          return Solved(s.solution, s.ends);
        });
      },
      "Friction at the start, a Solution.");
  type.def_property_readonly(
      "rest",
      [](const Answers<Stepped>& all) {
        return part_of(all, "rest of a Step", [](const Stepped& s) {
          return Held(s.rest, s.rest_ends);
        });
      },
      "What a joint had to hold that rested, a RestSolution.");
  bind_steps(joints);
  m.def(
      "step",
      [](const std::vector<const FileJoint*>& of, const Numbers& reaction,
         const Numbers& rate, const Numbers& free, const Numbers& inertia,
         const std::optional<Numbers>& axis, const Answers<Stepped>* last,
         const std::optional<Numbers>& from_seat) {
        return step_together(of, reaction, rate, free, inertia, axis, last,
                             {from_seat});
      },
      py::arg("joints"), py::arg("reaction"), py::arg("angular_velocity"),
      py::arg("free"), py::arg("inertia"), py::kw_only(),
      py::arg("axis") = py::none(), py::arg("last") = py::none(),
      py::arg("from_seat") = py::none(), step_together_doc);
}

}  // namespace contact_python
