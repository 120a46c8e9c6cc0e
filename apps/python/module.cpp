// The Python module libcontact._core. The package libcontact/__init__.py builds
// on it and contains all that is simpler in Python.
#include <exception>
#include <string>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/version.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/initialised.hpp"

namespace {

// Built with pybind11 before 2.12, it would misread arrays of NumPy 2.
void check_numpy() {
#if PYBIND11_VERSION_HEX < 0x020C0000
  namespace py = pybind11;
  const auto version =
      py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (version.starts_with("0.") || version.starts_with("1.")) return;
  throw py::import_error("libcontact was built with pybind11 " +
                         std::to_string(PYBIND11_VERSION_MAJOR) + "." +
                         std::to_string(PYBIND11_VERSION_MINOR) +
                         ", which does not know NumPy " + version +
                         ": build it with pybind11 2.12 or later, or take "
                         "numpy<2");
#endif
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  check_numpy();
  py::options options;
  options.disable_function_signatures();
  py::register_exception<contact::Error>(m, "Error", PyExc_ValueError);
  m.attr("Error").attr("__module__") = "libcontact";
  // Names of bodies in files may contain any characters: none of them may
  // control a terminal.
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const contact::Error& error) {
      const std::string what = error.what();
      const py::object type =
          py::module_::import("libcontact._core").attr("Error");
      PyErr_SetString(type.ptr(),
                      contact::detail::printable(what, what.npos).c_str());
    }
  });
  m.attr("__version__") = contact::version;
  contact_python::bind_warning(m);
  contact_python::bind_joint(m);
  contact_python::bind_mechanism(m);
  contact_python::bind_play(m);
  contact_python::bind_duty(m);
  contact_python::bind_identify(m);
  contact_python::bind_case(m);
  contact_python::bind_run(m);
  contact_python::refuse_uninitialised(m);
  contact_python::pickle_by_any_protocol(m);
}
