#pragma once

#include <Eigen/Core>

#include "libcontact/seat/cells.hpp"
#include "libcontact/seat/compliance.hpp"

namespace contact::detail {

/// A pressure on a seat with its force and shift, in the plane of the load.
struct SeatPatch {
  SeatPatch() = default;
  explicit SeatPatch(const Eigen::Vector2d& at) : shift(at) {}

  /// p_i at the longitudes pi j/M, (i, j), in units of E/(4 rho) per metre of
  /// shift: a cosine polynomial in the longitude, symmetric about the plane.
  Eigen::MatrixXd pressure;
  /// 1 in contact, 0 outside.
  Eigen::ArrayXXd contact;
  Eigen::Vector2d shift = {0, 0};  ///< D_x, D_z, m
  Eigen::Vector2d force = {0, 0};  ///< F_x, F_z in units of E rho/4 times m
  double sum = 0;                  ///< Q in the same units
  bool converged = false;
};

/// The contact of a ball in a seat that ends, for a given shift D of its centre
/// from the concentric position:
///
///     u = D.r - eps, p > 0   or   u >= D.r - eps, p = 0      in the zone,
///
/// with the displacement u under p, as the mean over each cell at each
/// longitude. Conjugate gradients solve on the set of cells in contact, which
/// changes until no pressure is negative and no cell outside overlaps
/// (docs/internals/seat_methods.md).
class SeatPatchSolver {
 public:
  /// @param order      M: longitudes pi j/M
  /// @param clearance  eps, m
  /// @param side_face  see SeatCompliance
  SeatPatchSolver(const LayeredPair& pair, const SeatWindow& window, int cells,
                  int order, double clearance,
                  const SideFaceCompliance* side_face = nullptr);

  /// Contact at a shift, starting from the contact in `patch`.
  void solve(Eigen::Vector2d shift, SeatPatch& patch) const;

  /// Contact under a force, starting from the shift of the patch.
  /// @param force  F_x, F_z in the units of SeatPatch
  void balance(Eigen::Vector2d force, SeatPatch& patch) const;

  /// dF/dD of the set in contact: within 1e-3 to 5e-3, because its edge moves
  /// by whole cells.
  Eigen::Matrix2d tangent(const SeatPatch& patch) const;

  /// Largest D.r - eps over the cells, m; negative: no contact.
  double overlap(Eigen::Vector2d shift) const;

  const SeatCells& cells() const { return cells_; }
  int order() const { return order_; }
  double longitude(int j) const;
  /// Weight of a node in integrals over all longitudes, rad.
  double longitude_weight(int j) const;

 private:
  using Map = Eigen::MatrixXd;
  Map apply(const std::vector<Map>& by_order, const Map& of, int columns) const;
  Map gap_side(Eigen::Vector2d shift) const;
  void conjugate_gradients(const Map& right, const Eigen::ArrayXXd& contact,
                           double tolerance, Map& solution) const;

  SeatCells cells_;
  SeatCompliance compliance_;
  int order_;
  double clearance_;
  Eigen::RowVectorXd root_;  // root of the longitudes' weights over pi 2/M
  Map transform_;            // symmetric, orthogonal
  Map lever_x_, lever_z_, unit_;
};

}  // namespace contact::detail
