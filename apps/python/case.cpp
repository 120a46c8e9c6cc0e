#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "python/file_case.hpp"
#include "python/file_joint.hpp"
#include "python/interpreter_lock.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_reader.hpp"

namespace contact_python {
namespace {

namespace py = pybind11;
using contact::TomlTable;

std::unique_ptr<FileCase> make_case(const std::string& text,
                                    const std::string& source,
                                    const std::filesystem::path& folder,
                                    const Settings& settings) {
  const auto all = key_settings(settings);
  const Unlocked unlocked;
  return std::make_unique<FileCase>(FileCase{
      separation::parse_case(text, source, {}, all, folder),
      TomlTable::from_text(text, source, separation::case_keys(), folder, all)
          .toml_text()});
}

}  // namespace

void bind_case(py::module_& m) {
  py::class_<FileCase>(m, "Case")
      .def(py::init(&make_case), py::arg("text"), py::arg("source"),
           py::arg("folder"), py::arg("settings"))
      .def_readonly("_toml", &FileCase::toml)
      .def_property_readonly("_canonical",
                             [](const FileCase& c) { return c.of.content; })
      .def_property_readonly("name",
                             [](const FileCase& c) { return c.of.name; });
}

}  // namespace contact_python
