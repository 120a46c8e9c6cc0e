#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/duty/joint_cycle.hpp"

namespace contact::detail {

/// Path of the sliding contact over a seat or hole in a cycle, in the axes of
/// the body that has it.
class SeatPath {
 public:
  explicit SeatPath(const JointCycle& cycle);

  struct Place {
    Eigen::Vector3d load;  ///< R_n, N, towards the contact
    Eigen::Vector3d axis;  ///< Dw/|Dw|
  };
  static Place place(const JointCycle& cycle, const JointCycle::Instant& at);

  /// rho integral of |Dw| dt over the cycle, m.
  double distance() const { return ends_.empty() ? 0 : ends_.back(); }
  /// Mean direction of the places, weighted by their distance; a unit vector.
  Eigen::Vector3d middle() const;
  /// The largest angle from there to a place, rad.
  double reach(const Eigen::Vector3d& middle) const;
  /// Whether the load always points to the same place, however large it is.
  bool keeps_direction() const { return keeps_direction_; }
  /// Places of the same distance each, in the order of the cycle; one if they
  /// stand still. Every round has others: what `count` leaves out
  /// comes in the next ones.
  std::vector<Place> places(int count, int round) const;

 private:
  std::vector<Place> places_;
  bool stands_still_ = true;
  bool keeps_direction_ = true;
  std::vector<double> ends_;  // running sums of their distances
};

}  // namespace contact::detail
