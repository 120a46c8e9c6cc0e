#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "libcontact/pressure/validity.hpp"

namespace contact_python {

/// Gives Python a ContactWarning for each limit that the contact has passed.
/// @return whether there is one
/// @param level  how many frames of Python up the line is that it is about; the
///   first is that of libcontact/_calls.py
/// @throws pybind11::error_already_set where Python makes warnings errors
bool warn_of(const contact::ContactLimits& limits,
             const contact::LargestContact& largest, int level = 2);

/// Gives Python a ContactWarning.
void warn_of(const std::string& note, int level = 2);

/// The level of Joint.cycle() and identify(): these frames are that of
/// _calls.py, _Made's, theirs, that of with_known_keywords() and the one that
/// calls.
inline constexpr int frames_of_maker = 5;

void bind_warning(pybind11::module_& m);

}  // namespace contact_python
