// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/joint/placement.hpp"

namespace contact {

/// How a pin lies in its hole at a time of its cycle, carrier axes.
using Lies = std::function<Placement(const DutyCycle::State&, double time)>;

/// A reaction that always acts there, m from the middle of the pin.
Lies loaded_at(double place);
/// A slope that turns with the reaction: in its plane, and across it. Without a
/// reaction that plane is XOZ.
Lies tilted_with_load(const Eigen::Vector2d& tilt);
/// Periodic splines through slopes at times of the cycle.
/// @throws Error if they are not as many, or fewer than 3
Lies tilted_at(const std::vector<double>& times, double period,
               const std::vector<Eigen::Vector2d>& tilts);
/// The same through places of the reaction, m.
Lies loaded_at(const std::vector<double>& times, double period,
               const std::vector<double>& places);

}  // namespace contact
