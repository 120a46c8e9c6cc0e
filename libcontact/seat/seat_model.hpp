#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/joint/contact_model.hpp"
#include "libcontact/seat/contact.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/table.hpp"

namespace contact::detail {

/// Grids of a seat that ends; they do not depend on friction.
struct SeatGrids {
  /// @throws Error as SeatContact
  explicit SeatGrids(const JointSpec& joint,
                     const SeatContact::Grid& grid = {});

  SeatContact contact;
  SeatSums sums;
};

/// A contact at a rim with the data for friction; or only the axes of a contact
/// away from the rims.
struct SeatFound final : ContactWork {
  std::shared_ptr<const ContactWork> without_grid() const override;

  /// Rotation from the seat's axes, z along its axis, to the solution's axes.
  Eigen::Matrix3d to_solution = Eigen::Matrix3d::Identity();
  bool is_at_rim = false;
  SeatState state;  ///< in the seat's axes
  SeatHarmonics harmonics;
  std::shared_ptr<const SeatBasis> basis;  ///< null without the harmonics
  int evaluations = 0;
};

/// A joint (docs/explanation/joint.md) with a seat that ends: for the force F
/// on the seat, any vector, and s = 1 if the carrier has the ball, -1 if the
/// body has it,
///
///     R = s F + R_t(F, Dw).
///
/// R_t is normal to Dw, but not to F, and M_t need not lie in the plane of
/// both. Friction is dry or viscous.
///
/// Accuracy (seat/joint_test.cpp, by another program):
/// docs/internals/seat_methods.md.
class SeatModel final : public ContactModel {
 public:
  /// @param endless  the joint without its seat, with the laws exact
  SeatModel(const JointSpec& joint, std::shared_ptr<const SeatGrids> grids,
            Joint endless, std::shared_ptr<const SeatTable> table = nullptr);

  JointSolution solve(const Joint::Slip& slip, const JointSolution& last,
                      const SolveOptions& options) const override;
  JointSolution solve_contact(const Joint::KnownContact& known) const override;
  RestSolution at_rest(const Joint::Hold& hold, const RestSolution& last,
                       const SolveOptions& options) const override;
  std::shared_ptr<const ContactMoments> moments(
      const JointSolution& solution) const override;
  std::optional<RimContact> rims(const JointSolution& solution) const override;
  ContactPv pv(const JointSolution& solution,
               const Eigen::Vector3d& rate) const override;
  std::vector<double> pressures(const JointSolution& solution,
                                std::span<const Eigen::Vector3d> places,
                                Joint::RimPressure at_rims) const override;
  std::vector<std::string> notes(const JointSolution& solution) const override;
  JointSolution with_grid(const JointSolution& solution,
                          const JointSolution& near) const override;

  std::shared_ptr<const ContactModel> tabulated(
      const RimTableOptions& options) const override;
  std::shared_ptr<const ContactModel> tabulated(
      std::string_view table) const override;
  std::string table() const override;
  std::optional<RimTableCheck> table_check() const override;

 private:
  class Moments;
  struct Pull {
    Eigen::Vector3d force, moment;
  };
  struct Turning;
  struct Against;
  Eigen::Matrix3d to_solution(const Placement* placement) const;
  bool is_free(const JointSolution& s, const Eigen::Matrix3d& turn) const;
  JointSolution in_its_axes(JointSolution s, const Placement* placement) const;
  std::shared_ptr<SeatFound> begin(const JointSolution& last,
                                   const Placement* placement) const;
  JointSolution slide(const Turning& turning,
                      const std::shared_ptr<SeatFound>& found) const;
  bool find_rest(const Joint::Hold& hold, const Eigen::Vector3d& direction,
                 const std::shared_ptr<SeatFound>& found,
                 RestSolution& rest) const;
  Eigen::Matrix2d slope(const SeatFound& found, const Against& against,
                        const Eigen::Vector2d& y) const;
  Eigen::Vector3d start(const Eigen::Vector3d& force) const;
  bool find_contact(const Eigen::Vector3d& force, SeatFound& found) const;
  void add_harmonics(SeatFound& found) const;
  Pull friction(const SeatFound& found, const Eigen::Vector3d& rate) const;
  JointSolution answer(const Turning& turning, const Pull& pull,
                       const std::shared_ptr<SeatFound>& found) const;
  JointSolution at_rim_solution(const Turning& turning, const Pull& pull,
                                const SeatFound& found) const;
  JointSolution no_answer(const Turning& turning, SeatStatus status,
                          const std::shared_ptr<SeatFound>& found) const;
  SeatState state_of(const JointSolution& solution) const;

  JointSpec spec_;
  std::shared_ptr<const SeatGrids> grids_;
  Joint endless_;
  double side_;              // s
  Eigen::Matrix3d to_body_;  // from the seat's to its body's axes
  std::shared_ptr<const SeatTable> table_;
};

}  // namespace contact::detail
