// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {

/// A user-defined pressure law: derive from it and return the shape.
/// Normalisation, peak and friction follow from shape().
///
/// Accuracy: relative error of normalisation, peak, S and all friction
/// coefficients at most 1e-9 for theta0 <= 120 deg
/// (friction/own_pressure_test.cpp), if the shape vanishes at the edge like a
/// power 1/2, 3/4, 1, 5/4, ... of the distance from it and is smooth inside;
/// slope() 1e-6. Other powers from 1/2 on cost digits, and so do kinks and tops
/// that are all but rectangular. One friction evaluation takes some 200 of
/// shape() and 100 of the exact method.
class ShapedPressure : public PressureLaw {
 public:
  std::string name() const override { return name_; }
  double pressure(double theta, double half_angle) const noexcept final;
  double slope(double theta, double half_angle) const noexcept final;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept final;
  double peak(double half_angle) const noexcept final;
  double force_ratio(double half_angle) const noexcept final;
  double largest_half_angle() const noexcept final { return largest_; }

 protected:
  /// @param largest_half_angle  rad, (0, 175 deg]: up to where shape() is good
  explicit ShapedPressure(JointKind kind, std::string name = "own",
                          double largest_half_angle = 175 * degree);

  /// The pressure in any unit, of a size that doubles can square; positive at
  /// the centre and 0 at the edge.
  /// @param theta       rad, [0, theta0]
  /// @param half_angle  theta0, rad, (0, largest_half_angle()]
  virtual double shape(double theta, double half_angle) const noexcept = 0;

 private:
  struct Resultants {
    double force, sum;
  };
  Resultants resultants(double half_angle) const noexcept;

  std::string name_;
  double largest_;
};

}  // namespace contact
