#pragma once

#include <pybind11/pybind11.h>

namespace contact_python {

/// Objects of the module's classes whose __init__() did not run, as those of
/// __new__() alone, have a TypeError for who uses them. pybind11 makes memory
/// of any contents in the place of what they do not have, and reads it.
void refuse_uninitialised(const pybind11::module_& m);

/// Objects of the module's classes are pickled by every protocol, those that
/// have no state to pickle have a TypeError.
void pickle_by_any_protocol(const pybind11::module_& m);

}  // namespace contact_python
