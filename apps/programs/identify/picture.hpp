#pragma once

#include <span>
#include <string>

#include "libcontact/identify/identify.hpp"

namespace hinge_identify {

/// Draws the moments about Dw over rho R with the fit and its band over the
/// load, and the residuals over load, direction and rate.
/// @return "" or the reason why there is no picture
std::string draw_fit(const std::string& title, const contact::FrictionFit& fit,
                     std::span<const contact::MeasuredMoment> data,
                     double level, const std::string& file);

}  // namespace hinge_identify
