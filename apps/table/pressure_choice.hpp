#pragma once

#include "cli/laws.hpp"
#include "table/run.hpp"

namespace hinge_table {

/// A pressure law, and the name of the joint file that it is for, or "".
struct PressureChoice {
  cli::NamedPressure law;
  std::string joint;
};

/// The pressure law that the options name, for a ball of their materials.
/// Throws contact::Error if they do not fit together, or if the law depends on
/// the materials and there are none.
PressureChoice chosen_pressure(const Options& options);

}  // namespace hinge_table
