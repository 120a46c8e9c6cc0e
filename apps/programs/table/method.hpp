#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/joint/laws.hpp"
#include "libcontact/quantities/tables.hpp"

/// The parts of the program hinge-table.
namespace hinge_table {

/// Columns of a table after theta0_deg and alpha_deg.
using Quantity = contact::Quantity<contact::FrictionIntegrals>;
inline std::span<const Quantity> quantities() {
  return contact::integral_quantities();
}

/// Many points: half-angles (rad), sine and cosine of the slip axis angle.
struct Points {
  std::span<const double> half_angle;
  std::span<const double> axis_sin;
  std::span<const double> axis_cos;
};

/// Results of as many points, for each of the quantities.
using Columns = std::vector<std::span<double>>;

/// A method of the library over many points; returns how many of them missed
/// the tolerance of an iteration.
using MethodFunction =
    std::function<std::size_t(const Points&, const Columns&)>;

/// A method, and the name of its pressure law and where that ends.
struct Method {
  MethodFunction function;
  std::string pressure;
  double largest_half_angle;  ///< rad

  std::size_t operator()(const Points& points, const Columns& columns) const {
    return function(points, columns);
  }
};

/// The method of that name. Throws contact::Error with the names there are:
/// exact, elliptic, quadrature (if contact::reference is built), planar,
/// viscous, cosine; or if it knows the cosine pressure only and another one is
/// asked for.
/// @param tolerance  relative, of quadrature
/// @param pressure   of a ball; kept by the method
Method find_method(const std::string& name, double tolerance,
                   const cli::NamedPressure& pressure);

}  // namespace hinge_table
