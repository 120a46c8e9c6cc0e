#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace contact::detail {

/// The harmonics of a pin's unknowns at one half-angle,
///
///     G_n(k) = ∫ sqrt(1 - s^2) U_2k cos(nt)/(1 + b^2 s^2) ds
///            = (1/(2b)) ∫ sin((2k+1) phi) cos(nt) dt,
///
/// tan(t/2) = b s, s = cos phi, b = tan(theta0/2), for thousands of n. In t =
/// theta0 cos psi the sines of psi have Bessel functions for harmonics, and the
/// sines of phi are short sums of them: G_n = T^T g_n/(2b),
///
///     sin((2k+1) phi) = sum_j T_jk sin((2j+1) psi),
///     g_nj = (-1)^j pi (2j+1) J_{2j+1}(n theta0)/n.
class PinWallModes {
 public:
  /// @param half_angle  theta0, rad
  /// @param unknowns    k < unknowns
  PinWallModes(double half_angle, int unknowns);

  /// Calls use(i, g) with g_n, n = order[i], as a matrix of rows i, i + 1, ...,
  /// block by block.
  /// @param order  increasing
  using Block = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  void visit(std::span<const double> order,
             const std::function<void(int, const Block&)>& use) const;
  /// The same with Y for J, n half_angle above every order: see smooth_from().
  void visit_second_kind(
      std::span<const double> order,
      const std::function<void(int, const Block&)>& use) const;
  /// The least n half_angle from which J_i J_k + Y_i Y_k is smooth in log n.
  double smooth_from() const {
    return 3.0 * static_cast<double>(transformation_.rows());
  }

  const Eigen::MatrixXd& transformation() const { return transformation_; }

 private:
  double half_angle_;
  Eigen::MatrixXd transformation_;  // T
};

/// Some n with which a sum over n = 2, 3, ... of c_n a_n b_n is found, the a_n
/// and b_n being harmonics of functions on [-theta0, theta0], c_n smooth in n.
/// Such a product contains frequencies up to 2 theta0 in n, so that every
/// stride below pi/theta0 gives the same sum, to 1e-15; the first n are taken
/// one by one, the others fade in.
struct HarmonicSamples {
  /// @param end  of the sum
  HarmonicSamples(double half_angle, int end);
  std::vector<double> n;
  std::vector<double> weight;
};

/// The same sum with fewer n for thin walls: from about `smooth_from`/theta0 on
/// a product J_i J_k of harmonics is replaced by (J_i J_k + Y_i Y_k)/2. What
/// that leaves out swings with 2 theta0 and fades away; what it keeps is smooth
/// in log n, so that the stride grows with n.
struct GradedSamples {
  GradedSamples(double half_angle, int end, double smooth_from);
  HarmonicSamples swinging;
  std::vector<double> n;  ///< harmonics of the rest; none if `end` comes before
  std::vector<double> weight;
};

}  // namespace contact::detail
