#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "libcontact/joint/joint.hpp"

namespace contact::test {

/// Counts of integers; the last bin counts all larger ones.
class Histogram {
 public:
  static constexpr int bins = 64;

  void add(int value);
  std::uint64_t count() const;
  std::uint64_t above(int value) const;
  double mean() const { return sum_ / static_cast<double>(count()); }
  int max() const { return max_; }
  /// "4: 123, 5: 456, ...", bins that are not empty.
  std::string text() const;

 private:
  std::array<std::uint64_t, bins> counts_ = {};
  double sum_ = 0;
  int max_ = 0;
};

/// Results of the joint solver on random inputs. Errors are the largest seen.
struct JointSweep {
  std::uint64_t inputs = 0;
  std::uint64_t not_ok = 0;
  double residual = 0;      ///< |f/tan g - 1| of the contact that is returned
  double reaction = 0;      ///< |R - R_n n - R_t|/R
  double power = 0;         ///< M_t . Dw over rho R |Dw|, where above 0
  double angle_excess = 0;  ///< g - min(b, pi - b), rad, where above 0
  std::string worst_residual;
  Histogram cold;
  Histogram warm;  ///< R and Dw moved by a thousandth

  std::uint64_t fixed_point_fails = 0;  ///< leaves g <= b
  std::uint64_t fixed_point_slow = 0;   ///< more than 50 steps
  std::uint64_t fixed_point_never = 0;  ///< not within 500 steps
  Histogram fixed_point;                ///< steps where it converges
  /// The same counts by the friction coefficient f of the solution and by |b -
  /// 90 deg|; upper edges of the bins.
  static constexpr std::array<double, 6> f_edges = {0.1, 0.3, 1, 3, 10, 1e300};
  static constexpr std::array<double, 5> b_edges_deg = {0.1, 3, 20, 60, 90};
  struct Bin {
    std::uint64_t inputs = 0;
    std::uint64_t fails = 0;
    std::uint64_t slow = 0;
  };
  std::array<std::array<Bin, b_edges_deg.size()>, f_edges.size()> map = {};

  std::uint64_t scanned = 0;
  std::uint64_t several_roots = 0;
  /// Smallest limit half-angle of a joint with several roots, rad.
  double several_roots_limit = 1e300;

  std::uint64_t paths = 0;
  std::uint64_t path_steps = 0;
  /// Largest change of n, R_t/R, M_t/max M_t between inputs 1e-12 apart, found
  /// by halving the steps of the paths, over (1 + f)/min(1, theta0): at b = 90
  /// deg n reverses within angles of 1/f, at b = 0 the moment of a small
  /// contact within theta0.
  double jump = 0;
  /// Number of paths that jump from one of several roots to another, for joints
  /// whose limit half-angle is above 90 deg. They are not counted above.
  std::uint64_t folds = 0;
};

/// |f/tan g - 1| of a solution of dry friction, from the friction integrals
/// alone: the definition of a solution.
double true_residual(const Joint& joint, const JointSolution& s);

/// Solves `inputs` inputs of RandomSlips(seed), scans each for further roots,
/// and follows inputs/100 random paths of 100 steps.
JointSweep joint_sweep(std::uint64_t inputs, std::uint64_t seed);

}  // namespace contact::test
