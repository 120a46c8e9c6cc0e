#pragma once

#include <memory>
#include <span>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "multibody/system/state_layout.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

class SystemConstants;
namespace detail {
class LaneKernel;
}

/// Several motions at once, one in each lane of the vector registers: the
/// arithmetic of Dynamics for dispersion studies. All motions have the same
/// kinds of loads and the same joint modes.
///
/// Arrays hold number after number, each as lanes() doubles side by side:
///   state          layout().size() numbers
///   loading        6 + 9 L: CarrierLoading, then LoadForces of each load
///   accelerations  6 + 3 L: CarrierAcceleration (without gravity), then
///                  relative angular accelerations as in Dynamics
///   reactions      6 L: Reaction of each load
/// Accuracy as Dynamics; no call but the constructor and set_mode allocates.
class LaneDynamics {
 public:
  /// Motions of one system. @param set  a supported instruction set
  explicit LaneDynamics(
      const System& system,
      contact::InstructionSet set = contact::best_instruction_set());
  /// Motions of lanes(set) systems that differ in numbers.
  /// @throws contact::Error if their count or the kinds of their loads differ
  explicit LaneDynamics(
      std::span<const System> systems,
      contact::InstructionSet set = contact::best_instruction_set());
  ~LaneDynamics();
  LaneDynamics(LaneDynamics&&) noexcept;
  LaneDynamics& operator=(LaneDynamics&&) noexcept;

  /// Motions side by side: 8 with AVX-512, 4 with AVX2.
  static int lanes(contact::InstructionSet set);
  int lanes() const { return lanes_; }
  int size() const { return static_cast<int>(modes_.size()); }
  JointMode mode(int load) const { return modes_[load]; }
  void set_mode(int load, JointMode mode);
  const StateLayout& layout() const { return layout_; }

  void evaluate(const double* state, const double* loading);
  /// As Dynamics::add_friction. @param change  3 L numbers
  void add_friction(const double* change);
  /// Of the last evaluation.
  void accelerations(double* to) const;
  void reactions(double* to) const;
  /// d(state)/dt after evaluate() of the same state.
  /// @param gravity  3 numbers
  void rates(const double* state, const double* gravity, double* to) const;

 private:
  void initialise(std::span<const System> systems, contact::InstructionSet set);

  int lanes_ = 0;
  std::vector<JointKind> kinds_;
  std::vector<JointMode> modes_;
  StateLayout layout_;
  std::vector<std::unique_ptr<const SystemConstants>> constants_;
  std::unique_ptr<detail::LaneKernel> kernel_;
};

}  // namespace multibody
