#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>

#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/friction/any_pressure.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/python/answers.hpp"
#include "libcontact/python/file_joint.hpp"
#include "libcontact/python/ratings.hpp"

namespace contact_python {
namespace {

using contact::JointContact;
using contact::JointSolution;
using contact::JointSpec;
using contact::RestSolution;
using contact::SlidingContact;
using contact::TomlTable;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Field<RestSolution> rest_fields[] = {
    {"status", [](const RestSolution& s) { return int(s.status); },
     "Status, as numbers."},
    {"holds", [](const RestSolution& s) { return s.utilisation <= 1; },
     "Whether the joint rests."},
    {"utilisation", [](const RestSolution& s) { return s.utilisation; },
     "tau, the share of the moment it can hold in this direction that M "
     "needs."},
    {"direction", [](const RestSolution& s) { return s.direction; },
     "u in which it would begin to slide, (..., 3)."},
    {"normal_force", [](const RestSolution& s) { return s.slip.normal_force; },
     "R_n of that sliding, N."},
    {"friction_moment",
     [](const RestSolution& s) { return s.slip.friction_moment; },
     "M_t of that sliding, M/tau, N m, (..., 3)."},
    {"half_angle", [](const RestSolution& s) { return s.slip.half_angle; },
     "theta0 of that sliding, rad."},
};

struct Coefficients {
  contact::FrictionTriple of;
};
const Field<Coefficients> coefficient_fields[] = {
    {"force", [](const Coefficients& c) { return c.of.force; },
     "chi, over f0 R_n."},
    {"sliding", [](const Coefficients& c) { return c.of.sliding; },
     "sigma_Y, over f0 rho R_n."},
    {"spinning", [](const Coefficients& c) { return c.of.spinning; },
     "sigma_Z, over f0 rho R_n."},
};

Answers<JointSolution> solve(const FileJoint& self, const Numbers& reaction,
                             const Numbers& angular_velocity,
                             const std::optional<Numbers>& axis, bool warm) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  JointSolution last;
  return answers<JointSolution>(
      {{"reaction", reaction, 3},
       {"angular_velocity", angular_velocity, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        const contact::Joint::Slip slip{vector_at(at[0]), vector_at(at[1]),
                                        vector_at(at[2])};
        if (!warm) return joint.solve(slip);
        return last = joint.solve(slip, last);
      });
}

Answers<JointSolution> solve_contact(const FileJoint& self,
                                     const Numbers& normal_force,
                                     const Numbers& angular_velocity,
                                     const std::optional<Numbers>& axis) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  return answers<JointSolution>(
      {{"normal_force", normal_force, 3},
       {"angular_velocity", angular_velocity, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        return joint.solve_contact(
            {vector_at(at[0]), vector_at(at[1]), vector_at(at[2])});
      });
}

Answers<RestSolution> utilisation(const FileJoint& self,
                                  const Numbers& reaction,
                                  const Numbers& moment,
                                  const std::optional<Numbers>& axis) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  return answers<RestSolution>(
      {{"reaction", reaction, 3},
       {"moment", moment, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        return joint.utilisation(
            {vector_at(at[0]), vector_at(at[1]), vector_at(at[2])});
      });
}

Answers<Rating> pv(const FileJoint& self, const Numbers& reaction,
                   const Numbers& angular_velocity) {
  const contact::Joint& joint = self.joint();
  return answers<Rating>(
      {{"reaction", reaction, 3}, {"angular_velocity", angular_velocity, 3}},
      [&](const double* const* at) {
        const Vector3d rate = vector_at(at[1]);
        const JointSolution s = joint.solve({vector_at(at[0]), rate});
        return rating(SlidingContact(joint.contact(), s, rate));
      });
}

// Over places of the contact of one state.
py::dict pv_at(const FileJoint& self, const Vector3d& reaction,
               const Vector3d& rate, const Numbers& places) {
  const contact::Joint& joint = self.joint();
  const JointSolution s = joint.solve({reaction, rate});
  const SlidingContact sliding(joint.contact(), s, rate);
  const auto over = [&](double (SlidingContact::*of)(const Vector3d&)
                            const noexcept) {
    return evaluate({{"places", places, 3}}, [&](const double* const* at) {
      return (sliding.*of)(vector_at(at[0]));
    });
  };
  py::dict result;
  result["pressure"] = over(&SlidingContact::pressure);
  result["pv"] = over(&SlidingContact::pv);
  result["heat_flux"] = over(&SlidingContact::heat_flux);
  return result;
}

// What a quantity of a contact depends on: theta0 or R_n, as they are given.
template <class Value>
py::object of_force(const Numbers& force, const Value& value) {
  return evaluate({{"normal_force", force, 0}},
                  [&](const double* const* at) { return value(*at[0]); });
}

py::object pressure(const FileJoint& self, const Numbers& theta,
                    const Numbers& force) {
  const JointContact& contact = self.contact();
  return evaluate({{"theta", theta, 0}, {"normal_force", force, 0}},
                  [&](const double* const* at) {
                    const double load =
                        contact.geometry().load_from_force(*at[1]);
                    return contact.pressure_law().pressure(
                               *at[0], contact.half_angle(*at[1]).half_angle) *
                           contact.geometry().pressure_unit(load);
                  });
}

// delta in m or its derivative in N/m.
double approach(const JointContact& contact, double force) {
  return contact.half_angle_law()
             .approach(contact.half_angle(force).half_angle)
             .approach *
         contact.geometry().radial_clearance();
}

double stiffness(const JointContact& contact, double force) {
  const auto& geometry = contact.geometry();
  const double length = geometry.kind() == contact::JointKind::ball
                            ? geometry.radius()
                            : geometry.length();
  return contact.half_angle_law()
             .approach(contact.half_angle(force).half_angle)
             .stiffness *
         contact.pair().effective_modulus() * length;
}

std::vector<std::string> notes(const FileJoint& self,
                               const std::optional<Numbers>& force) {
  std::vector<std::string> all = self.spec().validity_notes();
  if (!force) return all;
  const JointContact& contact = self.contact();
  contact::LargestContact largest;
  Rows({{"normal_force", *force, 0}}).for_each([&](const double* const* at) {
    const double half_angle = contact.half_angle(*at[0]).half_angle;
    largest.add(half_angle, contact.peak_pressure(*at[0], half_angle));
  });
  for (auto& note :
       contact::contact_notes(contact.geometry().kind(), self.spec().pair,
                              largest.half_angle, largest.peak_pressure)) {
    all.push_back(std::move(note));
  }
  return all;
}

// Of a law alone, as functions of the module.
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

Answers<Coefficients> law_coefficients(const FileJoint& self,
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
  Answers<Coefficients> result{rows.shape(), {}};
  const py::gil_scoped_release unlocked;
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
    result.rows.push_back({{out[0][i], out[1][i], out[2][i]}});
  }
  return result;
}

JointSpec checked_spec(const TomlTable& file) {
  JointSpec spec = contact::joint_from_table(file);
  file.refuse_idle();
  return spec;
}

JointContact contact_of(JointSpec spec) {
  if (!spec.friction) spec.friction = contact::FrictionLaw(0);
  return spec.contact();
}

// A file that another one names with its key `kind`, with settings: a joint or
// a pair of materials.
std::string file_toml(const std::string& kind,
                      const std::filesystem::path& path,
                      const Settings& settings) {
  contact::KnownKeys keys = contact::joint_keys();
  if (kind == "pair") {
    const auto of = [](const contact::KnownKeys& all, std::string_view key) {
      return *std::ranges::find(all, key, &contact::KnownKey::key);
    };
    keys = of(of(keys, "materials").inside, kind).of_file;
  }
  return TomlTable::from_file(path, keys, key_settings(settings)).toml_text();
}

void bind_size(py::class_<FileJoint>& type) {
  const auto number = [&](const char* name, auto value, const char* doc) {
    type.def_property_readonly(
        name, [value](const FileJoint& self) { return value(self.contact()); },
        doc);
  };
  type.def_property_readonly(
      "name", [](const FileJoint& self) { return self.spec().name; },
      "As the file has it.");
  number(
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
  number(
      "half_angle_law",
      [](const JointContact& c) { return c.half_angle_law().name(); },
      "Its name: \"fitted\", \"exact\", ...");
  number(
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

void bind_contact(py::class_<FileJoint>& type) {
  const auto of = [&](const char* name, auto value, const char* doc) {
    type.def(
        name,
        [value](const FileJoint& self, const Numbers& normal_force) {
          const JointContact& contact = self.contact();
          return of_force(normal_force,
                          [&](double force) { return value(contact, force); });
        },
        py::arg("normal_force"), doc);
  };
  of(
      "half_angle",
      [](const JointContact& c, double force) {
        return c.half_angle(force).half_angle;
      },
      "half_angle(self, normal_force)\n--\n\n"
      "theta0 of the contact, rad; NaN where the law has none.\n\n"
      "normal_force: R_n, N, (...).");
  of(
      "load_parameter",
      [](const JointContact& c, double force) {
        return c.load_parameter(force);
      },
      "load_parameter(self, normal_force)\n--\n\n"
      "mu of a ball, lambda of a pin. normal_force: R_n, N, (...).");
  of(
      "peak_pressure",
      [](const JointContact& c, double force) {
        return c.peak_pressure(force, c.half_angle(force).half_angle);
      },
      "peak_pressure(self, normal_force)\n--\n\n"
      "Pa. normal_force: R_n, N, (...), above 0.");
  of(
      "mean_pressure",
      [](const JointContact& c, double force) {
        return c.mean_pressure(force, c.half_angle(force).half_angle);
      },
      "mean_pressure(self, normal_force)\n--\n\n"
      "Over the contact's own area, Pa. normal_force: R_n, N, (...), above 0.");
  of(
      "nominal_pressure",
      [](const JointContact& c, double force) {
        return c.geometry().nominal_pressure(force);
      },
      "nominal_pressure(self, normal_force)\n--\n\n"
      "Of catalogues: force over projected area, Pa. normal_force: N, (...).");
  of(
      "contact_area",
      [](const JointContact& c, double force) {
        return c.area(c.half_angle(force).half_angle);
      },
      "contact_area(self, normal_force)\n--\n\n"
      "m^2. normal_force: R_n, N, (...).");
  of("approach", &approach,
     "approach(self, normal_force)\n--\n\n"
     "How far R_n presses the ball or pin into its seat or hole, from first\n"
     "touch, m. NaN unless the half-angle law is exact, and where there is "
     "none:\na pin in an infinite hole, loaded through the back.\n\n"
     "normal_force: R_n, N, (...), above 0. To 2e-7 of itself.");
  of("stiffness", &stiffness,
     "stiffness(self, normal_force)\n--\n\n"
     "d R_n/d approach, N/m. NaN and accuracy as of approach().\n\n"
     "normal_force: R_n, N, (...), above 0.");
  type.def("pressure", &pressure, py::arg("theta"), py::arg("normal_force"),
           "pressure(self, theta, normal_force)\n--\n\n"
           "Contact pressure, Pa; 0 outside of the contact.\n\n"
           "theta: angle from the contact's centre, rad, (...).\n"
           "normal_force: R_n, N, (...), above 0.");
  type.def("notes", &notes, py::arg("normal_force") = py::none(),
           R"(notes(self, normal_force=None)
--

Where the joint leaves the range of the theory, and what its materials bear, a
sentence each: what the programs warn of.

normal_force: the loads that it has, R_n, N, (...).)");
}

constexpr const char* solve_doc =
    R"(solve(self, reaction, angular_velocity, *, axis=None, warm=False)
--

Friction of the joint while its halves turn, under a known reaction.

reaction: R on the body, N, (..., 3).
angular_velocity: Dw, body against carrier, rad/s, (..., 3); 0 rests.
axis: of a pin, unit vector, (..., 3); the direction of Dw if it is None.
warm: begin each row from the solution of the row before. Rows that are near
    each other take half the time; the last digits differ.

Returns a Solution of the shape to which the arguments broadcast. To 2e-13 of
the equations; NaN in an argument gives NaN with Status.OUT_OF_RANGE.)";

void bind_solutions(py::class_<FileJoint>& type) {
  const auto keyword_axis = py::arg("axis") = py::none();
  type.def("solve", &solve, py::arg("reaction"), py::arg("angular_velocity"),
           py::kw_only(), keyword_axis, py::arg("warm") = false, solve_doc);
  type.def("solve_contact", &solve_contact, py::arg("normal_force"),
           py::arg("angular_velocity"), py::kw_only(), keyword_axis,
           R"(solve_contact(self, normal_force, angular_velocity, *, axis=None)
--

Friction under a known normal force: nothing to solve. With the reaction in its
place it is the traditional estimate.

normal_force: R_n n on the body, N, (..., 3).
angular_velocity, axis: as in solve().)");
  type.def("utilisation", &utilisation, py::arg("reaction"), py::arg("moment"),
           py::kw_only(), keyword_axis,
           R"(utilisation(self, reaction, moment, *, axis=None)
--

Whether the joint rests under a reaction while friction supplies a moment, and
how near it is to sliding.

reaction: R on the body, N, (..., 3).
moment: M on the body that friction has to supply, N m, (..., 3).

Returns a RestSolution.)");
  type.def("pv", &pv, py::arg("reaction"), py::arg("angular_velocity"),
           R"(pv(self, reaction, angular_velocity)
--

p v and heat over the contact while the halves turn: their largest values with
the place, means, sums. Arguments as in solve(). Returns a Rating.)");
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

void bind_laws(py::class_<FileJoint>& type) {
  type.def("_half_angle", &law_half_angle);
  type.def("_load_parameter", &law_load_parameter);
  type.def("_pressure", &law_pressure);
  type.def("_friction_coefficients", &law_coefficients);
}

}  // namespace

FileJoint::FileJoint(const std::string& text, const std::string& source,
                     const std::filesystem::path& folder,
                     const contact::KeySettings& settings)
    : FileJoint(TomlTable::from_text(text, source, contact::joint_keys(),
                                     folder, settings)) {}

FileJoint::FileJoint(const TomlTable& file)
    : toml_(file.toml_text()),
      canonical_(file.canonical_text()),
      spec_(checked_spec(file)),
      joint_(contact_of(spec_)) {}

contact::KeySettings key_settings(const Settings& settings) {
  contact::KeySettings all;
  for (const auto& [key, value] : settings) all.push_back({key, value});
  return all;
}

const contact::Joint& FileJoint::joint() const {
  if (!spec_.friction) spec_.contact();  // says so
  return joint_;
}

// All but the materials' file is in the text.
bool FileJoint::operator==(const FileJoint& other) const {
  const auto mine = contact().strength(1);
  const auto theirs = other.contact().strength(1);
  return canonical_ == other.canonical_ && spec_.pair == other.spec_.pair &&
         mine.pressure_part == theirs.pressure_part &&
         mine.area_part == theirs.area_part;
}

void bind_joint(py::module_& m) {
  bind_answers(m, "Solution", solution_fields(),
               "What Joint.solve() returns, and Joint.solve_contact().");
  bind_answers(m, "RestSolution",
               std::span<const Field<RestSolution>>(rest_fields),
               "What Joint.utilisation() returns.");
  bind_answers(m, "Rating", rating_fields(), "What Joint.pv() returns.");
  bind_answers(m, "Coefficients",
               std::span<const Field<Coefficients>>(coefficient_fields),
               "What friction_coefficients() returns.");
  py::class_<FileJoint> type(m, "Joint");
  type.def(py::init([](const std::string& text, const std::string& source,
                       const std::filesystem::path& folder,
                       const Settings& settings) {
             return std::make_unique<FileJoint>(text, source, folder,
                                                key_settings(settings));
           }),
           py::arg("text"), py::arg("source"), py::arg("folder"),
           py::arg("settings"), py::call_guard<py::gil_scoped_release>());
  type.def_property_readonly("_toml", &FileJoint::toml);
  type.def_property_readonly("_canonical", &FileJoint::canonical);
  type.def("_same", &FileJoint::operator==);
  m.def("_file_toml", &file_toml);
  bind_size(type);
  bind_contact(type);
  bind_solutions(type);
  bind_laws(type);
}

}  // namespace contact_python
