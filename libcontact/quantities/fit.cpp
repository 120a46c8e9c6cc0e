#include "libcontact/quantities/fit.hpp"

#include <algorithm>

namespace contact {
namespace {

using Fit = FrictionFit;
using Eigen::VectorXd;

constexpr FitQuantity of_fit[] = {
    {"effective_coefficient", "f0_effective",
     "f0 alone, with A = 0 and the joint's clearance",
     [](const Fit& f) -> const Estimate& { return f.effective_coefficient; }},
    {"condition", "condition",
     "scaled condition number: above 30 the data do not separate the "
     "parameters",
     [](const Fit& f) { return f.condition; }},
    {"chi2", "chi2", "sum of squares of residuals over sigma",
     [](const Fit& f) { return f.chi2; }},
    {"degrees_of_freedom", "dof", "numbers measured less parameters",
     [](const Fit& f) { return f.degrees_of_freedom; }},
    {"chi2_per_degree", "chi2_per_dof", "1 if sigma is right",
     [](const Fit& f) { return f.chi2 / f.degrees_of_freedom; }},
    {"scale", "scale", "error of the data over sigma",
     [](const Fit& f) { return f.scale; }},
    {"load_trend", "load_trend", "of residuals, in sigma, over ln R",
     [](const Fit& f) -> const Estimate& { return f.load_trend; }},
    {"direction_trend", "direction_trend",
     "of residuals, in sigma per rad, over b",
     [](const Fit& f) -> const Estimate& { return f.direction_trend; }},
    {"rate_trend", "rate_trend", "of residuals, in sigma per rad/s, over |Dw|",
     [](const Fit& f) -> const Estimate& { return f.rate_trend; }},
    {"moment", "fit", "moment of the fit, N m, of each number measured",
     [](const Fit& f) -> const VectorXd& { return f.moment; }},
    {"moment_error", "fit_error", "their standard errors, N m",
     [](const Fit& f) -> const VectorXd& { return f.moment_error; }},
    {"residual", "residual", "(fit - measured)/sigma",
     [](const Fit& f) -> const VectorXd& { return f.residual; }},
    {"weight", "weight", "Huber's",
     [](const Fit& f) -> const VectorXd& { return f.weight; }},
};

constexpr FitParameter parameters[] = {
    {FrictionParameter::coefficient, "coefficient", "f0", "f0",
     "friction coefficient at high pressure"},
    {FrictionParameter::adhesion, "adhesion", "A_Pa", "A", "adhesion"},
    {FrictionParameter::clearance, "clearance", "radial_clearance_m",
     "clearance", "difference of the radii"},
    {FrictionParameter::drag, "drag", "drag_N_m", "drag",
     "resisting moment independent of the load"},
    {FrictionParameter::offset, "offset", "offset_N_m", "offset",
     "moment that does not change sign with the rotation"}};

}  // namespace

std::span<const FitParameter> fit_parameters() { return parameters; }

const FitParameter& fit_parameter(FrictionParameter parameter) {
  return *std::ranges::find(parameters, parameter, &FitParameter::parameter);
}

std::span<const FitQuantity> fit_quantities() { return of_fit; }

}  // namespace contact
