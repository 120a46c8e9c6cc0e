#pragma once

#include <functional>

#include "libcontact/base/chebyshev_table.hpp"
#include "libcontact/conforming/force_point.hpp"
#include "libcontact/pair/joint_geometry.hpp"

namespace contact::detail {

/// Force law by the half-angle: Chebyshev series of four quantities that hardly
/// change with it, in u = ln(theta0). Lengths are in units of the clearance,
/// forces in units of ForceUnit.
class ForceSeries {
 public:
  using Solver = std::function<ForcePoint(double)>;

  /// @param limit   theta0*, or the solver's end
  /// @param solver  at theta0 in (0, limit); called here only
  ForceSeries(JointKind kind, double limit, const Solver& solver);

  struct Point {
    double half_angle;
    double penetration;  // delta/eps
    double force;        // eps/K_1 = x, inverted
    double slope;        // d force/d penetration
    double energy;
  };
  /// @param u  ln(theta0), [first(), last()]
  Point at(double u) const;
  /// u at which the penetration is this one.
  /// @param start  somewhere near it
  double at_penetration(double penetration, double start) const;

  double first() const { return first_; }
  double last() const { return last_; }

 private:
  // Columns of the series.
  enum { reciprocal, approach, stiffness, excess, depth };
  ChebyshevTable tabulated(JointKind kind, int count,
                           const Solver& solver) const;
  double variable(double u) const;  // [-1, 1]

  double power_;  // x ~ theta0^-power
  double limit_;
  double first_;
  double last_;
  // ln(x theta0^power/(limit - theta0)), ln((delta/K_1) theta0^(power-2)),
  // ln((K_1'/D') theta0^(2-power)), ln((S - 1)/theta0^2), and
  // ln(delta/eps) - 2 u + ln(limit - theta0), the second less the first.
  ChebyshevTable series_;
};

}  // namespace contact::detail
