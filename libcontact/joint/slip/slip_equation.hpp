#pragma once

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/slip/slip_triangle.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact::detail {

/// The contact at one trial value of tan psi.
struct SlipPoint {
  SlipTriangle<double> triangle = {};
  double normal_force = 0;  ///< R_n
  HalfAngleResult half_angle = {};
  double friction = 0;  ///< f/cos a
  /// Moments over rho R_n, with a >= 0.
  double sliding = 0;
  double spinning = 0;
  double residual = 0;  ///< ln(tangent/friction), increasing with tangent
};

/// The one scalar equation of a joint: tan psi = f/cos a, f the friction
/// coefficient at R_n = R cos g and a (docs/explanation/joint.md).
class SlipEquation {
 public:
  /// @param reaction_force  R > 0
  /// @param reaction        sine and cosine of b, both >= 0
  /// @param speed           |Dw|, rad/s
  SlipEquation(const JointContact& contact, double speed, double reaction_force,
               SineCosine reaction)
      : contact_(contact),
        speed_(speed),
        strength_(contact.strength(speed)),
        reaction_force_(reaction_force),
        reaction_(reaction) {}

  /// The contact at a trial value, [0, 1e150].
  SlipPoint at(double tangent) const;
  /// Moves a point to a trial value close to another point: the half-angle
  /// follows the law's tangent line where that is exact to rounding.
  void move(SlipPoint& point, double tangent, const SlipPoint& near) const;
  /// f/cos a of any contact.
  double friction(double normal_force, SlipAxis axis) const;

  /// Puts another trial value, with its R_n and a, into a point.
  void set_triangle(SlipPoint& point, double tangent) const;
  /// The same for a step in ln tan psi: short ones by their differentials.
  void shift_triangle(SlipPoint& point, double step) const;

  JointContact::Strength strength() const { return strength_; }
  double reaction_force() const { return reaction_force_; }
  SineCosine reaction() const { return reaction_; }

 private:
  void set_friction(SlipPoint& point) const;

  const JointContact& contact_;
  double speed_;
  JointContact::Strength strength_;
  double reaction_force_;
  SineCosine reaction_;
};

struct SlipRoot {
  SlipPoint point = {};
  Status status = Status::not_converged;
  int evaluations = 0;
  double residual = 0;
  JointSolution::Memory memory = {};
};

/// Solves the equation. Starts from `last` if that is valid; falls back on
/// bracketing where quasi-Newton steps do not settle at once.
SlipRoot solve_slip(const SlipEquation& equation,
                    const JointSolution::Memory& last,
                    const SolveOptions& options);

}  // namespace contact::detail
