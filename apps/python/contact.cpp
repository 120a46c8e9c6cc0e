// Functions of a normal force, and of the laws alone.
#include <pybind11/stl.h>

#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/answers.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows_doc.hpp"
#include "python/solved.hpp"

namespace contact_python {
namespace {

using contact::JointContact;

// The array of value(contact, half-angle, at), where at[1] is a normal force;
// warns of the largest contact.
template <class Value>
py::object of_contacts(const JointSet& self,
                       std::initializer_list<Argument> arguments,
                       const Value& value, const Wanted& wanted) {
  LargestContacts largest(self);
  py::object all = evaluate(
      arguments,
      [&](const double* const* at) {
        const JointContact& contact = self(at).contact();
        const double half_angle = contact.half_angle(*at[1]).half_angle;
        largest.add(at, half_angle, contact.peak_pressure(*at[1], half_angle));
        return value(contact, half_angle, at);
      },
      wanted);
  largest.warn();
  return all;
}

py::object pressure(const JointSet& self, const Numbers& theta,
                    const Numbers& force, const py::object& out, int threads) {
  return of_contacts(
      self, {self.argument(), {"normal_force", force, 0}, {"theta", theta, 0}},
      [](const JointContact& c, double half_angle, const double* const* at) {
        return c.pressure(*at[2], *at[1], half_angle);
      },
      {out, threads});
}

std::vector<std::string> notes_of(const FileJoint& self,
                                  const Answers<Solved>& solution) {
  require_rows(solution);
  contact::ContactNotes notes;
  for (const Solved& s : solution.rows) notes.add(self[0], s);
  return notes.notes(self[0]);
}

std::vector<std::string> notes(const FileJoint& self,
                               const std::optional<Numbers>& force,
                               const Answers<Solved>* solution) {
  if (solution) return notes_of(self, *solution);
  std::vector<std::string> all = self.spec().validity_notes();
  if (!force) return all;
  const JointContact& contact = self.contact();
  LargestContacts largest(self);
  Rows({self.argument(), {"normal_force", *force, 0}})
      .for_each([&](const double* const* at) {
        const double half_angle = contact.half_angle(*at[1]).half_angle;
        largest.add(at, half_angle, contact.peak_pressure(*at[1], half_angle));
      });
  for (auto& note : largest.notes()) all.push_back(std::move(note));
  return all;
}

// Functions of the module for a law alone.
py::object law_half_angle(const FileJoint& self, const Numbers& parameter) {
  const auto& law = self.contact().half_angle_law();
  return evaluate({{"load_parameter", parameter, 0}},
                  [&](const double* const* at) {
                    return law.half_angle(*at[0]).half_angle;
                  });
}

py::object law_load_parameter(const FileJoint& self,
                              const Numbers& half_angle) {
  const auto& law = self.contact().half_angle_law();
  return evaluate({{"half_angle", half_angle, 0}},
                  [&](const double* const* at) {
                    return law.load_parameter(*at[0]).load_parameter;
                  });
}

py::object law_pressure(const FileJoint& self, const Numbers& theta,
                        const Numbers& half_angle) {
  const auto& law = self.contact().pressure_law();
  return evaluate(
      {{"theta", theta, 0}, {"half_angle", half_angle, 0}},
      [&](const double* const* at) { return law.pressure(*at[0], *at[1]); });
}

Answers<contact::FrictionTriple> law_coefficients(const FileJoint& self,
                                                  const Numbers& theta0,
                                                  const Numbers& alpha) {
  const Rows rows({{"theta0", theta0, 0}, {"alpha", alpha, 0}});
  std::vector<double> in[3];
  std::vector<double> out[3];
  rows.for_each([&](const double* const* at) {
    const auto axis = contact::SlipAxis::from_angle(*at[1]);
    in[0].push_back(*at[0]);
    in[1].push_back(axis.sin);
    in[2].push_back(axis.cos);
  });
  for (auto& column : out) column.resize(rows.size());
  Answers<contact::FrictionTriple> result{rows.shape(), {}};
  const Unlocked unlocked;
  contact::friction_integrals(self.contact().pressure_law(),
                              {in[0], in[1], in[2]},
                              {.normal = {},
                               .force_pressure = {},
                               .sliding_pressure = {},
                               .spinning_pressure = {},
                               .force_area = {},
                               .sliding_area = {},
                               .spinning_area = {},
                               .force = out[0],
                               .sliding = out[1],
                               .spinning = out[2]});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.rows.push_back({out[0][i], out[1][i], out[2][i]});
  }
  return result;
}

void bind_size(py::class_<JointSet>& joints,
               py::class_<FileJoint, JointSet>& joint) {
  const auto number = [&](const char* name, auto value, const char* doc) {
    joints.def_property_readonly(
        name,
        [value](const JointSet& self) {
          return evaluate({self.argument()}, [&](const double* const* at) {
            return value(self(at).contact());
          });
        },
        doc);
  };
  const auto text = [&](const char* name, auto value, const char* doc) {
    joint.def_property_readonly(
        name, [value](const FileJoint& self) { return value(self.contact()); },
        doc);
  };
  joint.def_property_readonly(
      "name", [](const FileJoint& self) { return self.spec().name; },
      "As the file has it.");
  text(
      "kind",
      [](const JointContact& c) { return to_string(c.geometry().kind()); },
      "\"ball\" or \"pin\".");
  number(
      "radius", [](const JointContact& c) { return c.geometry().radius(); },
      "rho of the ball or pin, m.");
  number(
      "radial_clearance",
      [](const JointContact& c) { return c.geometry().radial_clearance(); },
      "eps, m.");
  number(
      "length", [](const JointContact& c) { return c.geometry().length(); },
      "Of a pin's contact, m; NaN of a ball.");
  number(
      "effective_modulus",
      [](const JointContact& c) { return c.pair().effective_modulus(); },
      "E = 2 E* of the surfaces, Pa.");
  text(
      "half_angle_law",
      [](const JointContact& c) { return c.half_angle_law().name(); },
      "Its name: \"fitted\", \"exact\", ...");
  text(
      "pressure_law",
      [](const JointContact& c) { return c.pressure_law().name(); },
      "Its name: \"exact\", \"cosine\", ...");
  number(
      "limit_half_angle",
      [](const JointContact& c) {
        return c.half_angle_law().limit_half_angle();
      },
      "theta0 at infinite load, rad.");
}

// NAME(normal_force) of a quantity.
template <class T, class Evaluate>
void bind_quantity(py::class_<JointSet>& type, const contact::Quantity<T>& q,
                   const char* more, const Evaluate& evaluate) {
  type.def(
      q.key.data(),
      [evaluate](const JointSet& self, const Numbers& normal_force,
                 const py::object& out, int threads) {
        return evaluate(self,
                        {self.argument(), {"normal_force", normal_force, 0}},
                        Wanted{out, threads});
      },
      py::arg("normal_force"), py::kw_only(), py::arg("out") = py::none(),
      py::arg("threads") = 1,
      (std::string(q.key) +
       "(self, normal_force, *, out=None, threads=1)\n--\n\n" +
       documentation(q) + more +
       "\n\nnormal_force: R_n, N, (...), above 0; with interference "
       "0 too.\n" CONTACT_NUMBERS_DOC)
          .c_str());
}

void bind_quantities(py::class_<JointSet>& type) {
  using Arguments = std::initializer_list<Argument>;
  for (const auto& q : contact::patch_quantities()) {
    const auto value = [&q](const JointContact& c, double half_angle,
                            const double* const* at) {
      const contact::ContactPatch patch{c, *at[1], half_angle};
      return value_of(q, patch);
    };
    bind_quantity(type, q, "",
                  [&q, value](const JointSet& self, Arguments arguments,
                              const Wanted& wanted) {
                    if (q.exists) {
                      return of_contacts(self, arguments, value, wanted);
                    }
                    return evaluate(
                        arguments,
                        [&](const double* const* at) {
                          return value(self(at).contact(), 0, at);
                        },
                        wanted);
                  });
  }
  for (const auto& q : contact::approach_quantities()) {
    bind_quantity(
        type, q,
        " NaN unless the half-angle\nlaw is exact, and where there is none: a "
        "pin in an infinite hole, loaded through\nthe back. To 2e-7 of itself.",
        [&q](const JointSet& self, Arguments arguments, const Wanted& wanted) {
          return of_contacts(
              self, arguments,
              [&q](const JointContact& c, double half_angle,
                   const double* const* /*at*/) {
                return number_of(q, c.approach(half_angle));
              },
              wanted);
        });
  }
  type.def("pressure", &pressure, py::arg("theta"), py::arg("normal_force"),
           py::kw_only(), py::arg("out") = py::none(), py::arg("threads") = 1,
           "pressure(self, theta, normal_force, *, out=None, threads=1)"
           "\n--\n\n"
           "Contact pressure, Pa; 0 outside of the contact.\n\n"
           "theta: angle from the contact's centre, rad, (...).\n"
           "normal_force: R_n, N, (...), above 0.\n" CONTACT_NUMBERS_DOC);
}

void bind_notes(py::class_<FileJoint, JointSet>& type) {
  type.def("notes", &notes, py::arg("normal_force") = py::none(), py::kw_only(),
           py::arg("solution") = py::none(),
           R"(notes(self, normal_force=None, *, solution=None)
--

Warnings of the programs, a sentence each: where the joint exceeds the range of
the theory or the strength of its materials.

normal_force: loads of the joint, R_n, N, (...).
solution: instead of loads, a Solution of this joint that was not unpickled:
    adds what the model neglects at rims, and why there is no contact.)");
}

void bind_laws(py::class_<FileJoint, JointSet>& type) {
  type.def("_half_angle", &law_half_angle);
  type.def("_load_parameter", &law_load_parameter);
  type.def("_pressure", &law_pressure);
  type.def("_friction_coefficients", &law_coefficients);
}

}  // namespace

void bind_contact(py::module_& m, py::class_<JointSet>& joints,
                  py::class_<FileJoint, JointSet>& joint) {
  bind_answers(m, "Coefficients", contact::coefficient_quantities(),
               "What friction_coefficients() returns.");
  bind_size(joints, joint);
  bind_quantities(joints);
  bind_notes(joint);
  bind_laws(joint);
}

}  // namespace contact_python
