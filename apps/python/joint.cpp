#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/tables.hpp"
#include "python/answers.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"

namespace contact_python {
namespace {

using contact::JointContact;
using contact::JointSolution;
using contact::JointSpec;
using contact::RestSolution;
using contact::SlidingContact;
using contact::TomlTable;
using Eigen::Vector3d;

// Solutions, with warnings of their largest contact.
template <class Solve>
Answers<JointSolution> solutions(const FileJoint& self,
                                 std::initializer_list<Argument> arguments,
                                 const Solve& solve) {
  contact::LargestContact largest;
  auto all = answers<JointSolution>(arguments, [&](const double* const* at) {
    const JointSolution s = solve(at);
    largest.add(s.half_angle, s.peak_pressure);
    return s;
  });
  warn_of(self.limits(), largest);
  return all;
}

Answers<JointSolution> solve(const FileJoint& self, const Numbers& reaction,
                             const Numbers& angular_velocity,
                             const std::optional<Numbers>& axis, bool warm) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  JointSolution last;
  return solutions(self,
                   {{"reaction", reaction, 3},
                    {"angular_velocity", angular_velocity, 3},
                    axis ? Argument("axis", *axis, 3) : Argument(none)},
                   [&](const double* const* at) {
                     const contact::Joint::Slip slip{
                         vector_at(at[0]), vector_at(at[1]), vector_at(at[2])};
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
  return solutions(
      self,
      {{"normal_force", normal_force, 3},
       {"angular_velocity", angular_velocity, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        return joint.solve_contact(
            {vector_at(at[0]), vector_at(at[1]), vector_at(at[2])});
      });
}

Answers<RestSolution> at_rest(const FileJoint& self, const Numbers& reaction,
                              const Numbers& moment,
                              const std::optional<Numbers>& axis) {
  const contact::Joint& joint = self.joint();
  const Vector3d none = Vector3d::Zero();
  contact::LargestContact largest;
  auto all = answers<RestSolution>(
      {{"reaction", reaction, 3},
       {"moment", moment, 3},
       axis ? Argument("axis", *axis, 3) : Argument(none)},
      [&](const double* const* at) {
        const RestSolution s = joint.at_rest(
            {vector_at(at[0]), vector_at(at[1]), vector_at(at[2])});
        largest.add(s.slip.half_angle, s.slip.peak_pressure);
        return s;
      });
  warn_of(self.limits(), largest);
  return all;
}

Answers<contact::SlidingContact::Rating> pv(const FileJoint& self,
                                            const Numbers& reaction,
                                            const Numbers& angular_velocity) {
  const contact::Joint& joint = self.joint();
  contact::LargestContact largest;
  auto all = answers<contact::SlidingContact::Rating>(
      {{"reaction", reaction, 3}, {"angular_velocity", angular_velocity, 3}},
      [&](const double* const* at) {
        const Vector3d rate = vector_at(at[1]);
        const JointSolution s = joint.solve({vector_at(at[0]), rate});
        largest.add(s.half_angle, s.peak_pressure);
        return SlidingContact(joint.contact(), s, rate).rating();
      });
  warn_of(self.limits(), largest);
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

constexpr const char* solve_doc =
    R"(solve(self, reaction, angular_velocity, *, axis=None, warm=False)
--

Friction of the joint while its halves turn, under a known reaction.

reaction: R on the body, N, (..., 3).
angular_velocity: Dw, body against carrier, rad/s, (..., 3); 0 rests.
axis: of a pin, unit vector, (..., 3); the direction of Dw if it is None.
warm: begin each row from the solution of the row before. Rows that are near
    each other take 0.2 to 0.7 of the time; the last digits differ.

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
  type.def("at_rest", &at_rest, py::arg("reaction"), py::arg("moment"),
           py::kw_only(), keyword_axis,
           R"(at_rest(self, reaction, moment, *, axis=None)
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

}  // namespace

FileJoint::FileJoint(const std::string& text, const std::string& source,
                     const std::filesystem::path& folder,
                     const contact::KeySettings& settings)
    : FileJoint(TomlTable::from_text(text, source, contact::joint_keys(),
                                     folder, settings)) {}

FileJoint::FileJoint(const TomlTable& file)
    : toml_(file.toml_text()),
      spec_(checked_spec(file)),
      canonical_(spec_.canonical_text()),
      joint_(contact_of(spec_)),
      limits_(contact().half_angle_law(), contact().pair()) {}

contact::KeySettings key_settings(const Settings& settings) {
  contact::KeySettings all;
  for (const auto& [key, value] : settings) all.push_back({key, value});
  return all;
}

const contact::Joint& FileJoint::joint() const {
  if (!spec_.friction) spec_.contact();  // says so
  return joint_;
}

namespace {

// Laws that do without materials.
std::vector<std::string_view> plain_laws() {
  std::vector<std::string_view> names;
  const auto add = [&](const auto& entries) {
    for (const auto* entry : entries) {
      using Needs = contact::detail::LawEntry::Needs;
      if (entry->about.needs == Needs::nothing) {
        names.push_back(entry->about.name);
      }
    }
  };
  add(contact::detail::half_angle_entries());
  add(contact::detail::pressure_entries());
  return names;
}

}  // namespace

void bind_joint(py::module_& m) {
  m.attr("_plain_laws") = plain_laws();
  bind_answers(m, "Solution", contact::solution_quantities(),
               "What Joint.solve() returns, and Joint.solve_contact().");
  bind_answers(m, "RestSolution", contact::rest_quantities(),
               "What Joint.at_rest() returns.");
  bind_answers(m, "Rating", contact::rating_quantities(),
               "What Joint.pv() returns.");
  py::class_<FileJoint> type(m, "Joint");
  type.def(py::init([](const std::string& text, const std::string& source,
                       const std::filesystem::path& folder,
                       const Settings& settings) {
             return std::make_unique<FileJoint>(text, source, folder,
                                                key_settings(settings));
           }),
           py::arg("text"), py::arg("source"), py::arg("folder"),
           py::arg("settings"), py::call_guard<Unlocked>());
  type.def_property_readonly("_toml", &FileJoint::toml);
  type.def_property_readonly("_canonical", &FileJoint::canonical);
  m.def("_file_toml", &file_toml);
  bind_contact(m, type);
  bind_solutions(type);
}

}  // namespace contact_python
