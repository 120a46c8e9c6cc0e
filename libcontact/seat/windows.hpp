#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/patch.hpp"

namespace contact::detail {

/// A contact on a seat with the grid that it was found on.
struct SeatSolution {
  std::shared_ptr<const SeatPatchSolver> solver;
  SeatPatch patch;
};

/// The grids of one seat: one over its whole zone, and for contacts that lie at
/// one rim and are much narrower than the zone finer ones about them, all made
/// when first asked for and kept. Any number of threads may ask.
class SeatWindows {
 public:
  SeatWindows(const LayeredPair& pair, const SeatZone& zone, int cells,
              int order, double clearance);

  /// The contact under a force, from the one that is there, if there is one.
  /// @param force  F_x >= 0, F_z, N
  /// @return whether it was found to full accuracy
  bool balance(Eigen::Vector2d force, SeatSolution& solution) const;

  /// Number of those that were made.
  std::size_t grids() const;

  const LayeredPair& pair() const { return pair_; }
  /// E rho/4, N/m: the unit of SeatPatch::force.
  double unit_force() const { return unit_force_; }

 private:
  std::shared_ptr<const SeatPatchSolver> solver(int end, int step) const;
  Eigen::Vector2d start(Eigen::Vector2d force) const;

  LayeredPair pair_;
  SeatZone zone_;
  int cells_;
  int order_;
  double clearance_;
  double unit_force_;
  mutable std::mutex making_;
  mutable std::unique_ptr<const SideFaceCompliance> side_face_;
  mutable std::map<std::pair<int, int>, std::shared_ptr<const SeatPatchSolver>>
      solvers_;
};

}  // namespace contact::detail
