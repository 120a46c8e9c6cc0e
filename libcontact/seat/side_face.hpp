#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/cells.hpp"

namespace contact::detail {

/// Additional compliance of a seat whose body ends at its rims, with free side
/// faces, over SeatCompliance, whose body extends beyond them. For each order m
/// in longitude
///
///     dA_m = (A_m of the truncated body) - (A_m of the continued body)
///          = G^T (H_m + S_m^-1) ^-1 G,
///
/// with the displacement G of the side faces of the truncated body under
/// pressures on the seat, its compliance H_m there, and the stiffness S_m of
/// the removed part. The difference has no cancellation and is never negative
/// at the solved orders; the others are interpolated. Eight-node finite
/// elements on one mesh serve both parts, with walls, liners and backing. Side
/// faces are cones at SeatZone::side_angle() to the seat; they cut all layers,
/// or the whole body if it has no layers. An elastic backing behind layers
/// continues beside them, or ends according to SeatEdge::housing.
///
/// Elements follow the rim down to a thousandth of the radius or a 15th of the
/// surface layer. Measured errors: docs/explanation/side_faces.md.
class SideFaceCompliance {
 public:
  /// Requires a mesh without a SideFaceMesh::refusal().
  /// @param coarser  factor on the size of elements at the rim
  SideFaceCompliance(const LayeredPair& pair, const SeatZone& zone, int order,
                     double coarser = 1);

  /// dA_0, dA_1, ..., dA_order on the cells of a window of the zone, in units
  /// of 4 rho/E.
  std::vector<Eigen::MatrixXd> on(const SeatCells& cells) const;

  /// A place on the seat and the force there, p dO.
  struct Point {
    double angle, longitude, force;
  };
  /// Additional displacement at the points of a pressure's rule, in units of 4
  /// rho/E. The pressure is symmetric about longitude 0; the points are on one
  /// side and have the forces of both.
  Eigen::VectorXd under(const std::vector<Point>& points) const;

 private:
  using Node = std::pair<Eigen::Index, Eigen::Array3d>;
  Node node(double angle) const;
  Eigen::MatrixXd shares(const SeatCells& cells) const;
  void for_parts(int m,
                 const std::function<void(double, std::size_t)>& take) const;

  Eigen::ArrayXd nodes_;                 // polar angles on the seat
  std::vector<int> orders_;              // solved orders
  std::vector<Eigen::MatrixXd> matrix_;  // by nodes
};

}  // namespace contact::detail
