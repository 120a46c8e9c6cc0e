// The Python module libcontact._core. What is nicer said in Python is said in
// libcontact/__init__.py, which stands on it.
#include "libcontact/base/error.hpp"
#include "libcontact/version.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/initialised.hpp"

PYBIND11_MODULE(_core, m) {
  namespace py = pybind11;
  py::options options;
  options.disable_function_signatures();
  py::register_exception<contact::Error>(m, "Error", PyExc_ValueError);
  m.attr("Error").attr("__module__") = "libcontact";
  m.attr("__version__") = contact::version;
  contact_python::bind_warning(m);
  contact_python::bind_joint(m);
  contact_python::bind_play(m);
  contact_python::bind_seat(m);
  contact_python::bind_finite_pin(m);
  contact_python::bind_duty(m);
  contact_python::bind_identify(m);
  contact_python::bind_case(m);
  contact_python::bind_run(m);
  contact_python::refuse_uninitialised(m);
  contact_python::pickle_by_any_protocol(m);
}
