#include "multibody/coupled_dynamics.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/error.hpp"
#include "multibody/coupled_impl.hpp"
#include "multibody/eigen_conversion.hpp"

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

// |dR/dM| on a fixed carrier: m arm over the least inertia about the hinge
// of a turn that moves the centre of mass.
double leverage_of(const Link& link) {
  const double about = link.mass * link.arm * link.arm;
  const double least = link.kind == JointKind::axis
                           ? link.inertia(2, 2)
                           : std::min(link.inertia(0, 0), link.inertia(1, 1));
  return link.mass * link.arm / (least + about);
}

// A part of this size of the largest moment in the system counts as scale of
// every hinge's moment: smaller ones vanish in the rounding of the reactions.
constexpr double small_share = 1e-3;

}  // namespace

CoupledDynamics::Impl::Impl(const System& system,
                            std::vector<HingeFriction> friction,
                            const CoupledOptions& coupled_options)
    : options(coupled_options), dynamics(system), follower(friction) {
  if (static_cast<int>(friction.size()) != system.size()) {
    throw contact::Error(
        fmt::format("friction of {} hinges, allowed is one for each of the {} "
                    "loads",
                    friction.size(), system.size()));
  }
  for (int i = 0; i < system.size(); ++i) {
    const Link& link = system.links()[i];
    Hinge& hinge = hinges.emplace_back(std::move(friction[i]), link, i);
    hinge.leverage = leverage_of(link);
    hinge.mass = link.mass;
    hinge.length = std::max(link.arm, link.hinge.norm());
    if (link.kind == JointKind::none) hinge.mode = HingeMode::released;
  }
  reactions.resize(system.size());
  change_.resize(system.size());
  forget_way();
  rows_.reserve(system.size());
}

void CoupledDynamics::Impl::set_mode(int load, HingeMode mode) {
  Hinge& hinge = hinges[load];
  if (joint_mode(hinge.mode) != joint_mode(mode)) {
    dynamics.set_mode(load, joint_mode(mode));
  }
  hinge.mode = mode;
  hinge.straight = hinge.follows = false;
  hinge.slope.setZero();
  follower.forget(load);
  forget_way();
  last_pause_ = pause_ = 0;
  usual_contraction_ = usual_gain_ = follow_gain_ = 1;
  hinge.utilisation_known = false;
}

void CoupledDynamics::Impl::take_rates(const double* state) {
  rows_.clear();
  for (int i = 0; i < static_cast<int>(hinges.size()); ++i) {
    Hinge& hinge = hinges[i];
    hinge.utilisation_known = false;
    if (!active(hinge)) continue;
    rows_.push_back(i);
    const double* s = state + dynamics.layout().offset(i);
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
    follower.set_rate(i, hinge.rate);
  }
}

void CoupledDynamics::Impl::start(const double* state,
                                  Loading<double>& loading) {
  state_ = state;
  loading_ = &loading;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    if (!active(hinges[i])) hinges[i].moment.setZero();
    loading.loads[i].friction = vec3(hinges[i].moment);
  }
  if (prescribed) {
    dynamics.evaluate_prescribed(state, loading, *prescribed);
  } else {
    dynamics.evaluate(state, loading);
  }
  dynamics.reactions(reactions);
}

void CoupledDynamics::Impl::apply_change() {
  for (const int i : rows_) {
    hinges[i].moment += vec3(change_[i]);
    loading_->loads[i].friction = vec3(hinges[i].moment);
  }
  if (prescribed) {
    dynamics.evaluate_prescribed(state_, *loading_, *prescribed);
  } else {
    dynamics.add_friction(change_);
  }
  dynamics.reactions(reactions);
}

