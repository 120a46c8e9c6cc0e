#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "multibody/dynamics/forest.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel.hpp"

namespace multibody::detail {

/// Dynamics of systems in which bodies hang on bodies, by Forest in link axes;
/// the carrier is its body 0.
class TreeKernel final : public DynamicsKernel {
 public:
  TreeKernel(const System& system, contact::InstructionSet set);

  void set_mode(int body, JointMode mode) override;
  /// Dynamics::set_mass()
  Forest& forest() { return forest_; }
  void evaluate(const double* state, const CarrierActiveForces<double>& carrier,
                const LinkForces<double>* bodies) override;
  void evaluate_prescribed(const double* state,
                           const LinkForces<double>* bodies,
                           const CarrierAcceleration<double>& carrier) override;
  void add_friction(const Vec3<double>* change) override;
  void add_friction(const VectorRows& change) override;
  const CarrierAcceleration<double>& carrier() const override {
    return carrier_;
  }
  Vec3<double> relative_acceleration(int body) const override;
  void relative_accelerations(Vec3<double>* to) const override;
  Vec3<double> angular_acceleration(int body) const override;
  Mat3<double> axes(int body) const override;
  void rates(const double* state, const Vec3<double>& gravity,
             double* to) const override;
  void reactions(Reaction<double>* to) const override;
  void reactions(const VectorRows& force,
                 const VectorRows* moment) const override;

  /// Dynamics::fitting_moments()
  void fitting_moments(std::span<const Vec3<double>> moments,
                       std::span<const Eigen::Matrix3d> slopes,
                       std::span<Vec3<double>> to);

 private:
  int size() const { return static_cast<int>(modes_.size()); }
  bool turns(int body) const { return modes_[body] == JointMode::turning; }
  void set_state(const double* state, const LinkForces<double>* bodies);
  void set_hinge(int body, const double* numbers);
  void respond();
  Reaction<double> reaction(int body) const;

  std::vector<HingeKind> kinds_;
  std::vector<int> parents_;
  std::vector<Mat3<double>> to_parent_link_;  // from the parent's own axes
  std::vector<Mat3<double>> zero_;  // axis: at angle zero, parent's link axes
  std::vector<JointMode> modes_;
  std::vector<double> angles_, sines_, cosines_;  // axes
  StateLayout layout_;
  Forest forest_;
  std::vector<ForestState> state_, sloped_state_;
  ForestWork work_, sloped_work_;
  CarrierAcceleration<double> carrier_{};
};

}  // namespace multibody::detail
