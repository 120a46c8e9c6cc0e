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

}  // namespace contact
