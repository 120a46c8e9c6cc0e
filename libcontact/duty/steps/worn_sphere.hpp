#pragma once

#include <Eigen/Core>

#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/seat/cells.hpp"
#include "libcontact/seat/compliance.hpp"

namespace contact::detail {

/// A ball in a seat on cells of latitude and longitude about a pole, all round
/// it, under a load of any direction and for shapes that wear has made; the
/// ball's twin of WornCircle, with the compliances of SeatContact:
///
///     gap = eps + h + u - D.r >= 0, p > 0 only where it is 0.
///
/// Springs that yield by themselves at each cell make it an implicit step of
/// wear. Solved by conjugate gradients under the constraint of the load on the
/// set of cells in contact, until none pulls and none overlaps.
class WornSphere {
 public:
  using Map = Eigen::MatrixXd;  ///< rows: latitudes, columns: longitudes

  /// @param pole   unit vector near the middle of the contacts
  /// @param reach  of the grid from there, rad, (0, pi]
  /// @param step   size of its cells about, rad
  WornSphere(const LayeredPair& pair, const Eigen::Vector3d& pole, double reach,
             double step = default_step);
  static constexpr double default_step = 4 * degree;
  /// How many cells there are.
  static std::size_t points(double reach, double step = default_step);

  int latitudes() const { return cells_.size(); }
  int longitudes() const { return 2 * order_; }
  /// The middle of a cell, unit vector.
  Eigen::Vector3d point(int latitude, int longitude) const;
  /// Area of a cell, m^2.
  double area(int latitude) const;
  /// Mean compliance of a cap of 45 deg that is pressed evenly, m/Pa.
  double compliance() const;

  struct Contact {
    Map pressure;                       ///< Pa
    Eigen::Vector3d shift = {0, 0, 0};  ///< D, m
    /// Half-angle of a cap with the contact's area, rad.
    double half_angle = 0;
    /// out_of_range: the contact reaches the grid's end, which cuts it.
    Status status = Status::not_converged;
  };
  /// @param load     R_n, N, towards the contact
  /// @param gap      eps + h of the cells, m
  /// @param springs  of the cells, m/Pa; none of an empty one
  /// @param last     a contact that is near, from whose cells it starts
  Contact press(const Eigen::Vector3d& load, const Map& gap,
                const Map& springs = {}, const Contact* last = nullptr) const;

 private:
  struct Problem;
  Map turned(const std::vector<Map>& by_order, const Map& of) const;
  int solve(const Problem& problem, double tolerance, Map& y,
            Eigen::Vector3d& shift) const;
  double cap(const Map& pressure, const Map& open) const;

  double radius_;
  double modulus_;  // E
  int order_;
  Eigen::Matrix3d axes_;  // axes of the grid
  SeatCells cells_;
  SeatCompliance compliance_;
  Map transform_;  // orthogonal: from longitudes to their harmonics
  std::vector<Map> lever_;
  Map unit_;
};

}  // namespace contact::detail
