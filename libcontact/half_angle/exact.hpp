#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

namespace detail {
class ApproachTable;
class ClosingTable;
struct ExactRelation;
}  // namespace detail

/// The exact contact of PinContact and BallContact as a half-angle law, for
/// any elastic pair: docs/explanation/conforming.md.
///
/// The constructor solves the contact at 18 to 64 half-angles and keeps them
/// as one Chebyshev series, so that a half-angle takes a fraction of a
/// microsecond: make one law per joint, not one per load. Copies are not
/// needed; any number of threads may share one.
///
/// Accuracy (half_angle/exact_test.cpp): theta0 against the solver itself
/// within 1e-11 deg (pin) and 1e-8 deg (ball); against truth the solvers'
/// own errors, 1e-9 deg and 1e-6 deg. Round trips to 1e-13 in theta0.
/// log_slope within 1e-8. half_angle() to 1e-30 and up to infinite load;
/// load_parameter() keeps its relative accuracy, 1e-9, up to the double below
/// theta0*.
///
/// Joints with zero clearance or interference (load parameter infinite or
/// negative) use a second table, of half-angles from the limit to 180 deg,
/// where the contact closes all round (PinGap, BallGap). The first query builds
/// it by 24 to 96 solutions, in any thread. The constructor builds it if the
/// solver by the pressure does not reach the limit half-angle (a nearly
/// incompressible inner body in a nearly rigid outer one: a pin beyond 163 deg,
/// a ball beyond 175 deg). Accuracy (half_angle/interference_test.cpp): x + c_0
/// at theta0 within 1e-7 of the solver, for walls below 0.1 radii 5e-6. There
/// is none if the inner body is loaded through the back, and where c_0 = 0: an
/// incompressible layer between rigid bodies cannot have interference, and its
/// limit_half_angle() may be the end of the solver, which larger loads give
/// with not_converged.
class ExactLaw final : public HalfAngleLaw {
 public:
  /// @param loading  how the inner body is loaded; the force at its centre
  ///                 unless told otherwise
  ExactLaw(JointKind kind, const ElasticPair& pair,
           InnerLoading loading = InnerLoading::centre());
  /// A joint with walls: its load parameter refers to the two surfaces. theta0
  /// to 1e-8 of itself against the solver; the constructor solves the contact
  /// at 64 half-angles, for thin free rings at 128 more.
  /// @throws Error for a coated inner body that is loaded through the back.
  ExactLaw(JointKind kind, const LayeredPair& pair,
           InnerLoading loading = InnerLoading::centre());
  ~ExactLaw() override;

  /// The bodies of a joint with walls.
  const std::optional<LayeredPair>& walls() const { return walls_; }

  std::string name() const override { return "exact"; }
  HalfAngleResult half_angle(double load_parameter) const noexcept override;
  LoadParameterResult load_parameter(double half_angle) const noexcept override;
  double limit_half_angle() const noexcept override;
  double closing_load() const override;
  ContactApproach shift(double half_angle) const override;
  /// Approach of a ball that is not loaded through the back, and of a pin whose
  /// wall has a backing other than an infinite body; NaN for others. From a
  /// table of its own, made by 40 to 192 solutions in the first call; any
  /// thread. Accuracy (half_angle/exact_test.cpp): both within 2e-7 of the
  /// solver, with walls 2e-8.
  ContactApproach approach(double half_angle) const override;
  /// A note if the solver does not reach the limit half-angle.
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  const detail::ClosingTable* closing() const;
  double load_of_inverse(double inverse) const;

  std::optional<LayeredPair> walls_;
  // One of the two.
  std::unique_ptr<const detail::ExactRelation> relation_;
  std::unique_ptr<const HalfAngleLaw> closed_form_;
  mutable std::once_flag approach_asked_;
  mutable std::unique_ptr<const detail::ApproachTable> approach_;
  mutable std::once_flag closing_asked_;
  mutable std::unique_ptr<const detail::ClosingTable> closing_;
};

}  // namespace contact
