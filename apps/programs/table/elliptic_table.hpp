#pragma once

#include <string_view>

#include "cli/program.hpp"
#include "programs/table/run.hpp"

namespace hinge_table {

/// Rejects options that have no effect on the table of a --quantity without
/// friction integrals: slip axes, pictures, a joint and its pressure.
void refuse_idle(const Options& options, std::string_view quantity);

/// The --quantity of the complete elliptic integrals.
inline constexpr const char* elliptic_quantity = "K,E";

/// Writes their table over theta0, with modulus sin theta0: columns K and E by
/// the method exact, or by the paper's approximation (chebyshev) with its
/// relative errors. Throws contact::Error for another method and for options
/// without effect.
cli::ExitStatus run_elliptic(const Options& options);

}  // namespace hinge_table
