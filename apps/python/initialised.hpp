#pragma once

#include <pybind11/pybind11.h>

namespace contact_python {

/// Makes objects whose __init__() did not run, such as objects from __new__()
/// alone, raise a TypeError when used. pybind11 would read uninitialised memory
/// in place of the missing C++ object.
void refuse_uninitialised(const pybind11::module_& m);

/// Makes objects of the module's classes picklable by every protocol; objects
/// without a state to pickle raise a TypeError.
void pickle_by_any_protocol(const pybind11::module_& m);

}  // namespace contact_python