CoupledRounding CoupledDynamics::Impl::noise() const {
  const auto size = [](const Vec3<double>& v) { return std::sqrt(dot(v, v)); };
  const double* w = state_ + StateLayout::angular_velocity;
  double rate = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  double force = size(loading_->carrier.force);
  double moment = size(loading_->carrier.moment);
  double mass = 0;
  double length = 0;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    if (hinge.mode == HingeMode::released) continue;
    const double* s = state_ + dynamics.layout().offset(static_cast<int>(i));
    rate = std::max(
        rate, hinge.is_axis ? std::abs(s[1]) : std::hypot(s[4], s[5], s[6]));
    force += size(loading_->loads[i].force);
    moment += size(loading_->loads[i].moment);
    mass += hinge.mass;
    length = std::max(length, hinge.length);
  }
  if (prescribed) force += mass * size(prescribed->linear);
  // Some tens of operations on each.
  constexpr double rounding = 1e-14;
  const double forces = rounding * (force + mass * length * rate * rate);
  return {forces, rounding * moment + length * forces};
}

double CoupledDynamics::Impl::answer(double floor) {
  double largest = 0;
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    hinge.answer = hinge.solver.slide(reactions[i], hinge.rate);
    hinge.solver_is_behind = false;
    largest = std::max(largest, hinge.answer.norm());
    if (!hinge.answer.allFinite()) report.load = i;
  }
  double residual = 0;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const double miss = (hinge.answer - hinge.moment).norm();
    if (miss == 0) continue;
    // NaN counts as large.
    const double own = miss / (hinge.answer.norm() + hinge.moment.norm() +
                               small_share * largest + floor);
    if (!(own <= residual)) residual = own;
  }
  return residual;
}

void CoupledDynamics::Impl::extrapolate(const double* state) {
  const auto size = static_cast<Eigen::Index>(dynamics.layout().size());
  step_ = Eigen::Map<const Eigen::VectorXd>(state, size) - way_end_;
  if (way_length_ == 0) return;
  // A way of its own, or too far to tell.
  constexpr double straight = 0.99;  // cosine, squared
  constexpr double furthest = 4;
  const double along = step_.dot(way_);
  const double share = along / way_length_;
  if (!(along * along >= straight * step_.squaredNorm() * way_length_) ||
      std::abs(share) > furthest) {
    return;
  }
  follower.extrapolate(share);
  for (const int i : rows_) hinges[i].moment = follower.acting_moment(i);
}

void CoupledDynamics::Impl::remember() {
  // Stages of a step can be where others were; but not many of them.
  constexpr double small = 1e-2;  // squared
  constexpr int many = 4;
  const double square = step_.squaredNorm();
  if (square <= small * way_length_ && ++way_stays_ < many) return;
  way_stays_ = 0;
  way_length_ = way_begun_ ? square : 0;
  way_begun_ = true;
  way_end_ += step_;
  way_.swap(step_);
  follower.remember();
}

void CoupledDynamics::Impl::forget_way() {
  way_end_.setZero(dynamics.layout().size());
  way_begun_ = false;
  way_length_ = 0;
}

// Change of all answers over change of all moments, each in units of its own
// size; and the slopes of those hinges whose own moment changed notably, by
// Broyden's update. The answers of others changed with their neighbours'.
void CoupledDynamics::Impl::learn() {
  double dx = 0;
  double dg = 0;
  double most = 0;
  const auto change = [](const Hinge& hinge) {
    const double size = hinge.answer.squaredNorm();
    return size == 0 ? 0
                     : (hinge.moment - hinge.last_moment).squaredNorm() / size;
  };
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const double own = change(hinge);
    if (own == 0) continue;
    most = std::max(most, own);
    dx += own;
    dg += (hinge.answer - hinge.last_answer).squaredNorm() /
          hinge.answer.squaredNorm();
  }
  constexpr double rounding = 1e-20;  // of squares
  if (!(dx > rounding)) return;
  report.contraction = std::max(report.contraction, std::sqrt(dg / dx));
  usual_contraction_ = std::max(report.contraction, 0.7 * usual_contraction_);
  constexpr double notable = 0.1;  // of squares
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    if (change(hinge) < notable * most) continue;
    const Vector3d by = hinge.moment - hinge.last_moment;
    const Vector3d miss = hinge.answer - hinge.last_answer - hinge.slope * by;
    hinge.slope += miss * by.transpose() / by.squaredNorm();
  }
}

