#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "libcontact/identify/identify.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

/// The moments of a joint as functions of its unknown parameters.
namespace contact::detail {

/// f0, A over a unit(), and the logarithm of the clearance, or, of joints
/// without clearance or with interference, the clearance over a length; drag
/// and offset over a moment_unit(): numbers of one size, in which the moments
/// are nearly linear.
using Point = Eigen::Vector<double, 5>;

/// Moments of some states, all numbers of the first one, then of the second.
/// For one thread.
class MomentModel {
 public:
  /// @param joint  with dry friction
  MomentModel(JointContact joint, std::span<const MeasuredMoment> states);

  Eigen::Index size() const { return size_; }
  /// Unit of A, Pa: a nominal pressure.
  double unit() const { return unit_; }
  /// Unit of drag and offset, N m: rho and a mean load.
  double moment_unit() const { return moment_unit_; }
  /// Without drag and offset.
  Point point(double coefficient, double adhesion, double clearance) const;
  JointContact joint_at(const Point& point) const;
  /// The clearance of a point, m, and its change with the point's number.
  double clearance(const Point& point) const;
  double clearance_slope(const Point& point) const;
  /// Smallest and largest value of a number of the point that means something;
  /// far beyond any fit that does.
  std::pair<double, double> range(int number) const;

  /// Below f0 = 0 or A = 0 they go on smoothly, as 2 T(0) - T(-x). What has no
  /// solution, or no meaning, is NaN.
  Eigen::VectorXd moments(const Point& point) const;
  /// Their slopes in some numbers of the point, a column each: relative error
  /// some 1e-9 (identify/identify_test.cpp).
  Eigen::MatrixXd slopes(const Point& point,
                         const std::vector<int>& numbers) const;

 private:
  bool is_usable(const Point& point) const;
  Eigen::VectorXd friction(const Point& point) const;
  Eigen::MatrixXd friction_slopes(const Point& point,
                                  const std::vector<int>& numbers) const;
  Eigen::VectorXd solved(const Point& point) const;
  Eigen::MatrixXd solved_slopes(const Point& point,
                                const std::vector<int>& numbers) const;
  Eigen::Vector3d slope_at(const std::vector<JointContact>& moved, int number,
                           std::size_t state,
                           const Eigen::Vector3d& by_tangent) const;

  JointContact joint_;
  std::span<const MeasuredMoment> states_;
  Eigen::Index size_ = 0;
  double unit_ = 1;
  double moment_unit_ = 1;
  Eigen::MatrixX2d beside_;  ///< moments of unit drag and offset
  double length_ = 0;        ///< scale of the clearance; 0: its logarithm
  /// Last solution of each state, from which the next one starts: half the
  /// time.
  mutable std::vector<JointSolution> last_;
};

}  // namespace contact::detail
