#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"

namespace contact {

/// A pin that ends on its duty cycle, tilted in its hole or loaded off its
/// middle: FinitePin at the times of the cycle and at the Gauss points of its
/// integrals, all in carrier axes. The part of the reaction along the axis is
/// left out. Nothing wears here: p v is that of the unworn pin.
class PinCycle {
 public:
  /// How the pin lies at a time.
  struct Lie {
    /// Slope of the pin's axis in its hole, carrier axes.
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
    /// Place z of the reaction, m, for which the tilt is found.
    std::optional<double> place = {};
  };
  using Lies = std::function<Lie(const DutyCycle::State&, double time)>;
  /// A reaction that always acts there, m.
  static Lies loaded_at(double place);
  /// A tilt that turns with the reaction: in its plane, and across it. Without
  /// a reaction that plane is XOZ.
  static Lies tilted_with_load(const Eigen::Vector2d& tilt);
  /// Periodic splines through tilts, carrier axes, at times of the cycle.
  /// @throws Error if they are not as many, or fewer than 3
  static Lies tilted(const std::vector<double>& times, double period,
                     const std::vector<Eigen::Vector2d>& tilts);
  /// The same through places of the reaction, m.
  static Lies loaded(const std::vector<double>& times, double period,
                     const std::vector<double>& places);

  struct Instant {
    double time;    ///< s
    double weight;  ///< in integrals over the period, s
    DutyCycle::State state;
    FinitePinSolution solution;
    double slip_speed;  ///< rho |Dw|, m/s

    /// The largest p v along the pin, W/m^2; at solution.contact.peak_place.
    double largest_pv() const {
      return solution.contact.peak_pressure * slip_speed;
    }
  };

  /// @throws Error as FinitePin, and if at some time it has no solution
  PinCycle(DutyCycle cycle, const JointSpec& joint, Lies lies);

  const DutyCycle& cycle() const { return cycle_; }
  const FinitePin& pin() const { return pin_; }
  /// Instants at the times of the cycle; their weight is 0.
  const std::vector<Instant>& rows() const { return rows_; }
  const std::vector<Instant>& gauss_points() const { return gauss_points_; }
  Instant at(double time) const noexcept;

  using Quantity = std::function<double(const Instant&)>;
  /// Integral over one period, within 1e-8 for smooth cycles
  /// (duty/pin_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// As JointCycle::largest().
  Instant largest(const Quantity& quantity) const;
  Instant largest_pv() const;
  Instant largest_peak() const;
  Instant largest_half_angle() const;
  LargestContact largest_contact() const;

  /// p v at one place along the pin through the cycle.
  struct Along {
    double largest_pv;     ///< among rows and Gauss points, W/m^2
    double time;           ///< when, s; NaN where nothing slides under load
    double mean_pv;        ///< mean over the time of the slice's largest, W/m^2
    double pv_per_length;  ///< integral of p v over arc and time, J/m
  };
  /// @param z  m, from the middle
  Along along(double z) const;
  /// Integrals of p v over the time, Pa m, whose multiples by k are depths of
  /// wear, at `count` places round a body, in its own axes: -pi, ... in even
  /// steps about z from x.
  std::vector<double> pv_integrals(JointBody body, double z, int count) const;

 private:
  DutyCycle cycle_;
  FinitePin pin_;
  Lies lies_;
  std::vector<Instant> rows_;
  std::vector<Instant> gauss_points_;
};

}  // namespace contact
