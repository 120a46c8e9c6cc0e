#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Polar angle of a load from a seat's axis, rad, both in the axes of the body
/// that has the seat.
inline double load_direction(const SeatZone& zone,
                             const Eigen::Vector3d& load) {
  const Eigen::Vector3d axis(zone.axis()[0], zone.axis()[1], zone.axis()[2]);
  return std::atan2(axis.cross(load).norm(), axis.dot(load));
}

}  // namespace contact::detail
