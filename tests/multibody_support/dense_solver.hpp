#pragma once

#include <Eigen/Dense>
#include <vector>

#include "multibody/dynamics/dynamics.hpp"

namespace multibody::test {

/// The traditional method, optimised as far as is reasonable, for benchmarks:
/// all joints' conditions at once with the reactions as unknowns, Eigen's
/// Cholesky factorisation, and storage and constants prepared. Reactions are in
/// carrier axes, so that only parts that rotate change in the matrix. Bodies
/// turn on ball joints or axes.
class DenseSolver {
 public:
  explicit DenseSolver(const System& system);

  /// Takes state and loads as Dynamics does; returns accelerations of the
  /// carrier and relative accelerations of the bodies.
  void evaluate(const double* state, const ActiveForces<double>& forces);
  const Eigen::Vector3d& linear() const { return linear_; }
  const Eigen::Vector3d& angular() const { return angular_; }
  const Eigen::Vector3d& relative_acceleration(int body) const {
    return bodies_[body].relative;
  }

 private:
  struct BodyPart {
    bool axis;
    int offset;  ///< in the state
    int row;
    double inverse_mass;
    Eigen::Matrix3d inertia, inverse_inertia, zero;
    Eigen::Vector3d r, r0;
    Eigen::Matrix3d inverse_i0_r0;   ///< I_0^-1 r~_0
    Eigen::Matrix3d hinge_mobility;  ///< E/m - r~ I^-1 r~
    Eigen::Matrix3d turn_mobility;   ///< - r~ I^-1
    // Evaluates the state of one instant.
    Eigen::Matrix3d c;
    Eigen::Vector3d w0, relative_w, free_linear, free_angular, relative;
  };
  void set_motion(BodyPart& body, const double* state,
                  const LinkForces<double>& forces);
  void fill_rows(std::size_t i);

  double inverse_mass_;
  Eigen::Matrix3d inertia_, inverse_inertia_;
  std::vector<BodyPart> bodies_;
  Eigen::MatrixXd constant_, matrix_;
  Eigen::VectorXd rhs_;
  Eigen::Vector3d w0_, linear_, angular_;
};

}  // namespace multibody::test
