#pragma once

#include "libcontact/duty/duty_cycle.hpp"
#include "programs/duty/options.hpp"

namespace hinge_duty {

/// The cycle of --cycle, --period, --euler, --force-on and --force-in. Throws
/// contact::Error if they do not fit together or a line of the file is bad.
contact::DutyCycle read_cycle(const Options& options, bool is_pin);

}  // namespace hinge_duty
