#pragma once

#include <functional>

#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/half_angle/opening_series.hpp"

namespace contact::detail {

/// An exact contact between its limit half-angle and 180 deg, where it closes
/// all round, as Chebyshev series: what HalfAngleTable is below the limit. By
/// psi = pi - theta0 it keeps
///
///     w = ln((x + c_0)/sin^2(psi/2)),
///
/// which is smooth down to psi = 0, and the other members of SignedContact.
/// The variable is ln(1 + psi/t), t the thickness of walls over the radius, or
/// sqrt(c_0) if that is less: bodies that hardly yield all round change their
/// law there.
class ClosingTable {
 public:
  using Solver = std::function<SignedContact(double opening)>;

  /// @param solver    at psi in (0, largest]; called here only
  /// @param largest   pi less the limit half-angle
  /// @param thickness t; infinite without walls
  /// @param mean      c_0 > 0
  /// @param first     c_1, may be NaN
  /// @param nodes     of the first series; where its last coefficients are not
  ///                  below 1e-8 a finer one follows
  ClosingTable(const Solver& solver, double largest, double thickness,
               double mean, double first, int nodes);

  double mean_compliance() const { return mean_; }
  double first_compliance() const { return first_; }
  double largest() const { return largest_; }

  /// The contact at psi in [0, largest()].
  SignedContact at(double opening) const;

  struct Root {
    double opening;  ///< psi
    double slope;    ///< dpsi/dln(x + c_0)
  };
  /// psi at x above -c_0, at most largest().
  Root opening(double inverse) const;

 private:
  double largest_;
  double mean_;
  double first_;
  OpeningSeries series_;  // the first is w
};

}  // namespace contact::detail