// Newton's step of every hinge for itself with the slope it has.
void CoupledDynamics::Impl::set_steps() {
  constexpr double strong = 0.9;
  constexpr double longest = 3;  // times the plain step
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    const Vector3d miss = hinge.answer - hinge.moment;
    if (hinge.slope.norm() >= strong && report.contraction < strong) {
      hinge.slope.setZero();  // of another time
    }
    Vector3d step = (Matrix3d::Identity() - hinge.slope).inverse() * miss;
    // Too far to trust, or no number: let it crawl; the search follows if it
    // does not arrive.
    if (!(step.norm() <= longest * miss.norm())) step = 0.5 * miss;
    hinge.last_moment = hinge.moment;
    hinge.last_answer = hinge.answer;
    change_[i] = vec3(step);
  }
}

// Moments that fit the reactions they cause if friction is what the follower
// says near its place: every joint for itself, by what it answered before.
// @return what is left, relative; large if it does not contract
double CoupledDynamics::Impl::relax(double enough) {
  constexpr int round_limit = 6;
  constexpr double safety = 2;
  // Of rounding nothing is learnt.
  constexpr double telling = 1e-9;
  // Moments that do not go where they went before answer less well.
  constexpr double usual_share = 0.03;
  double left = 1;
  for (int round = 0; round < round_limit; ++round) {
    if (round > 0) follower.extend();
    const auto [miss, moved, contraction, gain] =
        follower.mismatch(moment_floor_);
    if (round == 0) report.residual = miss;
    if (moved > telling) {
      report.contraction = std::max(report.contraction, contraction);
      usual_contraction_ = std::max(contraction, 0.7 * usual_contraction_);
      // At first the contacts' news is in the miss.
      if (round > 0 || gain < follow_gain_) {
        follow_gain_ = std::max(gain, 0.7 * follow_gain_);
      }
    }
    if (miss <= enough) return miss;
    if (!(miss < 1)) return 1;  // no number, or lost
    follower.act(rows_, change_);
    move();
    left = safety * std::max(follow_gain_, usual_share * usual_contraction_) *
           miss;
    if (left <= enough) return left;
  }
  return left;
}

// What the follower changed: motion and reactions.
void CoupledDynamics::Impl::move() {
  if (prescribed) {
    take_acting_moments();
    dynamics.evaluate_prescribed(state_, *loading_, *prescribed);
  } else {
    dynamics.add_friction(change_);
  }
  dynamics.reactions(reactions);
  follower.set_reactions(rows_, reactions);
}

void CoupledDynamics::Impl::take_acting_moments() {
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    hinge.moment = hinge.answer = follower.acting_moment(i);
    loading_->loads[i].friction = vec3(hinge.moment);
  }
}

// The outer loop with one evaluation of the friction of all hinges for each
// iteration, as long as the follower knows its way.
bool CoupledDynamics::Impl::follow() {
  follower.set_reactions(rows_, reactions);
  double largest = 0;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    follower.set_acting_moment(i, hinge.moment);
    largest = std::max(largest, hinge.moment.squaredNorm());
  }
  moment_floor_ = small_share * std::sqrt(largest);
  const bool found = follow_from_here();
  take_acting_moments();
  return found;
}

// Hinges with contacts to be evaluated a second time.
bool CoupledDynamics::Impl::choose_worse_than(double limit) {
  if (follower.error() < limit) return false;
  for (const int i : rows_) {
    if (!(follower.error(i) < limit)) follower.choose(i);
  }
  return true;
}

