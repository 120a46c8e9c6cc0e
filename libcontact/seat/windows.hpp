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

/// A contact on a seat with its grid.
struct SeatSolution {
  std::shared_ptr<const SeatPatchSolver> solver;
  SeatPatch patch;
};

/// Grids of one seat: one over its whole zone, and finer grids about contacts
/// at one rim that are much narrower than the zone. Grids are built on first
/// use and kept. Any number of threads may share the object.
class SeatWindows {
 public:
  SeatWindows(const LayeredPair& pair, const SeatZone& zone, int cells,
              int order, double clearance);

  /// Contact under a force, starting from `solution`, if any.
  /// @param force  F_x >= 0, F_z, N
  /// @return whether it converged to full accuracy
  bool balance(Eigen::Vector2d force, SeatSolution& solution) const;

  /// Number of grids built so far.
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
