// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"

namespace contact {

/// p v along a pin on its duty cycle: places z are m from its middle. Nothing
/// wears here: p v belongs to the unworn pin.
class AlongPin {
 public:
  /// @param pin  the spec of the cycle's joint
  /// @throws Error as FinitePin
  AlongPin(const JointCycle& cycle, const JointSpec& pin);

  /// p v at one place through the cycle.
  struct Place {
    double largest_pv;     ///< among rows and Gauss points, W/m^2
    double time;           ///< when, s; NaN where nothing slides under load
    double mean_pv;        ///< mean over the time of the slice's largest, W/m^2
    double pv_per_length;  ///< integral of p v over arc and time, J/m
  };
  Place at(double z) const;
  /// Integrals of p v over the time, Pa m, whose multiples by k are depths of
  /// wear, at `count` places round a body, in its own axes: -pi, ... in even
  /// steps about z from x.
  std::vector<double> pv_integrals(JointBody body, double z, int count) const;

 private:
  struct Slid {
    double time;
    double weight;      // in integrals over the period, s
    double slip_speed;  // m/s
    double turn;        // turn of the body about Z, rad
    FinitePinState contact;
  };

  FinitePin pin_;
  double period_;
  std::vector<Slid> slid_;  // rows and Gauss points that slide under load
};

}  // namespace contact
