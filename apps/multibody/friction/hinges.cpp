#include "multibody/friction/hinges.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/kinds.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

JointMode joint_mode(HingeMode mode) {
  switch (mode) {
    case HingeMode::sliding:
      return JointMode::turning;
    case HingeMode::released:
      return JointMode::released;
    default:
      return JointMode::held;
  }
}

// About the hinge, of a turn that moves the centre of mass: the least.
double inertia_of(const Link& link) {
  const double about = link.mass * link.arm * link.arm;
  const double least = hinge_traits(link.kind).is_axis
                           ? link.inertia(2, 2)
                           : std::min(link.inertia(0, 0), link.inertia(1, 1));
  return least + about;
}

}  // namespace

Hinge::Hinge(HingeFriction friction, const Link& link, int body)
    : leverage(link.mass * link.arm / inertia_of(link)),
      mass(link.mass),
      inertia(inertia_of(link)),
      length(std::max(link.arm, link.hinge.norm())),
      solver(std::move(friction), link, body) {
  has_friction = solver.has_friction();
  can_rest = solver.can_rest();
  is_axis = solver.is_axis();
  if (link.kind == HingeKind::none) mode = HingeMode::released;
}

Hinges::Hinges(const System& system, const std::vector<HingeFriction>& friction)
    : dynamics_(system), change_(system.size()), reactions_(system.size()) {
  if (static_cast<int>(friction.size()) != system.size()) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("friction of {} hinges", friction.size()),
        fmt::format("of {}, one for each body", system.size())));
  }
  for (int i = 0; i < system.size(); ++i) {
    hinges_.emplace_back(friction[i], system.links()[i], i);
  }
  active_.reserve(system.size());
}

void Hinges::set_mode(int body, HingeMode mode) {
  Hinge& hinge = hinges_[body];
  if (joint_mode(hinge.mode) != joint_mode(mode)) {
    // They stay those of the last evaluation.
    know_reactions();
    dynamics_.set_mode(body, joint_mode(mode));
  }
  hinge.mode = mode;
  hinge.straight = hinge.follows = false;
  hinge.slope.setZero();
  hinge.utilisation_of = -1;
  active_known_ = false;
}

void Hinges::set_state(const double* state) {
  ++evaluation_;
  state_ = state;
  std::ranges::fill(change_, Vec3<double>{0, 0, 0});
  if (!active_known_) {
    active_.clear();
    for (int i = 0; i < size(); ++i) {
      if (hinges_[i].is_active()) active_.push_back(i);
    }
    active_known_ = true;
  }
  for (const int i : active_) {
    Hinge& hinge = hinges_[i];
    const double* s = state + dynamics_.layout().offset(i);
    const bool dry = hinge.can_rest;
    if (!hinge.is_axis) {
      hinge.rate = Vector3d(s[4], s[5], s[6]);
      if (dry && (hinge.straight || hinge.rate.isZero(0))) {
        hinge.rate = hinge.direction;
      }
    } else {
      // Beyond the end of its sliding, where a step may look, dry friction
      // goes on as if it slid the way it did.
      constexpr double least = 1e-100;
      const double sign = hinge.direction.z();
      const double rate = dry ? sign * std::max(sign * s[1], least) : s[1];
      hinge.rate = Vector3d(0, 0, rate);
    }
  }
}

bool Hinges::any_gets_under_way() const {
  // No acceleration that the tolerance leaves uncertain brings so fast a motion
  // to its end, and none so large is uncertain.
  constexpr double slow = 1e-5;
  constexpr double share = 1e-4;
  return std::ranges::any_of(active_, [&](int i) {
    const Hinge& hinge = hinges_[i];
    const bool is_slow =
        hinge.follows || (hinge.is_axis && std::abs(hinge.rate.z()) < slow);
    return is_slow && hinge.can_rest &&
           hinge.inertia * acceleration(i).norm() < share * hinge.moment.norm();
  });
}

void Hinges::start(ActiveForces<double>& forces) {
  forces_ = &forces;
  for (int i = 0; i < size(); ++i) {
    Hinge& hinge = hinges_[i];
    if (!hinge.is_active()) hinge.moment.setZero();
    forces.bodies[i].friction = vec3(hinge.moment);
  }
  evaluate();
}

void Hinges::evaluate() {
  if (prescribed_) {
    dynamics_.evaluate_prescribed(state_, *forces_, *prescribed_);
  } else {
    dynamics_.evaluate(state_, *forces_);
  }
  reactions_known_ = false;
}

void Hinges::apply_changes() {
  ++evaluation_;
  ++change_count_;
  for (const int i : active_) {
    hinges_[i].moment += vec3(change_[i]);
    forces_->bodies[i].friction = vec3(hinges_[i].moment);
  }
  if (prescribed_) {
    evaluate();
  } else {
    dynamics_.add_friction(change_);
    reactions_known_ = false;
  }
}

void Hinges::give_reactions(FrictionTracker& tracker) {
  tracker.take_reactions(dynamics_, active_, reactions_);
  reactions_known_ = !tracker.is_direct();
}

void Hinges::take_moment(int body, const Vector3d& moment) {
  hinges_[body].moment = hinges_[body].solved = moment;
  forces_->bodies[body].friction = vec3(moment);
}

void Hinges::move(FrictionTracker& tracker) {
  if (prescribed_) {
    evaluate();
  } else {
    tracker.move(dynamics_, active_, change_);
  }
  give_reactions(tracker);
}

void Hinges::know_reactions() {
  if (!reactions_known_) dynamics_.reactions(reactions_);
  reactions_known_ = true;
}

Vector3d Hinges::acceleration(int body) const {
  return vec3(dynamics_.relative_acceleration(body));
}

