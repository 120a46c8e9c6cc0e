#include "multibody/friction/tracked_loop.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "multibody/friction/hinges.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {
namespace {

using Eigen::Vector3d;

using contact::detail::infinity;

}  // namespace

void TrackedLoop::extrapolate(Hinges& hinges) {
  for (const int i : hinges.active()) {
    tracker_.set_rate(i, hinges.now(i).rate);
  }
  const std::vector<double>& numbers = hinges.evaluation().state;
  const Eigen::Map<const Eigen::VectorXd> state(
      numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  if (path_end_.size() != state.size()) path_end_.setZero(state.size());
  step_ = state - path_end_;
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
  tracker_.joints().extrapolate(share);
  for (const int i : hinges.active()) {
    hinges.memory(i).moment = tracker_.applied_moment(i);
  }
}

// Call after track().
void TrackedLoop::keep() {
  if (step_square_ == 0) return;
  path_end_ += step_;
  path_.swap(step_);
  path_square_ = step_square_;
  ++kept_;
  tracker_.joints().keep();
}

void TrackedLoop::forget_path() {
  path_end_.setZero();
  kept_ = 0;
  applied_known_ = false;
}

double TrackedLoop::largest_leverage() const {
  return applied_known_ ? largest_leverage_ : infinity;
}

void TrackedLoop::stop(int body) {
  tracker_.stop(body);
  forget_path();
  last_pause_ = pause_ = 0;
  usual_contraction_ = 1;
}

void TrackedLoop::learn_contraction(double contraction) {
  usual_contraction_ = std::max(contraction, 0.7 * usual_contraction_);
}

// Learns from the residual of the last step of relax().
void TrackedLoop::learn_step(CoupledReport& report, double residual) {
  // Steps below this are dominated by rounding, whatever the contraction.
  constexpr double telling = 1e-9;
  if (!(last_residual_ > telling)) return;
  const double contraction = residual / last_residual_;
  report.contraction = std::max(report.contraction, contraction);
  learn_contraction(contraction);
}

// Finds moments consistent with their reactions by simple iteration, with
// friction predicted by the tracker near its last contacts.
// @return relative residual; large if the iteration does not contract
double TrackedLoop::relax(Hinges& hinges, double enough) {
  // Groups, whose rounds contract by 0.01, iterate to 1e-12; slower
  // contractions use a new prediction.
  constexpr int round_limit = 6;
  // Contraction varies from round to round.
  constexpr double safety = 2;
  // Ten times the moment applied; 0.5 would be infinity.
  constexpr double lost = 0.45;
  double left = 1;
  JointTracker& joints = tracker_.joints();
  const JointTracker::Largest& found = joints.largest();
  for (int round = 0; round < round_limit; ++round) {
    if (round > 0) {
      joints.extend();
      learn_step(hinges.report(), found.residual);
    } else {
      hinges.report().residual = found.residual;
    }
    if (found.residual <= enough) return found.residual;
    if (!(found.residual < lost)) return 1;
    last_residual_ = found.residual;
    joints.apply();
    if (hinges.is_prescribed()) take_applied_moments(hinges);
    hinges.move(tracker_);
    left = safety * usual_contraction_ * last_residual_;
    if (left <= enough) return left;
  }
  return left;
}

void TrackedLoop::take_applied_moments(Hinges& hinges) {
  largest_applied_ = largest_leverage_ = 0;
  for (const int i : hinges.active()) {
    const Vector3d moment = tracker_.applied_moment(i);
    hinges.take_moment(i, moment);
    const double square = moment.squaredNorm();
    const double leverage = hinges[i].leverage;
    const double bound = leverage * leverage * square;
    const Vec3<double> force = tracker_.force(i);
    largest_applied_ = std::max(largest_applied_, square);
    const double share = bound / dot(force, force);
    largest_leverage_ =
        std::max(largest_leverage_, share >= 0 ? share : infinity);
  }
  applied_known_ = true;
}

// The outer loop with one evaluation of the friction of all hinges in each
// iteration, as long as the tracker is trusted.
bool TrackedLoop::track(Hinges& hinges) {
  hinges.give_reactions(tracker_);
  if (!applied_known_) {
    largest_applied_ = 0;
    for (const int i : hinges.active()) {
      const Vector3d& moment = hinges.memory(i).moment;
      tracker_.set_applied_moment(i, moment);
      largest_applied_ = std::max(largest_applied_, moment.squaredNorm());
    }
  }
  // Half of the least scale of moments.
  tracker_.joints().set_moment_floor(Hinges::small_share *
                                     std::sqrt(largest_applied_));
  const bool found = track_joints(hinges);
  take_applied_moments(hinges);
  return found;
}

// Joints that moved too far from their last contact are solved where they are
// now, if they are few: in a long chain the last bodies whip.
bool TrackedLoop::restart(Hinges& hinges) {
  const std::vector<int>& active = hinges.active();
  const auto is_lost = [&](int i) { return !tracker_.is_trusted(i); };
  if (4 * std::ranges::count_if(active, is_lost) >
      static_cast<int>(active.size())) {
    return false;
  }
  for (const int i : active) {
    if (!is_lost(i)) continue;
    const Vector3d applied = tracker_.applied_moment(i);
    hinges.now(i).solver_is_behind = true;
    hinges.joints(i);
    tracker_.start(i, hinges[i].solver, hinges.memory(i).solver,
                   hinges.now(i).rate);
    tracker_.set_applied_moment(i, applied);
    if (!tracker_.is_tracked(i)) return false;
  }
  tracker_.joints().predict();
  return tracker_.joints().largest().is_trusted();
}

bool TrackedLoop::track_joints(Hinges& hinges) {
  constexpr int iteration_limit = 4;
  // Contacts are evaluated when moments are this near to the final ones, and
  // reactions nearer; slopes with errors of some percent then suffice for the
  // rest.
  constexpr double near = 1e-7;
  JointTracker& joints = tracker_.joints();
  const JointTracker::Largest& found = joints.largest();
  CoupledProgress& report = hinges.report();
  for (report.iterations = 1; report.iterations <= iteration_limit;
       ++report.iterations) {
    // The first prediction covers all joints, later ones those with a large
    // error.
    joints.predict(report.iterations == 1 ? -1 : 0.5 * tolerance_);
    last_residual_ = 0;
    if (!found.is_trusted() && !restart(hinges)) return false;
    relax(hinges, near);
    joints.correct();
    learn_step(report, found.uncorrected);
    double left = relax(hinges, 0.1 * tolerance_);
    report.add_step();
    left += found.error;
    if (left <= tolerance_) {
      report.residual = left;
      for (const int i : hinges.active()) {
        hinges.now(i).solver_is_behind = true;
      }
      return true;
    }
  }
  return false;
}

// Tracking pauses after a failure instead of being retried at once.
bool TrackedLoop::converge(Hinges& hinges) {
  constexpr double strong = 0.3;  // contraction
  constexpr int longest_pause = 64;
  is_weak_ = usual_contraction_ < strong;
  if (is_weak_ && pause_ == 0 &&
      tracker_.count() == static_cast<int>(hinges.active().size())) {
    if (track(hinges)) {
      keep();
      last_pause_ = 0;
      return true;
    }
    pause_ = last_pause_;
    last_pause_ = std::min(2 * last_pause_ + 1, longest_pause);
  } else if (pause_ > 0) {
    --pause_;
  }
  forget_path();
  return false;
}

void TrackedLoop::start(const Hinges& hinges) {
  if (!is_weak_ || pause_ > 0) return;
  for (const int i : hinges.active()) {
    tracker_.start(i, hinges[i].solver, hinges.memory(i).solver,
                   hinges.now(i).rate);
  }
}

}  // namespace multibody
