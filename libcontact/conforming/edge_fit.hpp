#pragma once

#include <Eigen/Core>

#include "libcontact/conforming/contact_pressure.hpp"

namespace contact::detail {

/// From the values of a pressure at points of phi to its ContactPressure, by
/// least squares in phi. The leading logarithm is given, since the equations
/// of the contact tell it:
///
///     p = slope x (1 + (4 A/(3 pi)) sin(theta0/2) x^2 ln x + ...),
///
/// with A as in kappa(x) = -A ln x of a ball's kernel, Dundurs' beta for a
/// pin. The next ones take what the sines of a higher order would have.
class EdgeFit {
 public:
  /// Sines that resolve half-angles up to 120 deg to 1e-9, those beyond and
  /// thick walls, and thin walls.
  static constexpr int usual_terms = 12;
  static constexpr int wide_terms = 32;
  static constexpr int thin_terms = ContactPressure::max_terms;
  static constexpr int max_points = 2 * thin_terms + 8;
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_points, 1>;

  /// Sines for the pressure of a solution with so many unknowns.
  static int terms_for(int unknowns) {
    return unknowns > wide_terms ? thin_terms : wide_terms;
  }

  /// The fit with so many terms, rounded up to one of these; made at its first
  /// call.
  static const EdgeFit& table(int terms);

  explicit EdgeFit(int terms);

  int points() const { return static_cast<int>(square.size()); }
  Eigen::VectorXd square;  ///< x^2 = sin^2 phi of the points
  Eigen::VectorXd cosine;  ///< cos phi

  /// b_0 of ContactPressure.
  /// @param slope        dp/dx at the edge
  /// @param coefficient  A or beta
  static double leading_logarithm(double slope, double coefficient,
                                  double half_angle);

  /// @param values  p at the points
  /// @param leading  b_0
  ContactPressure operator()(double half_angle, double force_ratio,
                             const Points& values, double leading) const;

 private:
  int terms_;
  Eigen::MatrixXd sines_;       // to a_k
  Eigen::VectorXd leading_;     // x^3 ln x at the points
  Eigen::MatrixXd logarithms_;  // x^5 ln x, x^7 ln x at the points
  Eigen::MatrixXd fit_;         // to b_1, b_2; empty if they are not needed
};

}  // namespace contact::detail
