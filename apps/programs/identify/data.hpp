#pragma once

#include <string>
#include <vector>

#include "libcontact/identify/identify.hpp"
#include "programs/identify/run.hpp"

namespace hinge_identify {

/// The measured moments of Options::data. Throws contact::Error if columns are
/// missing, a line is bad, or no errors are given.
/// @param identify  out: names, "rig.csv, line 3" of each, and direction
std::vector<contact::MeasuredMoment> read_data(
    const Options& options, bool pin, contact::IdentifyOptions& identify);

}  // namespace hinge_identify
