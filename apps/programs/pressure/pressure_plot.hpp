#pragma once

#include <string>
#include <vector>

#include "programs/pressure/pressure_table.hpp"

namespace hinge_pressure {

/// Draws the pressure over the angle from the contact's centre, a curve for
/// each joint, law and load; the colours distinguish the laws, or the joints or
/// loads if there is one law.
/// @return as cli::draw()
std::string draw(const std::vector<PressureTable>& tables,
                 const std::vector<cli::Joint>& joints,
                 const std::vector<LoadedContacts>& contacts,
                 const std::string& file);

/// Throws contact::Error if a picture of them would have too many curves.
void check_curves(const std::vector<cli::Joint>& joints);

}  // namespace hinge_pressure
