#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "multibody/motion/motion_sample.hpp"

namespace multibody {

/// Size of a value at 0 whose sign is known, whatever rounding says: of one
/// whose crossing has been reported, or is about to be.
inline constexpr double just_crossed = std::numeric_limits<double>::min();

/// Whether a function goes through 0 that way between two values.
bool is_crossing(double before, double after, MotionEvent::Crossing way);

/// Zero of a function of time within a step, including crossings that come back
/// before its end.
///
/// It is looked at in 7 Chebyshev points of the step, 5 of them inside: what
/// is a polynomial of degree 6 in time is known from them for certain, and
/// steps that meet a tolerance leave little else. That polynomial is halved
/// until its Bernstein coefficients tell where it crosses 0 or comes near it;
/// the function itself is asked there.
class StepFunction {
 public:
  static constexpr int last = 6;
  static constexpr int middle = last / 2;
  using Values = std::array<double, last + 1>;
  /// Time of a point of the step from `begin` to `end`.
  static double point(int k, double begin, double end);
  /// Whether it is further from 0 than these values are apart.
  static bool is_far(std::span<const double> values);

  /// @param at  the function, in the step
  StepFunction(double begin, double end, std::function<double(double)> at)
      : begin_(begin), end_(end), at_(std::move(at)) {}

  double begin() const { return begin_; }
  double end() const { return end_; }
  double operator()(double time) const { return at_(time); }
  /// Place of a single crossing, to the rounding of time: the side after it.
  /// (Values may be NaN in between.)
  double locate(double low, double low_value, double high,
                double high_value) const;
  double at_begin() const { return at_(begin_); }
  double at_end() const { return at_(end_); }
  /// The same between the ends.
  double locate(double begin_value, double end_value) const {
    return locate(begin_, begin_value, end_, end_value);
  }
  struct Crossed {
    double time;
    bool rises;
  };
  /// The first crossing that way.
  /// @param values  at the points; estimates will do
  /// @param before  its value before the step: if that has another sign than
  ///                the first one it has crossed at once, unless it has just
  ///                been reported
  std::optional<Crossed> first_crossing(Values values, double before,
                                        MotionEvent::Crossing way) const;

 private:
  double begin_, end_;
  std::function<double(double)> at_;
};

}  // namespace multibody
