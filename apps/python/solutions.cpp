// Joints that slide or rest under a known reaction.
#include <pybind11/stl.h>

#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"
#include "python/rows/starts.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using contact::JointSolution;
using contact::RestSolution;
using Eigen::Vector3d;

// Solves rows one after another; warm rows start from the previous solution.
class Solver {
 public:
  Solver(const JointSet& joints, const Starts<Solved>& start, bool warm,
         const Placements& placements, LargestContacts& largest)
      : joints_(&joints),
        start_(&start),
        placements_(placements),
        largest_(&largest),
        warm_(warm) {}

  Solved operator()(const double* const* at, std::size_t i) {
    const contact::Joint::Slip slip{vector_at(at[1]), vector_at(at[2]),
                                    vector_at(at[3]), placements_(at, i)};
    const contact::Joint& joint = (*joints_)(at);
    const JointSolution* start = (*start_)(i);
    if (warm_ && has_last_) start = &last_;
    if (joint.is_endless()) {
      last_ = start ? joint.solve(slip, *start) : joint.solve(slip);
    } else {
      last_ = near_.begin(joint, start);
      last_ = joint.solve(slip, last_);
      near_.keep(joint, last_);
    }
    has_last_ = true;
    largest_->add(at, last_);
    return {joint, last_};
  }

 private:
  const JointSet* joints_;
  const Starts<Solved>* start_;
  Placements placements_;
  NearRim near_;
  LargestContacts* largest_;
  bool warm_;
  bool has_last_ = false;
  JointSolution last_;
};

py::object solve(const JointSet& self, const Numbers& reaction,
                 const Numbers& angular_velocity,
                 const std::optional<Numbers>& axis, bool warm,
                 const Answers<Solved>* last, const Lies& lies,
                 const WantedRows& wanted) {
  self.require_friction();
  const Rows rows(lies.behind(self, {self.argument(),
                                     {"reaction", reaction, 3},
                                     {"angular_velocity", angular_velocity, 3},
                                     axis_argument(axis)}));
  const Starts starts(last, rows);
  LargestContacts largest(self);
  py::object all = answered(
      rows, solved_table(), wanted,
      [&] { return Solver(self, starts, warm, Placements(lies, 4), largest); },
      self.at_once());
  largest.warn();
  return all;
}

py::object solve_contact(const JointSet& self, const Numbers& normal_force,
                         const Numbers& angular_velocity,
                         const std::optional<Numbers>& axis, const Lies& lies,
                         const WantedRows& wanted) {
  self.require_friction();
  const Rows rows(lies.behind(self, {self.argument(),
                                     {"normal_force", normal_force, 3},
                                     {"angular_velocity", angular_velocity, 3},
                                     axis_argument(axis)}));
  LargestContacts largest(self);
  py::object all = answered(
      rows, solved_table(), wanted,
      [&] {
        return [&, placements = Placements(lies, 4)](const double* const* at,
                                                     std::size_t i) mutable {
          const JointSolution s =
              self(at).solve_contact({vector_at(at[1]), vector_at(at[2]),
                                      vector_at(at[3]), placements(at, i)});
          largest.add(at, s);
          return Solved(self(at), s);
        };
      },
      self.at_once());
  largest.warn();
  return all;
}

py::object at_rest(const JointSet& self, const Numbers& reaction,
                   const Numbers& moment, const std::optional<Numbers>& axis,
                   const Answers<Held>* last, const Lies& lies,
                   const WantedRows& wanted) {
  self.require_friction();
  const Rows rows(lies.behind(self, {self.argument(),
                                     {"reaction", reaction, 3},
                                     {"moment", moment, 3},
                                     axis_argument(axis)}));
  const Starts starts(last, rows);
  LargestContacts largest(self);
  py::object all = answered(
      rows, held_table(), wanted,
      [&] {
        return [&, placements = Placements(lies, 4), near = NearRim()](
                   const double* const* at, std::size_t i) mutable {
          const contact::Joint& joint = self(at);
          const contact::Joint::Hold hold{vector_at(at[1]), vector_at(at[2]),
                                          vector_at(at[3]), placements(at, i)};
          RestSolution s;
          if (const RestSolution* const start = starts(i)) s = *start;
          near.put(joint, s.slip);
          s = joint.at_rest(hold, s);
          near.keep(joint, s.slip);
          largest.add(at, s.slip);
          return Held(joint, s);
        };
      },
      self.at_once());
  largest.warn();
  return all;
}

constexpr const char* solve_doc =
    R"(solve(self, reaction, angular_velocity, *, axis=None, warm=False, last=None, from_seat=None, tilt=None, place=None, axial_velocity=None, fields=None, out=None, threads=1)
--

Friction of the joint while its halves turn, under a known reaction. A [seat]
confines the contact of a ball: libcontact/docs/explanation/seats.md. Rows at
rims take some 30 ms and start from the previous row, which affects results by
1e-7. A pin that is tilted, relieved or loaded at a place is solved by slices, to
1e-8: libcontact/docs/how-to/finite_pin.md.

reaction: R on the body, N, (..., 3).
angular_velocity: Dw, body against carrier, rad/s, (..., 3); 0 rests.
axis: of a pin, unit vector, (..., 3); the direction of Dw if it is None.
warm: start each row from the solution of the previous row. Similar rows take 0.2
    to 0.7 of the time; the last digits differ.
