#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/seat_zone.hpp"

namespace contact::detail {

/// Mesh of the body of a seat in the half-plane through its axis, radius 1:
/// columns of elements from pole to pole, rows from the seat outwards. Lines
/// between columns follow the side faces where these cut; what is cut off is
/// marked.
class SideFaceMesh {
 public:
  /// @param coarser  elements at the rim, times
  SideFaceMesh(const LayeredPair& pair, const SeatZone& zone,
               double coarser = 1);

  /// Why its elements cannot be solved, a sentence; "" if they can: a backing
  /// that is held, side faces that meet the axis or each other in the layers, a
  /// housing that there is none of.
  std::string refusal() const;

  int columns() const { return static_cast<int>(angle_.size()) - 1; }
  int rows() const { return static_cast<int>(radius_.size()) - 1; }
  /// Of an element: whether the side face cuts it off.
  bool is_cut_off(int column, int row) const;
  const Material& material(int row) const { return material_[row]; }

  /// Nodes have coordinates (i, j), twice those of the corners; both odd is
  /// none. x and z of one:
  Eigen::Vector2d node(int i, int j) const;
  /// Polar angle of a node on the seat.
  double seat_angle(int i) const;
  /// First and last column of the seat that is left.
  int first() const { return first_; }
  int last() const { return last_; }
  /// Of the far end of the backing, which does not move.
  bool is_held(int j) const { return j == 2 * rows(); }

 private:
  double turn(int rim, double radius) const;
  void set_radii(const LayeredBody& body, double radius, double finest);
  void set_angles(const SeatZone& zone, double finest);

  std::vector<double> angle_;   // of the lines at the seat
  std::vector<double> radius_;  // of the rows' ends
  std::vector<Material> material_;
  bool is_held_ = false;
  bool has_housing_ = false;
  int cut_rows_ = 0;       // that the side faces cut at their angle
  bool cuts_all_ = false;  // and what is behind them straight on
  int first_ = 0, last_ = 0;
  double from_, to_;
  std::array<double, 2> side_;  // angle of the side face; NaN without a rim
};

}  // namespace contact::detail
