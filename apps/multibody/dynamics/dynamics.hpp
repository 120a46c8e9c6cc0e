#pragma once

#include <Eigen/Core>
#include <cassert>
#include <memory>
#include <span>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/dynamics/kernel/dynamics_kernel.hpp"
#include "multibody/system/force_model.hpp"

namespace multibody {

namespace detail {
class TreeKernel;
}

/// Accelerations and reactions of a carrier with its bodies, resolved in two
/// steps, one motion in double precision: of a star by TwoStep, of a deeper
/// tree by Forest. The work is proportional to the number of bodies; no call
/// but the constructor, set_mode and the first evaluation allocates.
///
/// All vectors are in link axes (Link::axes). NaN in gives NaN out.
///
/// Accuracy: errors in units of the largest component of a quantity are at
/// most 3.1e-14 against the dense reference in long double, L = 1 to 64, all
/// kinds of joints (multibody/dynamics_test.cpp).
class Dynamics {
 public:
  /// At first all joints turn; bodies without a hinge are released.
  /// @param set  instruction set, a supported one
  explicit Dynamics(const System& system,
                    contact::InstructionSet set = contact::instruction_set());

  int size() const { return static_cast<int>(modes_.size()); }
  /// Whether bodies hang on bodies.
  bool is_tree() const { return tree_ != nullptr; }
  JointMode mode(int body) const { return modes_[body]; }
  const std::vector<JointMode>& modes() const { return modes_; }
  /// Changes the mode of a joint. Turning and held joints have the same numbers
  /// in the state; releasing a joint changes the layout.
  void set_mode(int body, JointMode mode);
  const StateLayout& layout() const { return layout_; }
  /// A mass that changes is this now; not of a star.
  void set_mass(const System& system, const BodyMass& mass);

  /// Full evaluation, independent of positions, velocities of the centres of
  /// mass and the carrier's rotation. Not for a fixed carrier, whose
  /// acceleration is prescribed: the opposite of gravity.
  /// @param state    layout().size() numbers
  /// @param forces  size() bodies
  void evaluate(const double* state, const ActiveForces<double>& forces);

  /// First step alone: the carrier's motion is prescribed.
  void evaluate_prescribed(const double* state,
                           const ActiveForces<double>& forces,
                           const CarrierAcceleration<double>& carrier);

  /// After evaluate(): changes friction moments by `change`, link axes, one for
  /// each body, ignored for held and released joints. Motion, matrices and
  /// factors are reused: only the effect of the change is computed. Agrees with
  /// a full evaluation to 1e-14 (multibody/dynamics_test.cpp).
  void add_friction(std::span<const Vec3<double>> change) {
    assert(static_cast<int>(change.size()) == size());
    kernel_->add_friction(change.data());
  }
  /// @param change  0 beyond size(), in the last packet
  void add_friction(const VectorRows& change) { kernel_->add_friction(change); }

  /// Accelerations of the carrier, gravity not included.
  const CarrierAcceleration<double>& carrier() const {
    return kernel_->carrier();
  }
  /// After an evaluation in the present modes. Angular acceleration of a body,
  /// link axes: derivative in link axes of the relative angular velocity, (0,
  /// 0, t'') on an axis, 0 while held; absolute for a released body. rad/s^2
  Vec3<double> relative_acceleration(int body) const {
    return kernel_->relative_acceleration(body);
  }
  /// Relative accelerations of all bodies.
  /// @param to  size() of them
  void relative_accelerations(std::span<Vec3<double>> to) const {
    assert(static_cast<int>(to.size()) == size());
    kernel_->relative_accelerations(to.data());
  }
  /// Absolute angular acceleration of a body, link axes.
  Vec3<double> angular_acceleration(int body) const {
    return kernel_->angular_acceleration(body);
  }
  /// d(state)/dt after evaluate() of the same state.
  /// @param gravity  inertial axes, m/s^2
  /// @param to       layout().size() numbers
  void rates(const double* state, const Vec3<double>& gravity,
             double* to) const {
    kernel_->rates(state, gravity, to);
  }
  /// Reactions in all joints; 0 where released.
  /// @param to  size() of them
  void reactions(std::span<Reaction<double>> to) const {
    assert(static_cast<int>(to.size()) == size());
    kernel_->reactions(to.data());
  }
  /// Reactions in rows; numbers beyond size() in the last packet may be
  /// written.
  /// @param moment  null: not needed
  void reactions(const VectorRows& force, const VectorRows* moment) const {
    kernel_->reactions(force, moment);
  }
  /// C_i: link axes to parent axes; 0 if released.
  Mat3<double> axes(int body) const { return kernel_->axes(body); }

  /// Only for a deeper tree, after an evaluation, which does not change:
  /// friction moments M_i = m_i + S_i R_i with the reactions R_i caused by all
  /// of them, in O(size). Link axes.
  /// @param moments  m_i; ignored where a joint is held or released
  /// @param slopes   S_i, m; on an axis the row of z counts
  /// @param to       M_i; 0 where a joint is held or released
  void fitting_moments(std::span<const Vec3<double>> moments,
                       std::span<const Eigen::Matrix3d> slopes,
                       std::span<Vec3<double>> to);

 private:
  std::vector<HingeKind> kinds_;
  std::vector<JointMode> modes_;
  StateLayout layout_;
  std::unique_ptr<const SystemConstants> constants_;
  std::unique_ptr<detail::DynamicsKernel> kernel_;
  detail::TreeKernel* tree_ = nullptr;  // kernel of a deeper tree
};

}  // namespace multibody
