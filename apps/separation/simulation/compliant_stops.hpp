#pragma once

#include <span>
#include <vector>

#include "multibody/system/force_model.hpp"
#include "separation/case/case.hpp"

namespace separation {

struct History;

/// Axis about which the hinge's angle grows, inertial axes.
Eigen::Vector3d axis_of(const Hinge& hinge, const multibody::BodyMotion& parent,
                        const multibody::BodyMotion& body);

/// Moments of the compliant stops of a case, from one event to the next.
///
/// A stop that a hinge has turned into by d, at the rate v, pushes it back by
///
///     M = k d + c v, not below 0,  c = min(k d X/v0, X sqrt(k J)),
///
/// and what the hinge is on by the opposite: Hunt and Crossley's damping, X
/// their number for the restitution, exact for every impact (contact::
/// HuntCrossley), v0 the rate of the touch. J is a bound of the inertia that
/// the hinge carries: no impact meets the second limit, which is for what is
/// pressed against a stop without one. On a ball hinge M is about the normal of
/// the two directions whose angle is the hinge's.
class CompliantStops {
 public:
  /// @param c  has to outlive this object
  CompliantStops(const Case& c, const History& history);

  /// As ForceModel has them.
  void add_forces(std::span<const multibody::BodyMotion> bodies,
                  std::span<multibody::BodyForce> forces) const;
  void add_kinks(std::span<const multibody::BodyMotion> bodies,
                 std::vector<multibody::KinkedVariable>& to) const;
  /// M of the stop that pushes a body, N m.
  double moment(int body, std::span<const multibody::BodyMotion> bodies) const;

 private:
  struct Active {
    int body;
    const HingeStop* stop;
    double touch;         ///< v0, rad/s; 0: none
    double most_damping;  ///< X sqrt(k J)
  };
  struct Push {
    double moment;
    Eigen::Vector3d axis;  ///< of larger angles, inertial axes
  };
  Push push(const Active& active,
            std::span<const multibody::BodyMotion> bodies) const;

  const Case& case_;
  std::vector<Active> active_;
};

}  // namespace separation
