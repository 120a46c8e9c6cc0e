// The outer loop of CoupledDynamics: friction moments and reactions brought
// into agreement, by the joints tracked or by their solvers.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multibody/friction/coupled_impl.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A part of this size of the largest moment in the system counts as scale of
// every hinge's moment: smaller ones vanish in the rounding of the reactions.
constexpr double small_share = 1e-3;

}  // namespace

double CoupledDynamics::Impl::solve_hinges(double floor) {
  double largest = 0;
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    hinge.solved = hinge.solver.slide(reaction(i), hinge.rate);
    hinge.solver_is_behind = false;
    largest = std::max(largest, hinge.solved.norm());
    if (!hinge.solved.allFinite()) report.body = i;
  }
  double residual = 0;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const double difference = (hinge.solved - hinge.moment).norm();
    if (difference == 0) continue;
    const double own = difference / (hinge.solved.norm() + hinge.moment.norm() +
                                     small_share * largest + floor);
    // NaN stays, whatever follows.
    if (!(own <= residual) && !std::isnan(residual)) residual = own;
  }
  return residual;
}

// Where the state goes on in the direction of its last move, moments do too.
void CoupledDynamics::Impl::extrapolate(const double* state) {
  step_ =
      Eigen::Map<const Eigen::VectorXd>(state, path_end_.size()) - path_end_;
  step_square_ = step_.squaredNorm();
  if (kept_ < 2) return;
  // More than 6 deg off (cosine, squared), or too far to tell.
  constexpr double straight = 0.99;
  constexpr double furthest = 4;
  const double along = step_.dot(path_);
  const double share = along / path_square_;
  if (!(share * along >= straight * step_square_) ||
      std::abs(share) > furthest) {
    return;
  }
  tracker.joints().extrapolate(share);
  for (const int i : rows_) hinges[i].moment = tracker.applied_moment(i);
}

// After track().
void CoupledDynamics::Impl::keep() {
  if (step_square_ == 0) return;
  path_end_ += step_;
  path_.swap(step_);
  path_square_ = step_square_;
  ++kept_;
  tracker.joints().keep();
}

void CoupledDynamics::Impl::forget_path() {
  path_end_.setZero(dynamics.layout().size());
  path_ = step_ = path_end_;
  kept_ = 0;
  forget_applied();
}

void CoupledDynamics::Impl::forget_applied() {
  applied_known_ = false;
  largest_leverage_ = std::numeric_limits<double>::infinity();
}

// Change of what was solved over that of all moments, each in units of its own
// size; and the slopes of those hinges whose own moment changed notably, by
// Broyden's update. Others changed with their neighbours.
void CoupledDynamics::Impl::update_slopes() {
  double dx = 0;
  double dg = 0;
  double most = 0;
  const auto change = [](const Hinge& hinge) {
    const double size = hinge.solved.squaredNorm();
    return size == 0 ? 0
                     : (hinge.moment - hinge.last_moment).squaredNorm() / size;
  };
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const double own = change(hinge);
    if (own == 0) continue;
    most = std::max(most, own);
    dx += own;
    dg += (hinge.solved - hinge.last_solved).squaredNorm() /
          hinge.solved.squaredNorm();
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
    const Vector3d residual =
        hinge.solved - hinge.last_solved - hinge.slope * by;
    hinge.slope += residual * by.transpose() / by.squaredNorm();
  }
}

// Newton's step of every hinge for itself with the slope it has.
void CoupledDynamics::Impl::set_steps() {
  constexpr double strong = 0.9;
  constexpr double longest = 3;  // times the plain step
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    const Vector3d residual = hinge.solved - hinge.moment;
    if (hinge.slope.norm() >= strong && report.contraction < strong) {
      hinge.slope.setZero();  // of another time
    }
    Vector3d step = (Matrix3d::Identity() - hinge.slope).inverse() * residual;
    // Too far to trust, or no number: let it crawl; the search follows if it
    // does not arrive.
    if (!(step.norm() <= longest * residual.norm())) step = 0.5 * residual;
    hinge.last_moment = hinge.moment;
    hinge.last_solved = hinge.solved;
    change_[i] = vec3(step);
  }
}

// From what the last step of relax() has left.
void CoupledDynamics::Impl::learn_contraction(double residual) {
  // Of smaller steps rounding is left, whatever the contraction.
  constexpr double telling = 1e-9;
  if (!(last_residual_ > telling)) return;
  const double contraction = residual / last_residual_;
  report.contraction = std::max(report.contraction, contraction);
  usual_contraction_ = std::max(contraction, 0.7 * usual_contraction_);
}

