#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "multibody/motion/motion_sample.hpp"

namespace multibody {

/// Size of a value at 0 with a known sign, regardless of rounding: its crossing
/// has been reported, or is about to be.
inline constexpr double just_crossed = std::numeric_limits<double>::min();

/// Whether a function crosses 0 in this direction between two values.
bool is_crossing(double before, double after, MotionEvent::Crossing way);

/// Zero of a function of time within a step, including pairs of crossings
/// within the step.
///
/// The function is evaluated at 7 Chebyshev points of the step, 5 of them
/// inside. They determine a polynomial of degree 6 in time exactly, and in
/// steps that meet a tolerance little else remains. The interval is halved
/// until the polynomial's Bernstein coefficients tell where it crosses 0 or
/// comes close to 0; there the function itself is evaluated.
class StepFunction {
 public:
  static constexpr int last = 6;
  static constexpr int middle = last / 2;
  using Values = std::array<double, last + 1>;
  /// Time of a point of the step from `begin` to `end`.
  static double point(int k, double begin, double end);
  /// Whether the function is further from 0 than these values differ.
  static bool is_far(std::span<const double> values);

  /// @param at  the function, in the step
  StepFunction(double begin, double end, std::function<double(double)> at)
      : begin_(begin), end_(end), at_(std::move(at)) {}

  double begin() const { return begin_; }
  double end() const { return end_; }
  double operator()(double time) const { return at_(time); }
  /// Time of a single crossing, to the rounding of time, on the side after it.
  /// (Values may be NaN in between.)
  double locate(double low, double low_value, double high,
                double high_value) const;
  double at_begin() const { return at_(begin_); }
  double at_end() const { return at_(end_); }
  /// As above, between the ends of the step.
  double locate(double begin_value, double end_value) const {
    return locate(begin_, begin_value, end_, end_value);
  }
  struct Crossed {
    double time;
    bool rises;
  };
  /// First crossing in this direction.
  /// @param values  at the points; estimates suffice
  /// @param before  its value before the step: if its sign differs from the
  ///                first value, it has crossed at once, unless just reported
  std::optional<Crossed> first_crossing(Values values, double before,
                                        MotionEvent::Crossing way) const;

 private:
  double begin_, end_;
  std::function<double(double)> at_;
};

}  // namespace multibody
