#pragma once

#include <memory>
#include <mutex>
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
struct ExactRelation;
}  // namespace detail

/// The exact contact of PinContact and BallContact as a half-angle law, for
/// any elastic pair: docs/conforming.md.
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
/// Where the solver does not reach the limit half-angle (a nearly
/// incompressible inner body in a nearly rigid outer one: a pin beyond
/// 163 deg, a ball beyond 175 deg) limit_half_angle() is that end, and larger
/// loads give it with not_converged; a pin with beta = 0 has no such end.
class ExactLaw final : public HalfAngleLaw {
 public:
  /// @param loading  how the inner body is loaded; the force at its centre
  ///                 unless told otherwise
  ExactLaw(JointKind kind, const ElasticPair& pair,
           InnerLoading loading = InnerLoading::centre());
  /// A joint with walls: its load parameter is that of the two surfaces.
  /// theta0 to 1e-8 of itself against the solver; the constructor solves the
  /// contact at 64 half-angles, for thin free rings at 128 more.
  /// @throws Error for a coated inner body that is loaded through the back.
  ExactLaw(JointKind kind, const LayeredPair& pair,
           InnerLoading loading = InnerLoading::centre());
  ~ExactLaw() override;

  std::string name() const override { return "exact"; }
  HalfAngleResult half_angle(double load_parameter) const noexcept override;
  LoadParameterResult load_parameter(double half_angle) const noexcept override;
  double limit_half_angle() const noexcept override;
  /// Of a ball that is not loaded through the back, and of a pin whose wall has
  /// a backing other than an infinite body; NaN of others. From a table of its
  /// own, which the first call makes by 40 to 192 solutions; any thread.
  /// Accuracy (half_angle/exact_test.cpp): both within 2e-7 of
  /// the solver, with walls 2e-8.
  ContactApproach approach(double half_angle) const override;
  /// A note if the solver does not reach the limit half-angle.
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  // One of the two.
  std::unique_ptr<const detail::ExactRelation> relation_;
  std::unique_ptr<const HalfAngleLaw> closed_form_;
  mutable std::once_flag approach_asked_;
  mutable std::unique_ptr<const detail::ApproachTable> approach_;
};

}  // namespace contact
