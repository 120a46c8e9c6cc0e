#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "libcontact/friction_integrals.hpp"

/// The parts of the program hinge-table.
namespace hinge_table {

/// Columns of a table after theta0_deg and alpha_deg, in the order of
/// `values`.
inline constexpr std::array<std::string_view, 10> quantities = {
    "I_normal", "I_p", "J_p", "K_p",     "I_a",
    "J_a",      "K_a", "chi", "sigma_Y", "sigma_Z"};
std::array<double, quantities.size()> values(
    const contact::FrictionIntegrals& integrals);

/// A method of the library over many points: half-angles (rad), slip axes,
/// results.
using Method = std::function<void(std::span<const double>,
                                  std::span<const contact::SlipAxis>,
                                  std::span<contact::FrictionIntegrals>)>;

/// The method of that name. Throws contact::Error with the names there are.
/// @param tolerance  relative, of the method quadrature
Method find_method(const std::string& name, double tolerance);

}  // namespace hinge_table
