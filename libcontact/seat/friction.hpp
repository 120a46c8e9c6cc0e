#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

#include "libcontact/seat/windows.hpp"

namespace contact::detail {

/// Integrals over a contact for one slip axis w; e = w x r/|w x r| is the
/// direction of slip at the unit vector r.
struct SeatSlip {
  Eigen::Vector3d force;   ///< f = ∫ e dm
  Eigen::Vector3d moment;  ///< m = ∫ r x e dm
};

/// The harmonics N_nm(cos v) cos(m phi), n < degrees, for functions symmetric
/// about the plane of the load. Their coefficients lie in blocks of `lanes`
/// orders, which are computed at once; coefficients with n < m are 0.
class SeatBasis {
 public:
  static constexpr int lanes = 8;
  using Lanes = Eigen::Array<double, lanes, 1>;

  /// @param degrees  even, 2 to 400
  explicit SeatBasis(int degrees);

  int degrees() const { return degrees_; }
  Eigen::Index size() const { return up_.size(); }
  /// Index of the coefficient of N_nm, n >= m.
  Eigen::Index index(int n, int m) const;
  /// N_nm at a polar angle.
  Eigen::ArrayXd functions(double v) const;

  /// Factors that turn the harmonics of dm (p dS, or dS) into the harmonics of
  ///
  ///     Phi = ∫ |w x r| dm (n even),   Xi = ∫ asin(w.r) dm (n odd)
  ///
  /// as functions of w (Funk and Hecke).
  const Eigen::ArrayXd& factors() const { return factors_; }

  /// Turns harmonics into the harmonics of the mirror image across the equator.
  void mirror(Eigen::ArrayXd& c) const;

  /// m = w Phi + grad Phi, f = w x grad Xi.
  /// @param c     harmonics of Phi and Xi
  /// @param axis  w, unit vector in the plane's axes: x on the side of the
  ///              load, z the seat's axis
  SeatSlip dry(const Eigen::ArrayXd& c, const Eigen::Vector3d& axis) const;
  /// m = ∫ (w - r (r.w)) dm, f = w x ∫ r dm.
  SeatSlip viscous(const Eigen::ArrayXd& c, const Eigen::Vector3d& axis) const;

 private:
  int degrees_;
  // N_nm over sin v (m = 0: itself) = Q: Q_(n+1) = up z Q_n - down Q_(n-1),
  // dN/dv = n z Q_n - slope Q_(n-1).
  Eigen::ArrayXd up_, down_, slope_, factors_;
};

/// Contribution of each cell of a grid to each harmonic, from pressures and
/// from covered area: a coefficient of the basis in each column.
struct SeatMoments {
  SeatMoments(const SeatCells& cells, const SeatBasis& basis);

  /// @param of  p_i at the longitudes, (i, j)
  Eigen::ArrayXd of_pressure(const Eigen::MatrixXd& of) const {
    return harmonics(pressure, of);
  }
  /// @param of  the covered share of cell i at each longitude
  Eigen::ArrayXd of_area(const Eigen::MatrixXd& of) const {
    return harmonics(area, of);
  }

  const SeatBasis& basis;
  Eigen::MatrixXd pressure, area;

 private:
  Eigen::ArrayXd harmonics(const Eigen::MatrixXd& cells,
                           const Eigen::MatrixXd& of) const;
};

/// Harmonics of contacts, times factors(): harmonics of p dS in N, and of dS
/// over the squared radius.
struct SeatHarmonics {
  Eigen::ArrayXd pressure, area;
};

/// Computes SeatHarmonics with the moments of each grid, which it keeps. Any
/// number of threads may share it.
class SeatSums {
 public:
  explicit SeatSums(int degrees) : basis_(degrees) {}

  const SeatBasis& basis() const { return basis_; }
  /// @param unit_force  SeatWindows::unit_force()
  SeatHarmonics of(const SeatSolution& solution, double unit_force) const;

 private:
  SeatBasis basis_;
  mutable std::mutex making_;
  mutable std::map<std::shared_ptr<const SeatPatchSolver>,
                   std::unique_ptr<const SeatMoments>>
      moments_;
};

/// From the seat's axis z, rad.
inline double polar_angle(const Eigen::Vector3d& force) {
  return std::atan2(std::hypot(force.x(), force.y()), force.z());
}

/// Axes of the plane of a force: x lies along its component across the seat's
/// axis z.
inline Eigen::Matrix3d plane_axes(const Eigen::Vector3d& force) {
  const double across = std::hypot(force.x(), force.y());
  const double c = across > 0 ? force.x() / across : 1;
  const double s = across > 0 ? force.y() / across : 0;
  Eigen::Matrix3d axes;
  axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return axes;
}

}  // namespace contact::detail
