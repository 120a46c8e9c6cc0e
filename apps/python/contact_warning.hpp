#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "libcontact/pressure/validity.hpp"

namespace contact_python {

/// Emits a Python ContactWarning for each limit that the contact exceeds.
/// @return true if there is one
/// @param level  number of Python frames up to the line to report; the first
///               frame is libcontact/_calls.py
/// @throws pybind11::error_already_set if Python turns warnings into errors
bool warn_of(const contact::ContactLimits& limits,
             const contact::LargestContact& largest, int level = 2);

/// Emits a Python ContactWarning.
void warn_of(const std::string& note, int level = 2);

/// The level of Joint.cycle() and identify(): the frames of _calls.py, _Made,
/// the function itself, with_known_keywords() and the caller.
inline constexpr int frames_of_maker = 5;

void bind_warning(pybind11::module_& m);

}  // namespace contact_python
