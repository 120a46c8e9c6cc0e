// SPDX-License-Identifier: MIT
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
/// A stop resists a penetration d of the hinge, at the rate v, by the moment
///
///     M = k d + c v, not below 0,  c = min(k d X/v0, X sqrt(k J)),
///
/// with the opposite moment on the parent. This is Hunt and Crossley's damping
/// with their number X for the restitution, exact for every impact
/// (contact::HuntCrossley), and the rate v0 of the touch. J is a bound of the
/// inertia carried by the hinge: no impact reaches the second limit, which
/// applies to bodies pressed against a stop without an impact. On a ball hinge
/// M acts about the normal of the two directions that define the hinge's angle.
class CompliantStops {
 public:
  /// @param c  must outlive this object
  CompliantStops(const Case& c, const History& history);

  /// As in ForceModel.
  void add_forces(std::span<const multibody::BodyMotion> bodies,
                  std::span<multibody::BodyForce> forces) const;
  void add_kinks(std::span<const multibody::BodyMotion> bodies,
                 std::vector<multibody::KinkedVariable>& to) const;
  /// M of the stop on a body, N m.
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
    Eigen::Vector3d axis;  ///< towards larger angles, inertial axes
  };
  Push push(const Active& active,
            std::span<const multibody::BodyMotion> bodies) const;

  const Case& case_;
  std::vector<Active> active_;
};

}  // namespace separation
