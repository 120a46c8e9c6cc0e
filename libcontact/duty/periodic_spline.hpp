#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace contact {

/// Vectors through time, again and again: the cubic spline with two continuous
/// derivatives through values at uneven times of one period.
class PeriodicSpline {
 public:
  /// @param times   in s, ascending, at least 3; the first one comes again a
  ///                period later, behind the last
  /// @param period  s
  /// @param values  as many
  /// @throws Error if they are not so.
  PeriodicSpline(std::span<const double> times, double period,
                 std::span<const Eigen::Vector3d> values);

  /// At any time.
  Eigen::Vector3d value(double time) const;
  /// Its derivative, per s.
  Eigen::Vector3d slope(double time) const;

  /// Times as given.
  const std::vector<double>& times() const { return times_; }
  double period() const { return period_; }

 private:
  struct Place {
    std::size_t from;
    std::size_t to;
    double step;   // length of the interval, s
    double share;  // passed share of the interval
  };
  Place find(double time) const;

  std::vector<double> times_;
  double period_;
  std::vector<Eigen::Vector3d> values_;
  std::vector<Eigen::Vector3d> curvatures_;  // second derivatives
};

}  // namespace contact
