#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "libcontact/identify/identify.hpp"

namespace hinge_identify {

/// "f0", "A_Pa", "radial_clearance_m".
std::string_view column_of(contact::FrictionParameter parameter);

/// The table: a row for each parameter and each number that says how well they
/// are known.
void write_report(const contact::FrictionFit& fit, bool profile,
                  const cli::OutputOptions& options);

/// A row for each number that was measured.
void write_residuals(const contact::FrictionFit& fit,
                     std::span<const contact::MeasuredMoment> data,
                     const std::string& file,
                     const cli::OutputOptions& options);

/// What the data cannot tell, and what does not fit.
std::vector<std::string> warnings(const contact::FrictionFit& fit,
                                  std::span<const contact::MeasuredMoment> data,
                                  const contact::IdentifyOptions& options);

/// Angle between the reaction and Dw.
double direction_deg(const contact::MeasuredMoment& datum);

}  // namespace hinge_identify
