#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/pair/layers.hpp"
#include "libcontact/seat/cells.hpp"
#include "libcontact/seat/side_face.hpp"

namespace contact::detail {

/// Displacement of the cells of a seat under pressures on them, order by order
/// in longitude: a pressure w_i cos(m phi) gives the mean displacement
/// A_m(k, i) cos(m phi), weighted by w_k sin v, of cell k, in units of 4 rho/E:
///
///     A_m = sum_{n >= m} c_n B_n B_n^T,  B_i,n = ∫ w_i N_nm(cos v) sin v dv,
///
/// c_n of LayerCompliance for both bodies, N_nm normalised Legendre functions,
/// ∫ N_nm^2 dz = 1. Beyond the last degree the sum continues with c_n = 1/n,
/// the singularities of w_i at rims and its jumps between cells.
struct SeatCompliance {
  /// @param order      M, the largest m
  /// @param side_face  compliance of side faces if the body ends at the rims;
  ///                   may be null
  SeatCompliance(const LayeredPair& pair, const SeatCells& cells, int order,
                 const SideFaceCompliance* side_face = nullptr);

  std::vector<Eigen::MatrixXd> matrix;   ///< A_m
  std::vector<Eigen::MatrixXd> inverse;  ///< A_m^-1, regularised, see there
  int degree;                            ///< degree of the last harmonic
};

}  // namespace contact::detail
