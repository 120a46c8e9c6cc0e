#pragma once

#include <memory>

#include "libcontact/duty/steps/seat_path.hpp"
#include "libcontact/duty/wear_in.hpp"

namespace contact::detail {

/// A joint whose seat or hole wears at points, as steps need it.
class SteppedJoint {
 public:
  virtual ~SteppedJoint() = default;

  /// Places of a cycle that are worn in a block.
  virtual int places() const = 0;
  /// Number of even times among which largest values are sought.
  virtual int looks() const = 0;
  /// Length of the next block, distance times k, m/Pa.
  /// @param moves  whether the load does
  virtual double next_step(bool moves) const = 0;
  /// Wears under a load at one place.
  /// @param path  distance times k, m/Pa
  /// @param many  whether it is one of many places, for which one step serves
  virtual Status wear(const SeatPath::Place& place, double seat, double inner,
                      bool many) = 0;

  /// State of the contact at one place.
  struct Look {
    Status status = Status::ok;
    double half_angle = 0;
    double peak_pressure = 0;
    double peak_slip_pressure = 0;  ///< largest p w, w the slip over rho |Dw|
    /// Integral of p w over the contact beyond R_n, N.
    double beyond = 0;
    double area = 0;  ///< integral of w over rho^2, of a pin 2 theta0 l, m
    double tilt = 1;  ///< |M_t| over its part along Dw
  };
  /// @param force  R_n, N
  virtual Look look(const SeatPath::Place& place) = 0;

  virtual double volume() const = 0;     ///< m^3
  virtual double depth() const = 0;      ///< deepest, m
  virtual double clearance() const = 0;  ///< mean, m; NaN of a ball
  /// Depth about the mean per path and force, m/(m/Pa N).
  virtual double mean_pressure_of_force() const = 0;
  virtual WornSeat worn() const = 0;
};

std::unique_ptr<SteppedJoint> stepped_pin(const JointContact& contact,
                                          const WornSeat& before);
std::unique_ptr<SteppedJoint> stepped_ball(const JointContact& contact,
                                           const SeatPath& path,
                                           const WornSeat& before);

/// Elastic bodies of a joint: its walls, or its pair without end.
LayeredPair bodies_of(const JointContact& contact);

}  // namespace contact::detail
