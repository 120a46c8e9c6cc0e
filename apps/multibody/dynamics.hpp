#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "multibody/axis_load.hpp"
#include "multibody/free_load.hpp"
#include "multibody/held_load.hpp"
#include "multibody/spherical_load.hpp"
#include "multibody/state_layout.hpp"

namespace multibody {

/// Accelerations and reactions of a carrier with its loads, resolved in two
/// steps, section 1 of the paper: each load's reaction as a function of the
/// carrier's accelerations, then the carrier's own six equations. The work is
/// proportional to the number of loads; no call but the constructor and
/// set_mode allocates.
///
/// @tparam T  scalar of the state: double, SIMD lanes over trajectories, a
///            counting scalar
/// @tparam P  scalar of the parameters: double, or T if they differ by lane
template <class T, class P = double>
class Dynamics {
 public:
  explicit Dynamics(const System& system);

  int size() const { return static_cast<int>(modes_.size()); }
  JointMode mode(int load) const { return modes_[load]; }
  /// Changes what joint `load` does; turning and held states have the same
  /// layout, a released one has another.
  void set_mode(int load, JointMode mode);
  const StateLayout& layout() const { return layout_; }

  /// Full evaluation. Positions and velocities of the centres of mass do not
  /// matter here, nor does the carrier's rotation.
  /// @param state    layout().size() numbers
  /// @param loading  size() loads
  void evaluate(const T* state, const Loading<T>& loading);

  /// First step alone: the carrier's motion is prescribed.
  void evaluate_prescribed(const T* state, const Loading<T>& loading,
                           const CarrierAcceleration<T>& carrier);

  /// After evaluate(): moments of friction changed by `change` (load axes,
  /// one for each load, ignored where a joint is held or released). Motion,
  /// matrices and their factors stay; only what the change adds is computed.
  void add_friction(std::span<const Vec3<T>> change);

  /// Accelerations of the carrier, gravity not included.
  const CarrierAcceleration<T>& carrier() const { return carrier_; }
  /// Angular acceleration of a load, load axes: derivative in load axes of the
  /// relative angular velocity, (0, 0, t'') on an axis, 0 while held; of a
  /// released load the absolute one.
  const Vec3<T>& relative_acceleration(int load) const {
    return relative_[load];
  }
  /// Absolute angular acceleration of a load, load axes.
  Vec3<T> angular_acceleration(int load) const;
  /// Reaction in a joint; 0 if released.
  Reaction<T> reaction(int load) const;
  /// C_i: load axes to carrier axes; meaningless if released.
  Mat3<T> axes(int load) const;

 private:
  struct Entry {
    int load;
    int slot;
  };

  void set_motion(const T* state, const Loading<T>& loading,
                  const CarrierMotion<T>& motion);
  void set_accelerations();
  void sort_loads();
  // f(load object) for the joint of `load`, as it is at the moment.
  template <class Result, class F>
  Result visit(int load, const Result& released, F f) const;

  Sym3<P> inertia_;
  P mass_;
  std::vector<JointKind> kinds_;
  std::vector<JointMode> modes_;
  StateLayout layout_;
  std::vector<int> slots_;  ///< in spherical_ or axes_

  std::vector<SphericalLoad<T, P>> spherical_;
  std::vector<AxisLoad<T, P>> axes_;
  std::vector<HeldLoad<T, P>> held_;  ///< one for each load
  std::vector<FreeLoad<T, P>> free_;  ///< one for each load
  std::vector<Entry> turning_spherical_, turning_axes_;
  std::vector<int> held_now_, free_now_;

  CarrierMatrix<P> fixed_;
  CarrierSolver<T> solver_;
  CarrierForces<T> forces_;
  CarrierAcceleration<T> carrier_;
  std::vector<Vec3<T>> relative_;
};

/// The instances in the library; include dynamics_impl.hpp for others.
extern template class Dynamics<double>;

}  // namespace multibody
