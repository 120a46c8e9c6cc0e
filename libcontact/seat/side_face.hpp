#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"
#include "libcontact/seat/cells.hpp"

namespace contact::detail {

/// How much more the body of a seat yields that ends at its rims, with side
/// faces that are free, than the one of SeatCompliance, which goes on beyond
/// them. Order by order in longitude
///
///     dA_m = (A_m of the body that ends) - (A_m of the body that goes on)
///          = G^T (H_m + S_m^-1) ^-1 G,
///
/// G the displacement of the side faces of the body that ends under pressures
/// on the seat, H_m its compliance there, S_m the stiffness of what would go
/// on: a difference without cancellation, never negative at the orders that are
/// solved; those between are interpolated. From finite elements
/// of eight nodes on one mesh for both parts, with walls, liners and backing as
/// they are. Side faces are cones, SeatZone::side_angle() to the seat; they cut
/// the layers, and of a body without layers all of it. An elastic backing
/// behind layers goes on beside them, or ends as SeatEdge::housing has it.
///
/// Elements follow the rim down to a thousandth of the radius or a 15th of the
/// surface layer. Measured: docs/explanation/seats.md, "Free side faces".
class SideFaceCompliance {
 public:
  /// Of a mesh without a SideFaceMesh::refusal().
  /// @param coarser  elements at the rim, times
  SideFaceCompliance(const LayeredPair& pair, const SeatZone& zone, int order,
                     double coarser = 1);

  /// dA_0, dA_1, ..., dA_order on the cells of a window of the zone, in units
  /// of 4 rho/E.
  std::vector<Eigen::MatrixXd> on(const SeatCells& cells) const;

  /// A place on the seat and the force there, p dO.
  struct Point {
    double angle, longitude, force;
  };
  /// How much more the points of a pressure's rule are pressed in, in units of
  /// 4 rho/E. The pressure is alike on both sides of longitude 0; the points
  /// are those of one side, with the forces of both.
  Eigen::VectorXd under(const std::vector<Point>& points) const;

 private:
  using Node = std::pair<Eigen::Index, Eigen::Array3d>;
  Node node(double angle) const;
  Eigen::MatrixXd shares(const SeatCells& cells) const;
  void for_parts(int m,
                 const std::function<void(double, std::size_t)>& take) const;

  Eigen::ArrayXd nodes_;                 // polar angles on the seat
  std::vector<int> orders_;              // those that are solved
  std::vector<Eigen::MatrixXd> matrix_;  // by nodes
};

}  // namespace contact::detail
