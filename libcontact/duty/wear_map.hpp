// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libcontact/duty/joint_cycle.hpp"

namespace contact {

/// Wear of one body of a joint on a cycle, by Archard's law with the geometry
/// of the unworn joint: the depth is k times the integral of p |v| over the
/// time.
///
/// Points are unit vectors from the joint's centre, in the body's own axes; of
/// a pin normal to Z.
class WearMap {
 public:
  /// At rims (JointCycle::is_at_rims()) nearer to one than 0.02 radii the
  /// pressure is that at this distance: what a rim wears beyond is not known.
  /// @throws Error if the half-angle of a joint with a clearance comes above 90
  ///         deg in the cycle: a ball that sinks into its worn seat leaves the
  ///         seat's rim there; if a row leaves its seat; and of a pin by
  ///         slices, which AlongPin has.
  WearMap(const JointCycle& cycle, JointBody body);

  struct Wear {
    double pv;  ///< integral of p |v| over one period, Pa m
    /// Share of the friction work across the principal direction of slip: 0
    /// along one line, 1/2 without a direction; NaN where there is no wear.
    double cross_shear;
  };
  /// Wear at a point, within 1e-5 of the largest p v of a cycle of 100 times
  /// (duty/joint_cycle_test.cpp).
  Wear at(const Eigen::Vector3d& point) const {
    return at(std::span(&point, 1))[0];
  }
  /// Wear at many points at once: a long cycle at rims solves its contacts
  /// again in each call.
  std::vector<Wear> at(std::span<const Eigen::Vector3d> points) const;

  /// N points, each of the same area: Fibonacci's sphere, or a circle.
  std::vector<Eigen::Vector3d> grid(int count) const;
  /// The area of one of them, m^2.
  double cell_area(int count) const;
  /// The sum over a grid against the integral of p |v| over time and contact,
  /// minus 1: at most 2/N of a hip's cycle (duty/joint_cycle_test.cpp).
  double volume_defect(const std::vector<Wear>& wear) const;

  struct Deepest {
    Eigen::Vector3d point;
    Wear wear;
  };
  /// The largest of a grid, improved between its neighbours; to 1e-5
  /// (duty/joint_cycle_test.cpp). With more rows at rims than
  /// JointCycle::most_grids it is the largest of the grid.
  Deepest deepest(const std::vector<Eigen::Vector3d>& points,
                  const std::vector<Wear>& wear) const;

  /// Note on wear that is implausible for a bearing.
  /// @param coefficient  k, m^2/N
  /// @return a sentence if k is not 0 and outside 1e-10 to 1e-3 mm^3/(N m); ""
  ///         otherwise. Of dry liners 7e-8 to 5.5e-6 are published
  ///         (docs/tutorials/bearing_design.md).
  static std::string coefficient_note(double coefficient);
  /// @param depth  of the wear, m
  /// @return a sentence if it is above a tenth of the radius, where seat and
  ///         ball or hole and pin no longer fit; "" otherwise
  static std::string depth_note(double depth, const JointGeometry& geometry);

 private:
  struct Instant;
  struct AtRim;

  JointGeometry geometry_;
  double total_;  // J
  std::shared_ptr<const std::vector<Instant>> instants_;
  // Joint and rows of a cycle at rims.
  Joint joint_;
  std::shared_ptr<const std::vector<AtRim>> at_rims_;
};

}  // namespace contact
