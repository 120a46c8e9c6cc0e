#include "python/initialised.hpp"

#include <cstddef>

namespace contact_python {
namespace {

namespace py = pybind11;

// pybind11 asks for memory where it finds none behind an argument. Constructors
// bring their own.
void* no_memory(std::size_t) {
  throw py::type_error("__init__() of an argument has not been called");
}

}  // namespace

void refuse_uninitialised(const py::module_& m) {
  for (const auto& [name, value] : m.attr("__dict__").cast<py::dict>()) {
    if (!PyType_Check(value.ptr())) continue;
    auto* const type = reinterpret_cast<PyTypeObject*>(value.ptr());
    if (auto* const info = py::detail::get_type_info(type)) {
      info->operator_new = &no_memory;
    }
  }
}

}  // namespace contact_python
