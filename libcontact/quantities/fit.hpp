// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>
#include <variant>

#include "libcontact/identify/identify.hpp"

namespace contact {

/// A quantity of a fit beside its parameters: a number, one with its errors, or
/// one of each number that was measured.
struct FitQuantity {
  std::string_view key;     ///< in Python: "degrees_of_freedom"
  std::string_view symbol;  ///< in reports: "dof"
  std::string_view meaning;
  std::variant<double (*)(const FrictionFit&), int (*)(const FrictionFit&),
               const Estimate& (*)(const FrictionFit&),
               const Eigen::VectorXd& (*)(const FrictionFit&)>
      of;
};

std::span<const FitQuantity> fit_quantities();

/// A parameter for people.
struct FitParameter {
  FrictionParameter parameter;
  std::string_view key;     ///< in Python: "clearance"
  std::string_view column;  ///< in reports: "radial_clearance_m"
  std::string_view name;    ///< in correlations: "clearance"
  std::string_view meaning;
};

std::span<const FitParameter> fit_parameters();
const FitParameter& fit_parameter(FrictionParameter parameter);

}  // namespace contact