bool CoupledDynamics::Impl::follow_from_here() {
  constexpr int iteration_limit = 4;
  // Contacts are evaluated where reactions are as near as this to those found
  // in the end: then slopes, wrong by some percent, do for the rest.
  constexpr double near = 1e-9;
  // Beyond this what is linear in the reactions misses the tolerance.
  constexpr double far = 2e-6;
  // Contacts that are worse than this share of the tolerance are evaluated a
  // second time.
  constexpr double share_of_few = 0.5;
  follower.choose_all();
  const auto predict = [&] {
    follower.predict();
    if (!follower.tracks()) return false;
    // Moments and reactions answer to each other.
    relax(near / std::max(usual_contraction_, 1e-3));
    return true;
  };
  for (report.iterations = 1; report.iterations <= iteration_limit;
       ++report.iterations) {
    if (!predict()) return false;
    if (!(follower.shift() < far) && !predict()) return false;
    follower.evaluate();
    if (choose_worse_than(share_of_few * options.tolerance)) {
      follower.predict();
      follower.evaluate();
    }
    double left = relax(0.1 * options.tolerance);
    if (trace) trace->push_back({report.iterations, report.residual});
    left += follower.error();
    if (left <= options.tolerance) {
      report.residual = left;
      for (const int i : rows_) hinges[i].solver_is_behind = true;
      return true;
    }
  }
  return false;
}

// Following first, where it is likely to work: not again and again where it
// does not. Otherwise, or with what has been reached, the loop below.
void CoupledDynamics::Impl::converge() {
  constexpr double strong = 0.3;  // contraction
  constexpr int longest_pause = 64;
  const bool weak = usual_contraction_ < strong;
  if (weak && pause_ == 0 &&
      follower.count() == static_cast<int>(rows_.size())) {
    if (follow()) {
      remember();
      last_pause_ = 0;
      return;
    }
    pause_ = last_pause_;
    last_pause_ = std::min(2 * last_pause_ + 1, longest_pause);
  } else if (pause_ > 0) {
    --pause_;
  }
  forget_way();
  loop();
  if (!weak || pause_ > 0 || report.status != CoupledStatus::ok) return;
  for (const int i : rows_) {
    follower.start(i, hinges[i].solver, hinges[i].rate);
  }
}

void CoupledDynamics::Impl::loop() {
  // Now and then the gain of a step is looked at, whether it is needed or not.
  constexpr int look_every = 8;
  const bool look = ++loops_ % look_every == 0;
  double last = 0;
  int stalled = 0;
  double floor = 0;
  for (report.iterations = 1;; ++report.iterations) {
    const bool first = report.iterations == 1;
    // Where the loop takes long it may be rounding that it looks at.
    constexpr int patience = 5;
    if (report.iterations == patience) {
      floor = noise().moment / options.tolerance;
    }
    report.residual = answer(floor);
    if (trace) trace->push_back({report.iterations, report.residual});
    if (!std::isfinite(report.residual)) {
      report.status = CoupledStatus::out_of_range;
      return;
    }
    if (report.residual <= options.tolerance) return;
    // Rounding of the reactions can be above the tolerance.
    constexpr double rounding = 1e-8;
    stalled = first || report.residual < 0.5 * last ? 0 : stalled + 1;
    if (stalled >= 2 && report.residual <= rounding) return;
    if (report.iterations >= options.iteration_limit) {
      report.status = CoupledStatus::not_converged;
      return;
    }
    if (!first) {
      learn();
      usual_gain_ = std::max(report.residual / last, 0.7 * usual_gain_);
    }
    set_steps();
    apply_change();
    // What this step leaves, if it gains what steps have gained lately.
    constexpr double safety = 10;
    const double left = safety * usual_gain_ * report.residual;
    if (!(first && look) && left <= options.tolerance) {
      report.residual = left;
      return;
    }
    last = report.residual;
  }
}

