#include "python/initialised.hpp"

#include <cstddef>
#include <string>

namespace contact_python {
namespace {

namespace py = pybind11;

// pybind11 requests memory if an argument has no C++ object. Constructors
// allocate their own.
void* no_memory(std::size_t) {
  throw py::type_error("__init__() of an argument has not been called");
}

// Calls `finish(type, pybind11's record of it)` for each class of the module.
template <class Finish>
void for_each_class(const py::module_& m, const Finish& finish) {
  for (const auto& [name, value] : m.attr("__dict__").cast<py::dict>()) {
    if (!PyType_Check(value.ptr())) continue;
    auto* const type = reinterpret_cast<PyTypeObject*>(value.ptr());
    if (auto* const info = py::detail::get_type_info(type)) finish(value, info);
  }
}

// Reduces objects as protocol 2 does, for all protocols. Protocols 0 and 1
// would create an object of the base class, which ends the process.
py::tuple reduced(const py::object& self) {
  const py::type type = py::type::of(self);
  if (!py::hasattr(type, "__setstate__")) {
    throw py::type_error("cannot pickle '" +
                         py::str(type.attr("__name__")).cast<std::string>() +
                         "' object");
  }
  return py::make_tuple(py::module_::import("copyreg").attr("__newobj__"),
                        py::make_tuple(type), self.attr("__getstate__")());
}

}  // namespace

void refuse_uninitialised(const py::module_& m) {
  for_each_class(m, [](py::handle /*type*/, py::detail::type_info* info) {
    info->operator_new = &no_memory;
  });
}

void pickle_by_any_protocol(const py::module_& m) {
  for_each_class(m, [](py::handle type, py::detail::type_info* /*info*/) {
    type.attr("__reduce__") =
        py::cpp_function(&reduced, py::name("__reduce__"), py::is_method(type));
  });
}

}  // namespace contact_python
