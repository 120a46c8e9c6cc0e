// Ball joints that rest on their stops.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libcontact/base/root_finding.hpp"
#include "multibody/friction/hinges.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const HingeStop* Hinge::stop_at(const double* s) const {
  if (!is_axis) return rests_on >= 0 ? &stops[rests_on] : nullptr;
  const auto found = std::ranges::find(stops, *s, &HingeStop::angle);
  return found == stops.end() ? nullptr : &*found;
}

void Hinges::add_cone(int body, const double* s) {
  const Hinge& hinge = hinges_[body];
  const StopCone::Turn turn = hinge.cone->turn(s);
  at_.cones.push_back(
      {body, hinge.stops[hinge.rests_on].side, turn.axis, -turn.bend});
  at_.cone_change.assign(hinges_.size(), {0, 0, 0});
}

const ConeRest* Hinges::cone_of(int body) const {
  const auto found = std::ranges::find(at_.cones, body, &ConeRest::body);
  return found == at_.cones.end() ? nullptr : &*found;
}

Vector3d Hinges::cone_axis(int body) const {
  const double* s = at_.state.data() + at_.dynamics.layout().offset(body);
  return hinges_[body].cone->turn(s).axis;
}

VectorXd Hinges::along_cones() const {
  VectorXd along(at_.cones.size());
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const ConeRest& cone = at_.cones[k];
    along[k] = cone.axis.dot(acceleration(cone.body));
  }
  return along;
}

// Friction and the stop's moment together are the moment on a ball joint.
void Hinges::add_stop(int body) {
  const ConeRest* cone = cone_of(body);
  if (!cone) return;
  const Vector3d moment = memory(body).moment + cone->moment * cone->axis;
  forces().bodies[body].friction = vec3(moment);
}

void Hinges::push(const VectorXd& by) {
  for (Eigen::Index k = 0; k < by.size(); ++k) {
    ConeRest& cone = at_.cones[k];
    cone.moment += by[k];
    add_stop(cone.body);
    at_.cone_change[cone.body] = vec3(Vector3d(by[k] * cone.axis));
  }
  add_moments(at_.cone_change);
}

// Accelerations are linear in the moments of the stops: by differences, large
// enough not to be lost in the rounding of other moments, and small enough to
// leave no rounding of their own.
void Hinges::find_cone_inertia() {
  constexpr double share = 1e8;  // of rounding(), 1e-14 of what acts
  const double least = share * rounding().moment;
  const auto count = static_cast<Eigen::Index>(at_.cones.size());
  MatrixXd responses(count, count);
  VectorXd before = along_cones();
  for (Eigen::Index k = 0; k < count; ++k) {
    const ConeRest& cone = at_.cones[k];
    const double pace =
        std::max(acceleration(cone.body).norm(), std::abs(cone.target));
    const double size = std::max(hinges_[cone.body].inertia * pace, least);
    const double moment = size > 0 ? size : 1;
    push(moment * VectorXd::Unit(count, k));
    const VectorXd after = along_cones();
    responses.col(k) = (after - before) / moment;
    before = after;
  }
  at_.cone_inertia = responses.inverse();
}

// Sets the moments of the stops, pushing or pulling, for psi'' = 0 under the
// present friction. The second round removes errors of the responses.
void Hinges::keep_on_cones() {
  if (at_.cones.empty()) return;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    VectorXd left = -along_cones();
    for (Eigen::Index k = 0; k < left.size(); ++k) {
      left[k] += at_.cones[k].target;
    }
    push(at_.cone_inertia * left);
  }
}

double Hinges::stop_moment(int body) {
  if (const ConeRest* cone = cone_of(body)) return cone->side * cone->moment;
  const int push = now(body).push;
  if (push == 0 || hinges_[body].mode != HingeMode::resting) return 0;
  if (hinges_[body].is_axis) return push * reaction(body).moment.z;
  utilisation(body);
  return now(body).stop_moment;
}

// Friction holds what the stop leaves of the held moment. With more of the stop
// the impending slip turns from towards the stop to away from it, and friction
// is that of sliding where it is along the cone. Without a moment that turns it
// towards the stop, friction holds all.
double Hinges::utilisation_on_cone(int body) {
  const Hinge& hinge = hinges_[body];
  HingeSolver::Memory& solver = memory(body).solver;
  const Vector3d pushed = now(body).push * cone_axis(body);
  Reaction<double> by_friction = reaction(body);
  const Vector3d held = vec3(by_friction.moment);
  double tau = 0;
  const auto off_the_stop = [&](double moment) {
    by_friction.moment = vec3(Vector3d(held - moment * pushed));
    tau = hinge.solver.utilisation(by_friction, solver);
    return solver.slip_direction.dot(pushed);
  };
  const double alone = off_the_stop(0);
  if (!(alone < 0)) return tau;
  double high = std::max(held.dot(pushed), 1e-3 * held.norm());
  double at_high = off_the_stop(high);
  constexpr int most = 60;
  for (int i = 0; at_high < 0 && i < most; ++i) {
    high *= 2;
    at_high = off_the_stop(high);
  }
  if (at_high > 0) {
    high = contact::shrink_bracket(off_the_stop, 0, high, alone, at_high, 50)
               .middle();
    off_the_stop(high);
  }
  now(body).stop_moment = high;
  return tau;
}

}  // namespace multibody
