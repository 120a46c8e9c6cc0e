#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/joint/joint_reports.hpp"
#include "libcontact/identify/identify.hpp"

namespace hinge_identify {

/// "f0", "A_Pa", "radial_clearance_m", "drag_N_m", "offset_N_m".
std::string_view column_of(contact::FrictionParameter parameter);

/// A line for each parameter, and for each number on its uncertainty.
cli::Report report_of(const contact::FrictionFit& fit, bool profile);

/// Writes a row for each joint and each measured number.
void write_residuals(const std::vector<cli::Joint>& joints,
                     const std::vector<contact::FrictionFit>& fits,
                     std::span<const contact::MeasuredMoment> data,
                     cli::Output& output, const cli::TableStyle& style);

/// Warns of parameters that the data do not determine, and of misfits.
std::vector<std::string> warnings(const contact::FrictionFit& fit,
                                  std::span<const contact::MeasuredMoment> data,
                                  const contact::IdentifyOptions& options);

/// Angle between the reaction and Dw.
double direction_deg(const contact::MeasuredMoment& datum);

}  // namespace hinge_identify
