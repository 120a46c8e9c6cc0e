#pragma once

#include <string>
#include <vector>

#include "pressure/pressure_table.hpp"

namespace hinge_pressure {

/// Draws the pressure over the angle from the contact's centre, a curve for
/// each law and load; the colours are those of the laws, or of the loads if
/// there is one law.
/// @return as cli::draw()
std::string draw(const PressureTable& pressures, const cli::Joint& joint,
                 const LoadedContacts& contacts, const std::string& file);

}  // namespace hinge_pressure