// Whether the moments found can be the only ones: kappa < 1.
bool CoupledDynamics::Impl::converged_is_unique() {
  // The friction moment grows about in proportion to R, so that the first
  // number is about kappa; it is looked at closely where one of the two
  // comes near 1.
  constexpr double near_one = 0.5;
  // Too few digits to tell slopes.
  constexpr double few = 1e6;
  const double least = report.contraction < near_one ? 0 : few * noise().moment;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const Vec3<double>& force = reactions[i].force;
    const double moment = hinge.answer.squaredNorm();
    const double rough = hinge.leverage * hinge.leverage * moment;
    if (rough < near_one * near_one * dot(force, force) &&
        report.contraction < near_one) {
      continue;
    }
    if (moment < least * least) continue;
    if (!(kappa(i) < 1)) {
      report.load = i;
      return false;
    }
  }
  return true;
}

const CoupledReport& CoupledDynamics::Impl::evaluate(const double* state,
                                                     Loading<double>& loading) {
  report = {};
  take_rates(state);
  extrapolate(state);
  for (Vec3<double>& change : change_) change = {0, 0, 0};
  start(state, loading);
  if (rows_.empty()) return report;
  converge();
  if (report.status == CoupledStatus::out_of_range) {
    // Not to start from again.
    for (const int i : rows_) hinges[i].moment.setZero();
  } else if (report.status != CoupledStatus::ok || !converged_is_unique()) {
    search();
  }
  return report;
}

