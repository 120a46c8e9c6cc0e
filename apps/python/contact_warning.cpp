#include "apps/python/contact_warning.hpp"

#include <string>
#include <vector>

#include "libcontact/base/text.hpp"

namespace contact_python {
namespace {

namespace py = pybind11;

constexpr const char* warning_name = "ContactWarning";

}  // namespace

void warn_of(const std::string& note, int level) {
  const py::object category =
      py::module_::import("libcontact._core").attr(warning_name);
  const std::string shown = contact::detail::printable(note, note.npos);
  if (PyErr_WarnEx(category.ptr(), shown.c_str(), level) != 0) {
    throw py::error_already_set();
  }
}

bool warn_of(const contact::ContactLimits& limits,
             const contact::LargestContact& largest, int level) {
  const std::vector<std::string> passed = limits.passed(largest);
  for (const std::string& text : passed) warn_of(text, level);
  return !passed.empty();
}

void bind_warning(py::module_& m) {
  m.attr(warning_name) =
      py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
          "libcontact.ContactWarning",
          "A contact leaves the theory or what its materials bear: see "
          "Joint.notes().",
          PyExc_UserWarning, nullptr));
}

}  // namespace contact_python