last: a Solution of this joint for similar rows, from which each row starts, of
    their shape or a single one; an unpickled one cannot be used.
)" CONTACT_SEAT_DOC CONTACT_PIN_DOC
    R"(axial_velocity: of the body along a pin's axis, m/s, (...).
)" CONTACT_ROWS_DOC R"(
Returns a Solution of the shape to which the arguments broadcast. The equations
hold to 2e-13; NaN in an argument gives NaN with Status.OUT_OF_RANGE. If several
threads share warm rows, every 1024th row is a cold start.)";

constexpr const char* solve_contact_doc =
    R"(solve_contact(self, normal_force, angular_velocity, *, axis=None, from_seat=None, fields=None, out=None, threads=1)
--

Friction under a known normal force, without a solution of equations. With the
reaction as the normal force it gives the traditional estimate.

normal_force: R_n n on the body, N, (..., 3).
angular_velocity, axis: as in solve().
)" CONTACT_SEAT_DOC CONTACT_ROWS_DOC;

constexpr const char* at_rest_doc =
    R"(at_rest(self, reaction, moment, *, axis=None, last=None, from_seat=None, tilt=None, place=None, fields=None, out=None, threads=1)
--

Whether the joint rests under a reaction while friction supplies a moment, and
how close it is to sliding.

reaction: R on the body, N, (..., 3).
moment: M on the body that friction has to supply, N m, (..., 3).
last: a RestSolution for similar rows, as in solve(); takes a fifth of the time.
)" CONTACT_SEAT_DOC CONTACT_PIN_DOC CONTACT_ROWS_DOC R"(
Returns a RestSolution, whose `slip` is the sliding at the limit.)";

void bind_sliding(py::class_<JointSet>& type) {
  type.def(
      "solve",
      [](const JointSet& self, const Numbers& reaction, const Numbers& rate,
         const std::optional<Numbers>& axis, bool warm,
         const Answers<Solved>* last, const std::optional<Numbers>& from_seat,
         const std::optional<Numbers>& tilt,
         const std::optional<Numbers>& place,
         const std::optional<Numbers>& velocity, const Fields& fields,
         const Out& out, int threads) {
        return solve(self, reaction, rate, axis, warm, last,
                     {from_seat, tilt, place, velocity},
                     {fields, out, threads});
      },
      py::arg("reaction"), py::arg("angular_velocity"), py::kw_only(),
      py::arg("axis") = py::none(), py::arg("warm") = false,
      py::arg("last") = py::none(), py::arg("from_seat") = py::none(),
      py::arg("tilt") = py::none(), py::arg("place") = py::none(),
      py::arg("axial_velocity") = py::none(), py::arg("fields") = py::none(),
      py::arg("out") = py::none(), py::arg("threads") = 1, solve_doc);
  type.def(
      "solve_contact",
      [](const JointSet& self, const Numbers& normal_force, const Numbers& rate,
         const std::optional<Numbers>& axis,
         const std::optional<Numbers>& from_seat, const Fields& fields,
         const Out& out, int threads) {
        return solve_contact(self, normal_force, rate, axis, {from_seat},
                             {fields, out, threads});
      },
      py::arg("normal_force"), py::arg("angular_velocity"), py::kw_only(),
      py::arg("axis") = py::none(), py::arg("from_seat") = py::none(),
      py::arg("fields") = py::none(), py::arg("out") = py::none(),
      py::arg("threads") = 1, solve_contact_doc);
}

void bind_rest(py::class_<JointSet>& type) {
  type.def(
      "at_rest",
      [](const JointSet& self, const Numbers& reaction, const Numbers& moment,
         const std::optional<Numbers>& axis, const Answers<Held>* last,
         const std::optional<Numbers>& from_seat,
         const std::optional<Numbers>& tilt,
         const std::optional<Numbers>& place, const Fields& fields,
         const Out& out, int threads) {
        return at_rest(self, reaction, moment, axis, last,
                       {from_seat, tilt, place}, {fields, out, threads});
      },
      py::arg("reaction"), py::arg("moment"), py::kw_only(),
      py::arg("axis") = py::none(), py::arg("last") = py::none(),
      py::arg("from_seat") = py::none(), py::arg("tilt") = py::none(),
      py::arg("place") = py::none(), py::arg("fields") = py::none(),
      py::arg("out") = py::none(), py::arg("threads") = 1, at_rest_doc);
}

}  // namespace

void bind_solutions(py::module_& m, py::class_<JointSet>& joints) {
  bind_answers(m, "Solution", solved_table(),
               "What Joint.solve() returns, and Joint.solve_contact().");
  bind_answers(m, "RestSolution", held_table(), "What Joint.at_rest() returns.")
      .def_property_readonly(
          "slip",
          [](const Answers<Held>& all) {
            return part_of(all, "slip of a RestSolution", [](const Held& rest) {
              return Solved(rest.slip, rest.ends);
            });
          },
          "The sliding at the limit, a Solution.");
  bind_sliding(joints);
  bind_rest(joints);
}

}  // namespace contact_python
