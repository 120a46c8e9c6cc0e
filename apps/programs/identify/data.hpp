#pragma once

#include <string>
#include <vector>

#include "libcontact/identify/identify.hpp"
#include "programs/identify/run.hpp"

namespace hinge_identify {

/// Reads the measured moments of Options::data. Throws contact::Error if
/// columns are missing, a line is bad, or no errors are given.
/// @param identify  out: name of each moment, "rig.csv, line 3", and direction
std::vector<contact::MeasuredMoment> read_data(
    const Options& options, bool pin, contact::IdentifyOptions& identify);

}  // namespace hinge_identify
