#pragma once

#include <string>
#include <vector>

#include "programs/pressure/pressure_table.hpp"

namespace hinge_pressure {

/// Draws the pressure over the angle from the contact's centre with a curve for
/// each joint, law and load. Colours distinguish the laws or, if there is only
/// one, the joints or loads.
/// @return as cli::draw()
std::string draw(const std::vector<PressureTable>& tables,
                 const std::vector<cli::Joint>& joints,
                 const std::vector<LoadedContacts>& contacts,
                 const std::string& file);

/// Throws contact::Error if a picture of these joints needs too many curves.
void check_curves(const std::vector<cli::Joint>& joints);

}  // namespace hinge_pressure
