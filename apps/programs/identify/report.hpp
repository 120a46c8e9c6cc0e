#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/joint/joint_reports.hpp"
#include "libcontact/identify/identify.hpp"

namespace hinge_identify {

/// "f0", "A_Pa", "radial_clearance_m", "drag_N_m", "offset_N_m".
std::string_view column_of(contact::FrictionParameter parameter);

/// A line for each parameter and each number that says how well they are known.
cli::Report report_of(const contact::FrictionFit& fit, bool profile);

/// A row for each joint and number that was measured.
void write_residuals(const std::vector<cli::Joint>& joints,
                     const std::vector<contact::FrictionFit>& fits,
                     std::span<const contact::MeasuredMoment> data,
                     cli::Output& output, const cli::TableStyle& style);

/// Warnings of parameters that the data cannot tell, and of misfits.
std::vector<std::string> warnings(const contact::FrictionFit& fit,
                                  std::span<const contact::MeasuredMoment> data,
                                  const contact::IdentifyOptions& options);

/// Angle between the reaction and Dw.
double direction_deg(const contact::MeasuredMoment& datum);

}  // namespace hinge_identify
