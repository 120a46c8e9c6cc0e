#include "libcontact/seat/windows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

// Place of a window: at which end of the zone it lies, and how many times it is
// 2^(1/2) narrower.
struct Place {
  int end, step;
};

// A window has a quarter of its width to spare beyond the contact.
Place narrowest(const SeatSolution& of) {
  const SeatCells& cells = of.solver->cells();
  const auto in_contact = (of.patch.contact.rowwise().sum() > 0).eval();
  const bool lower = in_contact(0) && cells.window.rim[0];
  const bool upper = in_contact(cells.size() - 1) && cells.window.rim[1];
  if (lower == upper) return {0, 0};
  double wide = 0;
  for (int i = 0; i < cells.size(); ++i) {
    if (!in_contact(i)) continue;
    wide = std::max(wide, lower ? cells.bound(i + 1) - cells.window.from
                                : cells.window.to - cells.bound(i));
  }
  constexpr double spare = 4.0 / 3;
  const double share = spare * wide / cells.window.width();
  // With the last window the smallest zone would have cells of 1e-4 rad.
  return {lower ? 0 : 1,
          std::clamp(static_cast<int>(-2 * std::log2(share)), 0, 16)};
}

bool reaches_artificial_end(const SeatSolution& of) {
  const SeatCells& cells = of.solver->cells();
  const auto& contact = of.patch.contact;
  return (!cells.window.rim[0] && cells.window.from > 0 &&
          (contact.row(0) > 0).any()) ||
         (!cells.window.rim[1] && cells.window.to < std::numbers::pi &&
          (contact.row(cells.size() - 1) > 0).any());
}

}  // namespace

SeatWindows::SeatWindows(const LayeredPair& pair, const SeatZone& zone,
                         int cells, int order, double clearance)
    : pair_(pair),
      zone_(zone),
      cells_(cells),
      order_(order),
      clearance_(clearance),
      unit_force_(pair.surfaces().effective_modulus() * pair.radius() / 4) {}

std::size_t SeatWindows::grids() const {
  const std::lock_guard lock(making_);
  return solvers_.size();
}

std::shared_ptr<const SeatPatchSolver> SeatWindows::solver(int end,
                                                           int step) const {
  if (step == 0) end = 0;
  const std::lock_guard lock(making_);
  auto& one = solvers_[{end, step}];
  if (!one) {
    SeatWindow window(zone_);
    if (window.is_free && !side_face_) {
      side_face_ =
          std::make_unique<const SideFaceCompliance>(pair_, zone_, order_);
    }
    const double width = zone_.width() * std::exp2(-step / 2.0);
    if (step > 0 && end == 0) window.to = window.from + width;
    if (step > 0 && end == 1) window.from = window.to - width;
    if (step > 0) window.rim[1 - end] = false;
    one = std::make_shared<const SeatPatchSolver>(pair_, window, cells_, order_,
                                                  clearance_, side_face_.get());
  }
  return one;
}

// Deep enough to touch where the seat is nearest to the force: by an overlap of
// the size that the force makes.
Eigen::Vector2d SeatWindows::start(Eigen::Vector2d force) const {
  const double direction = std::atan2(force.x(), force.y());
  const double deep =
      std::max(0.3 * std::abs(clearance_), force.norm() / (4 * unit_force_));
  const double slope = std::cos(direction - zone_.nearest(direction));
  return (std::max(clearance_, 0.0) + deep) / slope * force.normalized();
}

bool SeatWindows::balance(Eigen::Vector2d force, SeatSolution& to) const {
  const Eigen::Vector2d goal = force / unit_force_;
  const auto whole = solver(0, 0);
  if (to.solver && to.solver != whole) {
    // The window of another state may be too narrow for this one, or too wide.
    to.solver->balance(goal, to.patch);
    if (to.patch.converged && !reaches_artificial_end(to) &&
        narrowest(to).step < 2) {
      return true;
    }
    to.solver = nullptr;
  }
  if (!to.solver) to = {whole, SeatPatch(start(force))};
  to.solver->balance(goal, to.patch);
  if (!to.patch.converged) return false;
  const Place place = narrowest(to);
  for (int step = place.step; step > 0; --step) {
    SeatSolution finer{solver(place.end, step), SeatPatch(to.patch.shift)};
    finer.solver->balance(goal, finer.patch);
    if (!finer.patch.converged || reaches_artificial_end(finer)) continue;
    to = std::move(finer);
    return true;
  }
  return true;
}

}  // namespace contact::detail
