#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <optional>

#include "libcontact/base/error.hpp"
#include "libcontact/files/named_file.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/load_law/load_law.hpp"
#include "libcontact/pressure/registry.hpp"
#include "python/file_joint.hpp"
#include "python/interpreter_lock.hpp"
#include "python/rows/rows.hpp"

namespace contact_python {
namespace {

using contact::JointSpec;
using contact::TomlTable;

// A file named by another one's key `kind`, with settings: a joint or a pair of
// materials.
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

}  // namespace

namespace {

AnyJoint joint_of(const JointSpec& spec,
                  const std::optional<std::string>& table) {
  contact::SharedLaws laws;
  AnyJoint made = any_joint(spec, laws);
  if (table) made.joint = made.joint.tabulated(*table);
  return made;
}

}  // namespace

FileJoint::FileJoint(const std::string& text, const std::string& source,
                     const std::filesystem::path& folder,
                     const contact::KeySettings& settings, LeftOut left_out,
                     const std::optional<std::string>& table)
    : FileJoint([&] {
        const TomlTable file = TomlTable::from_text(
            text, source, contact::joint_keys(), folder, settings);
        JointSpec spec = left_out.of(contact::joint_of_file(file));
        AnyJoint joint = joint_of(spec, table);
        return FileJoint(file.toml_text(), std::move(spec), std::move(joint));
      }()) {}

FileJoint::FileJoint(std::string toml, JointSpec spec, AnyJoint joint)
    : JointSet({}, {std::move(joint.joint)}, std::move(joint.refusal)),
      toml_(std::move(toml)),
      spec_(std::move(spec)),
      canonical_(spec_.canonical_text()) {}

contact::KeySettings key_settings(const Settings& settings) {
  contact::KeySettings all;
  for (const auto& [key, value] : settings) all.push_back({key, value});
  return all;
}

namespace {

// Laws that depend on the materials.
std::vector<std::string> material_laws() {
  namespace laws = contact::detail;
  const auto depends = [](const auto& entry) {
    return entry.about.needs != laws::LawEntry::Needs::nothing;
  };
  auto names = laws::names_of(laws::half_angle_entries(), depends);
  for (auto& name : laws::names_of(laws::pressure_entries(), depends)) {
    names.push_back(std::move(name));
  }
  return names;
}

// A key with each unit that it may have.
std::vector<std::string> spellings(const contact::KnownKey& known) {
  const std::string key(known.key);
  std::vector<std::string> all;
  for (const contact::Unit& unit : units_of(known.dimension)) {
    all.push_back(key + (unit.ending.empty() ? "" : "_") +
                  std::string(unit.ending));
  }
  if (all.front() != key) all.insert(all.begin(), key);
  return all;
}

// The keys of joint files; for tables the spellings of their keys.
py::dict joint_keys() {
  py::dict tables;
  for (const contact::KnownKey& known : contact::joint_keys()) {
    py::list inside;
    for (const contact::KnownKey& key : known.inside)
      for (const std::string& name : spellings(key)) inside.append(name);
    for (const std::string& name : spellings(known))
      tables[name.c_str()] = inside;
  }
  return tables;
}

std::string kernel(const FileJoint& self, const std::string& language,
                   const std::string& name, double error,
                   const std::optional<std::pair<double, double>>& reaction) {
  const contact::Joint& joint = self.joint();
  const Unlocked unlocked;
  return load_law_text(joint, {.language = language,
                               .name = name,
                               .error = error,
                               .loads = reaction,
                               .joint = self.spec().name})
      .text;
}

constexpr const char* kernel_doc =
    R"(kernel(self, language="c", *, name="friction", error=1e-4, reaction=None)
--

Friction over load as the source text of a function in another language, as
hinge-joint --kernel prints it.

language: "c", "cuda", "glsl", "jax", "js", "numpy" or "st".
name: of the function.
error: largest relative error of the moment, which is measured.
reaction: least and largest load, N, of a ball, and of a pin with adhesion;
    None: load parameters of 1e-3 to 10.
Raises Error for joints without such a law, and for an unattainable error.)";

// Table of contacts at rims between two loads, in bytes.
py::bytes make_table(const FileJoint& self, double least, double most) {
  const contact::Joint& joint = self.joint();
  std::string table;
  {
    const Unlocked unlocked;
    table = joint
                .tabulated({.least_load = least,
                            .most_load = most,
                            .progress =
                                [](double /*share*/) { Rows::heed_signals(); }})
                .table();
  }
  return table;
}

void bind_table(py::class_<FileJoint, JointSet>& type) {
  type.def("_make_table", &make_table);
  type.def_property_readonly(
      "table",
      [](const FileJoint& self) -> std::optional<py::bytes> {
        const std::string table = self[0].table();
        if (table.empty()) return {};
        return table;
      },
      "That of tabulated() as bytes to keep; None without one.");
  type.def_property_readonly(
      "table_error",
      [](const FileJoint& self) -> std::optional<double> {
        const auto check = self[0].table_check();
        if (!check) return {};
        return check->error();
      },
      "Largest error of 100 random states of the table, over the load; None "
      "without one.");
}

}  // namespace

void bind_joint(py::module_& m) {
  m.attr("_material_laws") = material_laws();
  m.attr("_joint_keys") = joint_keys();
  m.def("_file_toml", &file_toml);
  m.def("_named_file", &contact::detail::named_file);
  m.def("_set_shipped_data", [](const std::filesystem::path& folder) {
    contact::detail::shipped_data() = folder;
  });
  // Rejects arguments that compiled functions reject.
  m.def("_numbers", [](const Numbers& given) { return py::array(given); });
  py::class_<JointSet> joints(m, "_JointSet");
  joints.def_property_readonly(
      "shape",
      [](const JointSet& self) { return py::tuple(py::cast(self.shape())); },
      "That of an array of joints; () of one.");
  py::class_<FileJoint, JointSet> type(m, "Joint");
  type.def(
      py::init([](const std::string& text, const std::string& source,
                  const std::filesystem::path& folder, const Settings& settings,
                  bool without_seat, bool without_relief,
                  const std::optional<std::string>& table) {
        const Unlocked unlocked;
        return std::make_unique<FileJoint>(
            text, source, folder, key_settings(settings),
            LeftOut{without_seat, without_relief}, table);
      }),
      py::arg("text"), py::arg("source"), py::arg("folder"),
      py::arg("settings"), py::arg("without_seat"), py::arg("without_relief"),
      py::arg("table"));
  type.def("kernel", &kernel, py::arg("language") = "c", py::kw_only(),
           py::arg("name") = "friction", py::arg("error") = 1e-4,
           py::arg("reaction") = py::none(), kernel_doc);
  bind_table(type);
  type.def_property_readonly("_toml", &FileJoint::toml);
  type.def_property_readonly("_canonical", &FileJoint::canonical);
  bind_contact(m, joints, type);
  bind_solutions(m, joints);
  bind_ratings(m, joints, type);
  bind_stuck(m, type);
  bind_step(m, joints);
  bind_moment_set(m, joints);
  bind_joints(m);
}

}  // namespace contact_python
