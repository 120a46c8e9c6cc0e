#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Mesh of the body of a seat in the half-plane through its axis, radius 1:
/// columns of elements from pole to pole, rows from the seat outwards. Lines
/// between columns follow the side faces where these cut; removed elements are
/// marked.
class SideFaceMesh {
 public:
  /// @param coarser  factor on the size of elements at the rim
  SideFaceMesh(const LayeredPair& pair, const SeatZone& zone,
               double coarser = 1);

  /// Reason why the elements cannot be solved, as a sentence; "" if they can.
  /// Reasons: a held backing, side faces that meet the axis or each other in
  /// the layers, a housing without an elastic backing.
  std::string refusal() const;

  int columns() const { return static_cast<int>(angle_.size()) - 1; }
  int rows() const { return static_cast<int>(radius_.size()) - 1; }
  /// Whether the side face cuts off an element.
  bool is_cut_off(int column, int row) const;
  const Material& material(int row) const { return material_[row]; }

  /// x and z of a node. Nodes have coordinates (i, j), twice the coordinates of
  /// corners; no node has both odd.
  Eigen::Vector2d node(int i, int j) const;
  /// Polar angle of a node on the seat.
  double seat_angle(int i) const;
  /// First and last column of the remaining seat.
  int first() const { return first_; }
  int last() const { return last_; }
  /// Nodes of the far end of the backing, which does not move.
  bool is_held(int j) const { return j == 2 * rows(); }

 private:
  double turn(int rim, double radius) const;
  void set_radii(const LayeredBody& body, double radius, double finest);
  void set_angles(const SeatZone& zone, double finest);

  std::vector<double> angle_;   // lines at the seat
  std::vector<double> radius_;  // ends of the rows
  std::vector<Material> material_;
  bool is_held_ = false;
  bool has_housing_ = false;
  int cut_rows_ = 0;       // rows that the side faces cut at their angle
  bool cuts_all_ = false;  // and the rows behind them radially
  int first_ = 0, last_ = 0;
  double from_, to_;
  std::array<double, 2> side_;  // angle of the side face; NaN without a rim
};

}  // namespace contact::detail
