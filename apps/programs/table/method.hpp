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

/// Points: half-angles (rad), sine and cosine of the slip axis angle.
struct Points {
  std::span<const double> half_angle;
  std::span<const double> axis_sin;
  std::span<const double> axis_cos;
};

/// Results at these points, for each of the quantities.
using Columns = std::vector<std::span<double>>;

/// Evaluates a method of the library at many points; returns the number of
/// points that missed the tolerance of an iteration.
using MethodFunction =
    std::function<std::size_t(const Points&, const Columns&)>;

/// A method, the name of its pressure law, and the law's largest half-angle.
struct Method {
  MethodFunction function;
  std::string pressure;
  double largest_half_angle;  ///< rad

  std::size_t operator()(const Points& points, const Columns& columns) const {
    return function(points, columns);
  }
};

/// The method with this name: exact, elliptic, quadrature (if
/// contact::reference is built), planar, viscous, cosine. Throws contact::Error
/// for other names, and if a method for the cosine pressure is asked for
/// another one.
/// @param tolerance  relative, of quadrature
/// @param pressure   of a ball; the method keeps it
Method find_method(const std::string& name, double tolerance,
                   const cli::NamedPressure& pressure);

}  // namespace hinge_table
