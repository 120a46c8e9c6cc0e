#pragma once

#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/contact_model.hpp"

namespace contact::detail {

/// The slices that found a solution, and the axes that they are in.
struct SlicesFound final : ContactWork {
  std::shared_ptr<const ContactWork> without_grid() const override;

  Eigen::Matrix3d axes;  ///< columns: x along R, y, z along the pin's axis
  FinitePinSolution pin;
  double axial_velocity = 0;
};

/// The model of a Joint with a finite-length pin: docs/how-to/finite_pin.md.
/// Takes its numbers from a FinitePin with axes of its own, which the first
/// call makes in 20 to 500 ms.
class SlicesModel final : public ContactModel {
 public:
  /// @param contact  of the level pin without end
  /// @throws Error as FinitePin
  SlicesModel(const JointSpec& joint, const JointContact& contact);
  ~SlicesModel() override;

  JointSolution solve(const Joint::Slip& slip, const JointSolution& last,
                      const SolveOptions& options) const override;
  JointSolution solve_contact(const Joint::KnownContact& known) const override;
  std::optional<PinLie> lie(const JointSolution& solution) const override;
  ContactPv pv(const JointSolution& solution,
               const Eigen::Vector3d& rate) const override;
  std::vector<double> pressures(const JointSolution& solution,
                                std::span<const Eigen::Vector3d> places,
                                Joint::RimPressure at_rims) const override;
  std::vector<std::string> notes(const JointSolution& solution) const override;

 private:
  struct Asked;
  struct Numerics;
  const FinitePin* pin() const noexcept;
  JointSolution answer(const Asked& asked,
                       const FinitePinSolution& found) const;

  Joint level_;
  double side_;  // 1 if the carrier has the pin, -1 if the body has it
  std::unique_ptr<Numerics> numerics_;
};

}  // namespace contact::detail
