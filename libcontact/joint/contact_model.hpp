#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/joint/joint.hpp"

/// How the contact of a joint ends. Makers of models lie in later rooms.
namespace contact::detail {

/// The work that found a contact that ends.
struct ContactWork {
  virtual ~ContactWork() = default;
  virtual std::shared_ptr<const ContactWork> without_grid() const = 0;

  double moment_coefficient = 0;  ///< |M_t|/(rho R)
};

/// Work of a solution whose Placement its joint cannot model.
struct PlacementRefused final : ContactWork {
  std::shared_ptr<const ContactWork> without_grid() const override {
    return std::make_shared<PlacementRefused>();
  }
};

/// The friction moments of a contact that is not round about n.
class ContactMoments {
 public:
  virtual ~ContactMoments() = default;
  /// M_t, N m, of dry friction at any |Dw| above 0.
  virtual Eigen::Vector3d moment(
      const Eigen::Vector3d& angular_velocity) const = 0;
};

/// Answers of a Joint with a bounded contact. Same functions as Joint.
class ContactModel {
 public:
  virtual ~ContactModel() = default;
  virtual JointSolution solve(const Joint::Slip& slip,
                              const JointSolution& last,
                              const SolveOptions& options) const = 0;
  virtual JointSolution solve_contact(
      const Joint::KnownContact& known) const = 0;
  /// Rest of a ball; a pin rests by solve().
  virtual RestSolution at_rest(const Joint::Hold& /*hold*/,
                               const RestSolution& /*last*/,
                               const SolveOptions& /*options*/) const {
    return {};
  }
  /// Null for a contact that is symmetric about n, for an unbounded joint, and
  /// for a pin.
  virtual std::shared_ptr<const ContactMoments> moments(
      const JointSolution& /*solution*/) const {
    return nullptr;
  }
  virtual std::optional<RimContact> rims(const JointSolution& /*of*/) const {
    return {};
  }
  virtual std::optional<PinLie> lie(const JointSolution& /*of*/) const {
    return {};
  }
  virtual ContactPv pv(const JointSolution& solution,
                       const Eigen::Vector3d& rate) const = 0;
  virtual std::vector<double> pressures(const JointSolution& solution,
                                        std::span<const Eigen::Vector3d> places,
                                        Joint::RimPressure at_rims) const = 0;
  virtual std::vector<std::string> notes(
      const JointSolution& solution) const = 0;
  virtual JointSolution with_grid(const JointSolution& solution,
                                  const JointSolution& /*near*/) const {
    return solution;
  }

  /// Null without a seat.
  virtual std::shared_ptr<const ContactModel> tabulated(
      const RimTableOptions& /*options*/) const {
    return nullptr;
  }
  virtual std::shared_ptr<const ContactModel> tabulated(
      std::string_view /*table*/) const {
    return nullptr;
  }
  virtual std::string table() const { return {}; }
  virtual std::optional<RimTableCheck> table_check() const { return {}; }
};

/// A solution with no numbers.
JointSolution not_a_number(Status status, const Eigen::Vector3d& reaction);

/// Why a solution has no numbers; none of one that has.
/// @param without  said of a load that has no contact
std::vector<std::string> failure_notes(Status status, const char* without);

/// Sets what follows from R_n and the strength of friction: the state of the
/// contact and the adhesion number.
void set_state(JointSolution& solution, const JointContact& contact,
               const JointContact::Strength& strength);

/// JointSolution::textbook_moment.
double textbook_moment(const JointContact& contact,
                       const Eigen::Vector3d& reaction);

/// The moments of a solution at a rim; null of others.
std::shared_ptr<const ContactMoments> moments_of(const Joint& joint,
                                                 const JointSolution& solution);

}  // namespace contact::detail