double Hinges::solve(double floor) {
  double largest = 0;
  for (const int i : active_) {
    Hinge& hinge = hinges_[i];
    hinge.solved = hinge.solver.slide(reaction(i), hinge.rate);
    hinge.solver_is_behind = false;
    largest = std::max(largest, hinge.solved.norm());
  }
  double residual = 0;
  for (const int i : active_) {
    const Hinge& hinge = hinges_[i];
    const double difference = (hinge.solved - hinge.moment).norm();
    if (difference == 0) continue;
    const double own = difference / (hinge.solved.norm() + hinge.moment.norm() +
                                     small_share * largest + floor);
    // NaN stays, whatever follows.
    if (!(own <= residual) && !std::isnan(residual)) residual = own;
  }
  return residual;
}

std::span<const contact::JointSolution> Hinges::joints(int body) {
  Hinge& hinge = hinges_[body];
  if (hinge.solver_is_behind && hinge.is_active()) {
    hinge.solver.slide(reaction(body), hinge.rate);
  }
  hinge.solver_is_behind = false;
  return hinge.solver.joints();
}

CoupledRounding Hinges::rounding() const {
  const auto length_of = [](const Vec3<double>& v) {
    return std::sqrt(dot(v, v));
  };
  const double* w = state_ + StateLayout::angular_velocity;
  double rate = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  double force = length_of(forces_->carrier.force);
  double moment = length_of(forces_->carrier.moment);
  double mass = 0;
  double length = 0;
  for (int i = 0; i < size(); ++i) {
    const Hinge& hinge = hinges_[i];
    if (hinge.mode == HingeMode::released) continue;
    const double* s = state_ + dynamics_.layout().offset(i);
    rate = std::max(
        rate, hinge.is_axis ? std::abs(s[1]) : std::hypot(s[4], s[5], s[6]));
    force += length_of(forces_->bodies[i].force);
    moment += length_of(forces_->bodies[i].moment);
    mass += hinge.mass;
    length = std::max(length, hinge.length);
  }
  if (prescribed_) force += mass * length_of(prescribed_->linear);
  // Some tens of operations on each.
  constexpr double share = 1e-14;
  const double forces = share * (force + mass * length * rate * rate);
  return {forces, share * moment + length * forces};
}

double Hinges::uncertain_moment() const {
  // Of all forces together, of which a hinge takes a part.
  constexpr double part = 0.1;
  double sum = 0;
  for (const int i : active_) sum += hinges_[i].moment.norm();
  return part * rounding().moment + refined_tolerance * sum;
}

Hinges::Response Hinges::response(int body) {
  Hinge& hinge = hinges_[body];
  const double size = std::max(hinge.moment.norm(), 1.0);
  const Vector3d alpha0 = acceleration(body);
  const Vector3d force0 = vec3(reaction(body).force);
  const Vector3d moment0 = vec3(reaction(body).moment);
  Response r{Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
  for (int k = hinge.is_axis ? 2 : 0; k < 3; ++k) {
    std::ranges::fill(change_, Vec3<double>{0, 0, 0});
    const Vector3d change = size * Vector3d::Unit(k);
    change_[body] = vec3(change);
    apply_changes();
    r.acceleration.col(k) = (acceleration(body) - alpha0) / size;
    r.force.col(k) = (vec3(reaction(body).force) - force0) / size;
    r.moment.col(k) = (vec3(reaction(body).moment) - moment0) / size;
    change_[body] = vec3(Vector3d(-change));
    apply_changes();
  }
  change_[body] = {0, 0, 0};
  return r;
}

double Hinges::kappa(int body) {
  Hinge& hinge = hinges_[body];
  const Response by_moment = response(body);
  const Reaction<double> at = reaction(body);
  const double force = vec3(at.force).norm();
  if (!(force > 0)) return 0;
  const Vector3d middle = hinge.solver.slide(at, hinge.rate);
  // Forward differences, good to some 1e-6.
  constexpr double share = 1e-6;
  Matrix3d by_force;
  Matrix3d by_held = Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double step = share * force;
    Reaction<double> moved = at;
    moved.force = vec3(Vector3d(vec3(at.force) + step * Vector3d::Unit(k)));
    by_force.col(k) = (hinge.solver.slide(moved, hinge.rate) - middle) / step;
    if (!hinge.is_axis || k == 2) continue;
    moved = at;
    moved.moment = vec3(Vector3d(vec3(at.moment) + step * Vector3d::Unit(k)));
    by_held.col(k) = (hinge.solver.slide(moved, hinge.rate) - middle) / step;
  }
  hinge.solver.slide(at, hinge.rate);
  // Frobenius norms, up to 3 times the largest stretch: the safe side, also
  // where hinges act on each other.
  return by_force.norm() * by_moment.force.norm() +
         by_held.norm() * by_moment.moment.norm();
}

double Hinges::utilisation(int body) {
  Hinge& hinge = hinges_[body];
  if (hinge.utilisation_of != evaluation_) {
    // Rounding does not make a hinge slide.
    const CoupledRounding least = rounding();
    const Reaction<double>& held = reaction(body);
    hinge.utilisation = vec3(held.force).norm() <= least.force &&
                                vec3(held.moment).norm() <= least.moment
                            ? 0
                            : hinge.solver.utilisation(held);
    hinge.utilisation_of = evaluation_;
  }
  return hinge.utilisation;
}

Hinges::Felt Hinges::felt(int body) {
  joints(body);  // for the convex problem
  const Matrix3d mobility = response(body).acceleration;
  const Vector3d alpha = acceleration(body);
  const Matrix3d inertia = mobility.inverse();
  return {0.5 * (inertia + inertia.transpose()),
          alpha - mobility * hinges_[body].moment};
}

}  // namespace multibody