CoupledDynamics::Impl::Response CoupledDynamics::Impl::response(int load) {
  Hinge& hinge = hinges[load];
  const double size = std::max(hinge.moment.norm(), 1.0);
  const auto alpha = [&] { return vec3(dynamics.relative_acceleration(load)); };
  const Vector3d alpha0 = alpha();
  const Vector3d force0 = vec3(reactions[load].force);
  const Vector3d moment0 = vec3(reactions[load].moment);
  Response r{Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
  for (int k = hinge.is_axis ? 2 : 0; k < 3; ++k) {
    for (Vec3<double>& change : change_) change = {0, 0, 0};
    const Vector3d change = size * Vector3d::Unit(k);
    change_[load] = vec3(change);
    apply_change();
    r.acceleration.col(k) = (alpha() - alpha0) / size;
    r.force.col(k) = (vec3(reactions[load].force) - force0) / size;
    r.moment.col(k) = (vec3(reactions[load].moment) - moment0) / size;
    change_[load] = vec3(Vector3d(-change));
    apply_change();
  }
  change_[load] = {0, 0, 0};
  return r;
}

std::span<const contact::JointSolution> CoupledDynamics::Impl::joints(
    int load) {
  Hinge& hinge = hinges[load];
  if (hinge.solver_is_behind && active(hinge)) {
    hinge.solver.slide(reactions[load], hinge.rate);
  }
  hinge.solver_is_behind = false;
  return hinge.solver.joints();
}

double CoupledDynamics::Impl::kappa(int load) {
  Hinge& hinge = hinges[load];
  const Response by_moment = response(load);
  const Reaction<double> at = reactions[load];
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

double CoupledDynamics::Impl::utilisation(int load) {
  Hinge& hinge = hinges[load];
  if (!hinge.utilisation_known) {
    // Rounding does not make a hinge slide.
    const CoupledRounding rounding = noise();
    const Reaction<double>& held = reactions[load];
    hinge.utilisation = vec3(held.force).norm() <= rounding.force &&
                                vec3(held.moment).norm() <= rounding.moment
                            ? 0
                            : hinge.solver.utilisation(held);
    hinge.utilisation_known = true;
  }
  return hinge.utilisation;
}

CoupledDynamics::CoupledDynamics(const System& system,
                                 std::vector<HingeFriction> friction,
                                 const CoupledOptions& options)
    : impl_(std::make_unique<Impl>(
          system,
          friction.empty() ? std::vector<HingeFriction>(system.size())
                           : std::move(friction),
          options)) {}
CoupledDynamics::~CoupledDynamics() = default;
CoupledDynamics::CoupledDynamics(CoupledDynamics&&) noexcept = default;
CoupledDynamics& CoupledDynamics::operator=(CoupledDynamics&&) noexcept =
    default;

int CoupledDynamics::size() const { return impl_->dynamics.size(); }
const Dynamics& CoupledDynamics::dynamics() const { return impl_->dynamics; }
const StateLayout& CoupledDynamics::layout() const {
  return impl_->dynamics.layout();
}
HingeMode CoupledDynamics::mode(int load) const {
  return impl_->hinges[load].mode;
}
void CoupledDynamics::set_mode(int load, HingeMode mode) {
  impl_->set_mode(load, mode);
}
bool CoupledDynamics::can_rest(int load) const {
  return impl_->hinges[load].can_rest;
}
bool CoupledDynamics::has_friction(int load) const {
  return impl_->hinges[load].has_friction;
}
void CoupledDynamics::set_direction(int load, const Vector3d& direction) {
  impl_->hinges[load].direction = direction;
}
const Vector3d& CoupledDynamics::direction(int load) const {
  return impl_->hinges[load].direction;
}
void CoupledDynamics::slide_straight(int load, bool straight) {
  impl_->hinges[load].straight = straight;
  impl_->hinges[load].follows = false;
}
bool CoupledDynamics::slides_straight(int load) const {
  return impl_->hinges[load].straight;
}
void CoupledDynamics::follow_acceleration(int load) {
  impl_->hinges[load].straight = impl_->hinges[load].follows = true;
}
void CoupledDynamics::follow_acceleration(int load, double pace) {
  impl_->hinges[load].pace = pace;
  follow_acceleration(load);
}
bool CoupledDynamics::follows_acceleration(int load) const {
  return impl_->hinges[load].follows;
}
double CoupledDynamics::pace(int load) const {
  return impl_->hinges[load].pace;
}
void CoupledDynamics::prescribe_carrier(
    const std::optional<CarrierAcceleration<double>>& carrier) {
  impl_->prescribed = carrier;
}
const CoupledReport& CoupledDynamics::evaluate(const double* state,
                                               Loading<double>& loading) {
  return impl_->any_follows() ? impl_->evaluate_following(state, loading)
                              : impl_->evaluate(state, loading);
}
const CoupledReport& CoupledDynamics::report() const { return impl_->report; }
void CoupledDynamics::set_trace(std::vector<OuterStep>* trace) {
  impl_->trace = trace;
}
const Vector3d& CoupledDynamics::friction_moment(int load) const {
  return impl_->hinges[load].moment;
}
void CoupledDynamics::set_friction_moment(int load, const Vector3d& moment) {
  impl_->hinges[load].moment = moment;
  impl_->forget_way();
}
const Reaction<double>& CoupledDynamics::reaction(int load) const {
  return impl_->reactions[load];
}
double CoupledDynamics::utilisation(int load) {
  return impl_->utilisation(load);
}
double CoupledDynamics::slip_limit(int load) const {
  return impl_->slip_limit(load);
}
std::span<const contact::JointSolution> CoupledDynamics::joints(
    int load) const {
  return impl_->joints(load);
}
std::span<const CoupledSolution> CoupledDynamics::solutions() const {
  return impl_->solutions;
}
bool CoupledDynamics::stops_within(int load, const Vector3d& rate,
                                   double step) {
  const Impl::Felt felt = impl_->felt(load);
  return impl_->hinges[load]
      .solver.prox(felt.inertia, rate / step + felt.free)
      .isZero(0);
}
CoupledRounding CoupledDynamics::rounding() const { return impl_->noise(); }
double CoupledDynamics::kappa(int load) { return impl_->kappa(load); }
const CoupledReport& CoupledDynamics::resolve_rest(const double* state,
                                                   Loading<double>& loading,
                                                   int forced) {
  return impl_->resolve_rest(state, loading, forced);
}

}  // namespace multibody
