// The outer loop of CoupledDynamics: friction moments and reactions brought
// into agreement, by the joints followed or by their solvers.

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

double CoupledDynamics::Impl::answer(double floor) {
  double largest = 0;
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    hinge.answer = hinge.solver.slide(reaction(i), hinge.rate);
    hinge.solver_is_behind = false;
    largest = std::max(largest, hinge.answer.norm());
    if (!hinge.answer.allFinite()) report.body = i;
  }
  double residual = 0;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const double miss = (hinge.answer - hinge.moment).norm();
    if (miss == 0) continue;
    const double own = miss / (hinge.answer.norm() + hinge.moment.norm() +
                               small_share * largest + floor);
    // NaN stays, whatever follows.
    if (!(own <= residual) && !std::isnan(residual)) residual = own;
  }
  return residual;
}

// The state less the end of the way: in step_, step_square_.
// @return its product with the way
double CoupledDynamics::Impl::take_step(const double* state) {
  // All in one go over the numbers.
  using Chunk = Eigen::Array4d;
  constexpr Eigen::Index width = 4;
  Chunk squares = Chunk::Zero();
  Chunk products = Chunk::Zero();
  const Eigen::Index size = way_end_.size();
  Eigen::Index i = 0;
  for (; i + width <= size; i += width) {
    const Chunk d = Eigen::Map<const Chunk>(state + i) -
                    Eigen::Map<const Chunk>(way_end_.data() + i);
    Eigen::Map<Chunk>(step_.data() + i) = d;
    squares += d * d;
    products += d * Eigen::Map<const Chunk>(way_.data() + i);
  }
  step_square_ = squares.sum();
  double product = products.sum();
  for (; i < size; ++i) {
    const double d = state[i] - way_end_[i];
    step_[i] = d;
    step_square_ += d * d;
    product += d * way_[i];
  }
  return product;
}

void CoupledDynamics::Impl::extrapolate(const double* state) {
  const double along = take_step(state);
  if (way_length_ == 0) return;
  // A way of its own, or too far to tell.
  constexpr double straight = 0.99;  // cosine, squared
  constexpr double furthest = 4;
  const double share = along / way_length_;
  if (!(along * along >= straight * step_square_ * way_length_) ||
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
  const double square = step_square_;
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
  way_.setZero(way_end_.size());
  step_ = way_;
  way_begun_ = false;
  way_length_ = 0;
  forget_acting();
}

void CoupledDynamics::Impl::forget_acting() {
  acting_known_ = false;
  largest_leverage_ = std::numeric_limits<double>::infinity();
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
  const contact::JointFollower::Largest& found = follower.largest();
  for (int round = 0; round < round_limit; ++round) {
    if (round > 0) follower.extend();
    const double miss = found.miss;
    if (round == 0) report.residual = miss;
    if (found.moved > telling) {
      report.contraction = std::max(report.contraction, found.contraction);
      usual_contraction_ =
          std::max(found.contraction, 0.7 * usual_contraction_);
      // At first the contacts' news is in the miss.
      if (round > 0 || found.gain < follow_gain_) {
        follow_gain_ = std::max(found.gain, 0.7 * follow_gain_);
      }
    }
    if (miss <= enough) return miss;
    if (!(miss < 1)) return 1;  // no number, or lost
    follower.act();
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
    dynamics.evaluate_prescribed(state_, *forces_, *prescribed);
  } else {
    follower.move(dynamics, rows_, change_);
  }
  take_reactions();
}

void CoupledDynamics::Impl::take_reactions() {
  follower.take_reactions(dynamics, rows_, reactions_);
  reactions_known_ = !follower.is_direct();
}

void CoupledDynamics::Impl::take_acting_moments() {
  constexpr double large = std::numeric_limits<double>::infinity();  // for NaN
  largest_acting_ = largest_leverage_ = 0;
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
    const Vector3d moment = follower.acting_moment(i);
    hinge.moment = hinge.answer = moment;
    forces_->bodies[i].friction = vec3(moment);
    const double square = moment.squaredNorm();
    const double bound = hinge.leverage * hinge.leverage * square;
    const Vec3<double> force =
        follower.is_direct() ? follower.force(i) : reaction(i).force;
    largest_acting_ = std::max(largest_acting_, square);
    const double share = bound / dot(force, force);
    largest_leverage_ = std::max(largest_leverage_, share >= 0 ? share : large);
  }
  acting_known_ = true;
}

// The outer loop with one evaluation of the friction of all hinges for each
// iteration, as long as the follower knows its way.
bool CoupledDynamics::Impl::follow() {
  take_reactions();
  if (!acting_known_) {
    largest_acting_ = 0;
    for (const int i : rows_) {
      const Vector3d& moment = hinges[i].moment;
      follower.set_acting_moment(i, moment);
      largest_acting_ = std::max(largest_acting_, moment.squaredNorm());
    }
  }
  // Half of what small moments count.
  follower.set_moment_floor(small_share * std::sqrt(largest_acting_));
  const bool found = follow_from_here();
  take_acting_moments();
  return found;
}

// @return whether all hinges are where it knows its way
bool CoupledDynamics::Impl::predict() {
  // Contacts are evaluated where reactions are as near as this to those found
  // in the end: then slopes, wrong by some percent, do for the rest.
  constexpr double near = 1e-9;
  follower.predict();
  if (!follower.largest().tracks) return false;
  // Moments and reactions answer to each other.
  relax(near / std::max(usual_contraction_, 1e-3));
  return true;
}

bool CoupledDynamics::Impl::follow_from_here() {
  constexpr int iteration_limit = 4;
  // Beyond this what is linear in the reactions misses the tolerance.
  constexpr double far = 2e-6;
  // Contacts that are worse than this share of the tolerance are evaluated a
  // second time.
  constexpr double share_of_few = 0.5;
  follower.choose_all();
  for (report.iterations = 1; report.iterations <= iteration_limit;
       ++report.iterations) {
    if (!predict()) return false;
    if (!(follower.largest().shift < far) && !predict()) return false;
    follower.evaluate();
    const double few = share_of_few * options.tolerance;
    if (!(follower.largest().error <= few)) {
      follower.choose_worse_than(few);
      follower.predict();
      follower.evaluate();
    }
    double left = relax(0.1 * options.tolerance);
    if (trace) trace->push_back({report.iterations, report.residual});
    left += follower.largest().error;
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

}  // namespace multibody
