// Declarations of our own of what recipes/drake.cpp uses of Drake.
#pragma once

#include "drake/systems/framework/leaf_system.h"

namespace drake::multibody {

template <class T>
class SpatialForce {
 public:
  Eigen::Vector3d translational() const;
};

template <class T>
class MultibodyPlant {
 public:
  int num_multibody_states() const;
  int num_velocities() const;
  double time_step() const;
  std::unique_ptr<systems::Context<T>> CreateDefaultContext() const;
  void SetPositionsAndVelocities(systems::Context<T>*,
                                 const Eigen::VectorXd&) const;
  void CalcMassMatrix(const systems::Context<T>&, Eigen::MatrixXd*) const;
  void CalcBiasTerm(const systems::Context<T>&, Eigen::VectorXd*) const;
  Eigen::VectorXd CalcGravityGeneralizedForces(
      const systems::Context<T>&) const;
};

}  // namespace drake::multibody