// Moments that fit the reactions they cause if friction is as the tracker
// predicts near its last contacts, by simple iteration.
// @return what is left, relative; large if it does not contract
double CoupledDynamics::Impl::relax(double enough) {
  // In nodes, where rounds contract by 0.01, to 1e-12; what contracts less is
  // predicted again.
  constexpr int round_limit = 6;
  // Contractions differ from round to round.
  constexpr double safety = 2;
  // Ten times the moment applied; 0.5 would be infinity.
  constexpr double lost = 0.45;
  double left = 1;
  contact::JointTracker& joints = tracker.joints();
  const contact::JointTracker::Largest& found = joints.largest();
  for (int round = 0; round < round_limit; ++round) {
    if (round > 0) {
      joints.extend();
      learn_contraction(found.residual);
    } else {
      report.residual = found.residual;
    }
    if (found.residual <= enough) return found.residual;
    if (!(found.residual < lost)) return 1;
    last_residual_ = found.residual;
    joints.apply();
    move();
    left = safety * usual_contraction_ * last_residual_;
    if (left <= enough) return left;
  }
  return left;
}

// What the tracker changed: motion and reactions.
void CoupledDynamics::Impl::move() {
  if (prescribed) {
    take_applied_moments();
    dynamics.evaluate_prescribed(state_, *forces_, *prescribed);
  } else {
    tracker.move(dynamics, rows_, change_);
  }
  take_reactions();
}

void CoupledDynamics::Impl::take_reactions() {
  tracker.take_reactions(dynamics, rows_, reactions_);
  reactions_known_ = !tracker.is_direct();
}

void CoupledDynamics::Impl::take_applied_moments() {
  constexpr double large = std::numeric_limits<double>::infinity();  // for NaN
  largest_applied_ = largest_leverage_ = 0;
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    const Vector3d moment = tracker.applied_moment(i);
    hinge.moment = hinge.solved = moment;
    forces_->bodies[i].friction = vec3(moment);
    const double square = moment.squaredNorm();
    const double bound = hinge.leverage * hinge.leverage * square;
    const Vec3<double> force =
        tracker.is_direct() ? tracker.force(i) : reaction(i).force;
    largest_applied_ = std::max(largest_applied_, square);
    const double share = bound / dot(force, force);
    largest_leverage_ = std::max(largest_leverage_, share >= 0 ? share : large);
  }
  applied_known_ = true;
}

// The outer loop with one evaluation of the friction of all hinges for each
// iteration, as long as the tracker can be trusted.
bool CoupledDynamics::Impl::track() {
  take_reactions();
  if (!applied_known_) {
    largest_applied_ = 0;
    for (const int i : rows_) {
      const Vector3d& moment = hinges[i].moment;
      tracker.set_applied_moment(i, moment);
      largest_applied_ = std::max(largest_applied_, moment.squaredNorm());
    }
  }
  // Half of what small moments count.
  tracker.joints().set_moment_floor(small_share * std::sqrt(largest_applied_));
  const bool found = track_joints();
  take_applied_moments();
  return found;
}

bool CoupledDynamics::Impl::track_joints() {
  constexpr int iteration_limit = 4;
  // Contacts are evaluated where moments are as near as this to those found in
  // the end, and reactions nearer: then slopes, wrong by some percent, do for
  // the rest.
  constexpr double near = 1e-7;
  contact::JointTracker& joints = tracker.joints();
  const contact::JointTracker::Largest& found = joints.largest();
  for (report.iterations = 1; report.iterations <= iteration_limit;
       ++report.iterations) {
    joints.predict();
    last_residual_ = 0;
    if (!found.is_trusted()) return false;
    relax(near);
    joints.correct();
    learn_contraction(found.uncorrected);
    double left = relax(0.1 * options.tolerance);
    if (trace) trace->push_back({report.iterations, report.residual});
    left += found.error;
    if (left <= options.tolerance) {
      report.residual = left;
      for (const int i : rows_) hinges[i].solver_is_behind = true;
      return true;
    }
  }
  return false;
}

// Tracking first, where it is likely to work: not again and again where it
// does not. Otherwise, or with what has been reached, the loop below.
void CoupledDynamics::Impl::converge() {
  constexpr double strong = 0.3;  // contraction
  constexpr int longest_pause = 64;
  const bool weak = usual_contraction_ < strong;
  if (weak && pause_ == 0 &&
      tracker.count() == static_cast<int>(rows_.size())) {
    if (track()) {
      keep();
      last_pause_ = 0;
      return;
    }
    pause_ = last_pause_;
    last_pause_ = std::min(2 * last_pause_ + 1, longest_pause);
  } else if (pause_ > 0) {
    --pause_;
  }
  forget_path();
  loop();
  if (!weak || pause_ > 0 || report.status != CoupledStatus::ok) return;
  for (const int i : rows_) {
    tracker.start(i, hinges[i].solver, hinges[i].rate);
  }
}

void CoupledDynamics::Impl::loop() {
  // Now and then what a step leaves is looked at, whether it is needed or not.
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
    report.residual = solve_hinges(floor);
    if (trace) trace->push_back({report.iterations, report.residual});
    if (!std::isfinite(report.residual)) {
      report.status = CoupledStatus::out_of_range;
      if (report.body >= 0) fail_at(report.body);
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
      update_slopes();
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

}  // namespace multibody
