#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "libcontact/seat/patch.hpp"

namespace contact::detail {

/// Pressures and edges of the contact of a patch on a seat, in the patch's unit
/// of pressure and in radians: pressures at points, the strength of the rims'
/// singularities, the ends of the contact.
class SeatReadout {
 public:
  SeatReadout(const SeatPatchSolver& solver, const SeatPatch& patch)
      : cells_(solver.cells()), solver_(solver), patch_(patch) {}

  /// Pressure at a node's longitude and any polar angle: g(v) times the
  /// parabola through the means of five cells, to 1e-3 away from rims. Never
  /// negative, infinite at a reached rim.
  double pressure(double v, int j) const;
  /// Pressure at any longitude, linear between its nodes.
  double pressure(double v, double longitude) const;
  /// Angle along a great circle from a polar angle at the longitude 0 across to
  /// the end of the contact, rad; 0 without contact.
  double half_width(double v) const;

  struct Peak {
    double pressure;
    double polar_angle;
    double longitude;  ///< 0 or pi
  };
  /// Largest pressure at a distance or more from every rim; it lies in the
  /// plane of the load.
  Peak peak(double rim_distance) const;
  /// Largest pressure between two polar angles at the longitude 0 or pi, j = 0
  /// or order(); 0 without contact there.
  Peak peak(double from, double to, int j) const;

  /// p |w x r| over the contact, r the unit vector from the ball's centre.
  struct Slip {
    double total;  ///< integral over the sphere
    /// Maximum at a distance or more from every rim; NaN if below the mean.
    double largest;
    Eigen::Vector3d place;  ///< r there
  };
  /// Sums over the nodes, and finds the maximum by parabolas at the best node.
  /// @param axis  w, unit vector in the plane's axes: x on the side of the
  ///              load, z the seat's axis
  Slip slip(const Eigen::Vector3d& axis, double rim_distance) const;

  struct Rim {
    /// Largest lim p sqrt(s) along the rim, s in rad; 0 if the rim is not
    /// reached. If the body ends there too, the mean of p in the last cell.
    double strength;
    double longitude;  ///< its place, 0 or pi
    double half_arc;   ///< along which the contact follows the rim, rad
  };
  Rim rim(int rim) const;

  /// Ends of the contact on one longitude; both NaN without contact. The
  /// contact may be open in between, because thin rings bend.
  struct Ends {
    double lower, upper;
  };
  Ends ends(int j) const;

  /// Share of each cell in contact at each longitude, (i, j).
  Eigen::MatrixXd covered() const;

 private:
  // Neighbouring cells in contact.
  struct Run {
    int first, last;
  };
  struct Best {
    double value, polar_angle;
  };
  // A cell of a node's meridian, which continues over the poles of the zone:
  // cells there have numbers below 0 or from size() on, and angles offset +
  // sign v.
  struct Cell {
    int i, j;
    double sign, offset;
  };
  double longitude(int k) const;
  Best best(const Eigen::Vector3d& axis, double from, double to, int k) const;
  std::vector<Run> runs(int j) const;
  std::optional<Cell> cell(int k, int j) const;
  bool touches(int k, int j) const;
  Run around(int k, int j) const;
  Eigen::Vector3d parabola(int k, int j) const;
  double pressure(const Eigen::Vector3d& parabola, int k, double v) const;
  double end(const Run& run, int j, int side) const;
  double rim_strength(int rim, int j) const;

  const SeatCells& cells_;
  const SeatPatchSolver& solver_;
  const SeatPatch& patch_;
};

}  // namespace contact::detail
