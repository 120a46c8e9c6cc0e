#pragma once

#include <pybind11/pybind11.h>

namespace contact_python {

/// Uses of objects whose __init__() did not run, such as objects from __new__()
/// alone, raise a TypeError. pybind11 would read uninitialised memory in place
/// of the missing C++ object.
void refuse_uninitialised(const pybind11::module_& m);

/// Objects of the module's classes are pickled by every protocol, those that
/// have no state to pickle have a TypeError.
void pickle_by_any_protocol(const pybind11::module_& m);

}  // namespace contact_python
