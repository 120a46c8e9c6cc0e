#pragma once

#include <array>
#include <cmath>

#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact::detail {

/// A pressure law at one half-angle by its PressureExpansion: pressure and
/// slope at once, several times as fast as by the law.
class ExpandedPressure {
 public:
  struct Value {
    double pressure;  ///< PressureLaw::pressure()
    double slope;     ///< PressureLaw::slope(); infinite at the edge, or NaN
  };

  ExpandedPressure(const PressureLaw& law, double half_angle) noexcept
      : expansion_(expansion_of(law, half_angle)),
        half_angle_(half_angle),
        cosine_peak_(
            expansion_.cosine_share == 0
                ? 0
                : expansion_.cosine_share *
                      CosinePressure(law.joint_kind()).peak(half_angle)),
        sine_(std::sin(half_angle / 2)) {}

  /// The law has no expansion, and this no values.
  bool is_empty() const noexcept { return expansion_.is_empty(); }

  /// @param theta  [0, theta0], rad
  Value at(double theta) const noexcept {
    const double v = expansion_.edge_constant;
    // X^2 and x^2 of PressureExpansion, and their slopes: minus d/dtheta.
    const double wide = std::sin((half_angle_ + theta) / 2) / sine_ *
                        (std::sin((half_angle_ - theta) / 2) / sine_);
    const double wide_slope = std::sin(theta) / sine_ / (2 * sine_);
    Value sum{expansion_.edge_pressure + cosine_peak_ * wide,
              cosine_peak_ * wide_slope};
    if (expansion_.size == 0 && !expansion_.has_logarithm()) return sum;
    const double turn = v + std::cos(theta);
    const double ratio = (1 + v) / turn;
    const double square = wide * ratio;
    const double square_slope =
        wide_slope * ratio * (v + 1 - 2 * sine_ * sine_) / turn;
    const auto [series, change] = series_at(square);
    const double x = std::sqrt(square);
    sum.pressure += x * series;
    sum.slope += (series / (2 * x) + x * change) * square_slope;
    if (!expansion_.has_logarithm()) return sum;
    const auto& b = expansion_.logarithmic;
    const double cube = square * x;
    const double powers = b[0] + square * (b[1] + square * b[2]);
    // d(x^3 sum b_k x^(2k))/d(x^2)
    const double growth =
        x / 2 * (3 * b[0] + square * (5 * b[1] + square * 7 * b[2]));
    const double logarithm = std::log(wide) / 2;
    sum.pressure += cube * powers * logarithm;
    sum.slope +=
        growth * logarithm * square_slope + powers * x * ratio * wide_slope / 2;
    return sum;
  }

 private:
  struct Series {
    double value;   // sum c_k B_k
    double change;  // its derivative by x^2
  };
  // Four series side by side, by Horner.
  Series series_at(double square) const {
    const double y = 2 * square - 1;
    const double y2 = y * y;
    const double z = y2 * y2 - y2;
    std::array<double, 4> value{};
    std::array<double, 4> change{};
    for (int k = (expansion_.size + 3) / 4 * 4 - 4; k >= 0; k -= 4) {
      for (int i = 0; i < 4; ++i) {
        change[i] = change[i] * z + value[i];
        value[i] = value[i] * z + expansion_.coefficient[k + i];
      }
    }
    const auto sum = [&](const std::array<double, 4>& p) {
      return (p[3] * y + p[2]) * y2 + (p[1] * y + p[0]);
    };
    // dz/dy = 4 y^3 - 2 y, dy = 2 d(x^2)
    return {sum(value), 4 * (y * (2 * y2 - 1) * sum(change) +
                             y * (value[3] * y + value[2])) +
                            2 * (value[3] * y2 + value[1])};
  }

  PressureExpansion expansion_;
  double half_angle_;
  double cosine_peak_;
  double sine_;  // sin(theta0/2)
};

}  // namespace contact::detail
