#pragma once

#include "cli/program.hpp"
#include "programs/table/run.hpp"

namespace hinge_table {

/// The name in --quantity of the complete elliptic integrals.
inline constexpr const char* elliptic_quantity = "K,E";

/// Their table over theta0, of the modulus sin theta0: columns K and E, by the
/// method exact, or by the paper's approximation (chebyshev) with its relative
/// errors. Throws contact::Error for another method, and for options that
/// change nothing here.
cli::ExitStatus run_elliptic(const Options& options);

}  // namespace hinge_table
