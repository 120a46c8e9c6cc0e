#pragma once

#include "programs/duty/options.hpp"

namespace hinge_duty {

/// The whole program. Throws contact::Error for options that are wrong.
cli::ExitStatus run(const Options& options);

}  // namespace hinge_duty
