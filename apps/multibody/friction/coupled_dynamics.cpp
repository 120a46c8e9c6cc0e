#include "multibody/friction/coupled_dynamics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "multibody/friction/search.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Matrix3d;
using Eigen::Vector3d;

CoupledDynamics::CoupledDynamics(const System& system,
                                 const std::vector<HingeFriction>& friction,
                                 const CoupledOptions& options)
    : hinges_(std::make_unique<Hinges>(system, friction)),
      options_(options),
      tracked_(*hinges_, friction, options) {}

void CoupledDynamics::set_mode(int body, HingeMode mode) {
  hinges_->set_mode(body, mode);
  tracked_.stop(body);
  usual_gain_ = 1;
}

double CoupledDynamics::utilisation(int body) {
  const double tau = hinges_->utilisation(body);
  // Above what the tolerance leaves uncertain of tau, also beside friction that
  // is much larger.
  const double near = 1e4 * (slip_limit(body) - 1);
  if (!(std::abs(tau - 1) < near)) return tau;
  refine();
  return hinges_->utilisation(body);
}

double CoupledDynamics::slip_limit(int body) {
  const double threshold = hinge(body).is_axis ? options_.slip_threshold
                                               : options_.ball_slip_threshold;
  const double held = vec3(reaction(body).moment).norm();
  const double share =
      hinges_->uncertain_moment() * hinges_->utilisation(body) / held;
  // Where next to nothing is held, as without a body, it is infinite.
  constexpr double most = 1e-3;
  return 1 + (share > threshold ? std::min(share, most) : threshold);
}

const CoupledReport& CoupledDynamics::find_friction(
    const double* state, ActiveForces<double>& forces) {
  report_.start();
  solutions_.clear();
  is_refined_ = false;
  hinges_->set_state(state);
  tracked_.extrapolate(state);
  hinges_->start(forces);
  if (hinges_->active().empty()) return report_;
  if (!tracked_.converge(report_)) {
    solve(options_.tolerance);
    if (report_.status == CoupledStatus::ok) tracked_.start();
  }
  if (report_.status == CoupledStatus::out_of_range ||
      report_.status == CoupledStatus::no_contact) {
    // Not to start from again.
    for (const int i : hinges_->active()) at(i).moment.setZero();
  } else if (report_.status != CoupledStatus::ok || !is_unique()) {
    solutions_ = search(*hinges_, report_);
  }
  return report_;
}

// Brings the friction of the last evaluation to refined_tolerance. Where a
// hinge begins to slide its acceleration is as small as the threshold, and the
// usual tolerance is no smaller: which way it goes has to be known better.
// (What a search has found is that good.)
void CoupledDynamics::refine() {
  if (is_refined_ || hinges_->active().empty() || !solutions_.empty()) return;
  is_refined_ = true;
  const double usual_gain = usual_gain_;
  const int iterations = report_.iterations;
  solve(Hinges::refined_tolerance);
  report_.iterations += iterations;
  usual_gain_ = usual_gain;
  if (report_.status == CoupledStatus::not_converged) {
    solutions_ = search(*hinges_, report_);
  }
}

// Whether the moments found can be the only ones: kappa < 1.
bool CoupledDynamics::is_unique() {
  // The friction moment grows about in proportion to R, so that the first
  // number is about kappa; it is looked at closely where one of the two
  // comes near 1.
  constexpr double near_one = 0.5;
  // Too few digits to tell slopes.
  constexpr double few = 1e6;
  if (report_.contraction < near_one &&
      tracked_.largest_leverage() < near_one * near_one) {
    return true;
  }
  const double least =
      report_.contraction < near_one ? 0 : few * hinges_->rounding().moment;
  for (const int i : hinges_->active()) {
    const Hinge& hinge = at(i);
    const Vec3<double>& force = hinges_->reaction(i).force;
    const double moment = hinge.solved.squaredNorm();
    const double rough = hinge.leverage * hinge.leverage * moment;
    if (rough < near_one * near_one * dot(force, force) &&
        report_.contraction < near_one) {
      continue;
    }
    if (moment < least * least) continue;
    if (!(hinges_->kappa(i) < 1)) {
      report_.body = i;
      return false;
    }
  }
  return true;
}

void CoupledDynamics::fail_at(int body) {
  const HingeSolver& solver = hinge(body).solver;
  const int joint = solver.failed_joint();
  const double force = solver.joints()[joint].reaction.norm();
  report_.body = body;
  report_.status = CoupledStatus::out_of_range;
  if (!std::isfinite(force)) return;
  report_.status = CoupledStatus::no_contact;
  report_.joint = joint;
  report_.force = force;
}

// Change of what was solved over that of all moments, each in units of its own
// size; and the slopes of those hinges whose own moment changed notably, by
// Broyden's update. Others changed with their neighbours.
void CoupledDynamics::update_slopes() {
  double dx = 0;
  double dg = 0;
  double most = 0;
  const auto change = [](const Hinge& hinge) {
    const double size = hinge.solved.squaredNorm();
    return size == 0 ? 0
                     : (hinge.moment - hinge.last_moment).squaredNorm() / size;
  };
  for (const int i : hinges_->active()) {
    const Hinge& hinge = at(i);
    const double own = change(hinge);
    if (own == 0) continue;
    most = std::max(most, own);
    dx += own;
    dg += (hinge.solved - hinge.last_solved).squaredNorm() /
          hinge.solved.squaredNorm();
  }
  constexpr double rounding = 1e-20;  // of squares
  if (!(dx > rounding)) return;
  report_.contraction = std::max(report_.contraction, std::sqrt(dg / dx));
  tracked_.learn_contraction(report_.contraction);
  constexpr double notable = 0.1;  // of squares
  for (const int i : hinges_->active()) {
    Hinge& hinge = at(i);
    if (change(hinge) < notable * most) continue;
    const Vector3d by = hinge.moment - hinge.last_moment;
    const Vector3d residual =
        hinge.solved - hinge.last_solved - hinge.slope * by;
    hinge.slope += residual * by.transpose() / by.squaredNorm();
  }
}

// Newton's step of every hinge for itself with the slope it has.
void CoupledDynamics::set_steps() {
  constexpr double strong = 0.9;
  constexpr double longest = 3;  // times the plain step
  for (const int i : hinges_->active()) {
    Hinge& hinge = at(i);
    const Vector3d residual = hinge.solved - hinge.moment;
    if (hinge.slope.norm() >= strong && report_.contraction < strong) {
      hinge.slope.setZero();  // of another time
    }
    Vector3d step = (Matrix3d::Identity() - hinge.slope).inverse() * residual;
    // Too far to trust, or no number: let it crawl; the search follows if it
    // does not arrive.
    if (!(step.norm() <= longest * residual.norm())) step = 0.5 * residual;
    hinge.last_moment = hinge.moment;
    hinge.last_solved = hinge.solved;
    hinges_->change(i) = vec3(step);
  }
}

void CoupledDynamics::solve(double tolerance) {
  // Now and then what a step leaves is looked at, whether it is needed or not.
  constexpr int look_every = 8;
  const bool look = ++loops_ % look_every == 0;
  double last = 0;
  int stalled = 0;
  double floor = 0;
  for (report_.iterations = 1;; ++report_.iterations) {
    const bool first = report_.iterations == 1;
    // Where the loop takes long it may be rounding that it looks at.
    constexpr int patience = 5;
    if (report_.iterations == patience) {
      floor = hinges_->rounding().moment / tolerance;
    }
    report_.residual = hinges_->solve(floor);
    report_.add_step();
    if (!std::isfinite(report_.residual)) {
      report_.status = CoupledStatus::out_of_range;
      const std::vector<int>& active = hinges_->active();
      const auto lost =
          std::find_if(active.rbegin(), active.rend(),
                       [&](int i) { return !at(i).solved.allFinite(); });
      if (lost != active.rend()) fail_at(*lost);
      return;
    }
    if (report_.residual <= tolerance) return;
    // Rounding of the reactions can be above the tolerance.
    constexpr double rounding = 1e-8;
    stalled = first || report_.residual < 0.5 * last ? 0 : stalled + 1;
    if (stalled >= 2 && report_.residual <= rounding) return;
    if (report_.iterations >= options_.iteration_limit) {
      report_.status = CoupledStatus::not_converged;
      return;
    }
    if (!first) {
      update_slopes();
      usual_gain_ = std::max(report_.residual / last, 0.7 * usual_gain_);
    }
    set_steps();
    hinges_->apply_changes();
    // What this step leaves, if it gains what steps have gained lately.
    constexpr double safety = 10;
    const double left = safety * usual_gain_ * report_.residual;
    if (!(first && look) && left <= tolerance) {
      report_.residual = left;
      return;
    }
    last = report_.residual;
  }
}

bool CoupledDynamics::stops_within(int body, const Vector3d& rate,
                                   double step) {
  const Hinges::Felt felt = hinges_->felt(body);
  return hinge(body)
      .solver.prox(felt.inertia, rate / step + felt.free)
      .isZero(0);
}

SlipDirections CoupledDynamics::directions(const double* state,
                                           ActiveForces<double>& forces,
                                           std::vector<Onset> balls) {
  return {*hinges_, forces,
          [=, this, &forces] {
            return find_friction(state, forces).status == CoupledStatus::ok;
          },
          std::move(balls)};
}

const CoupledReport& CoupledDynamics::follow(const double* state,
                                             ActiveForces<double>& forces) {
  std::vector<Onset> balls;
  for (int i = 0; i < size(); ++i) {
    if (hinge(i).follows) balls.push_back({i});
  }
  SlipDirections slip = directions(state, forces, balls);
  const std::vector<Vector3d> before = slip.get();
  if (slip.settle()) return report_;
  slip.set(before);
  if (report_.status == CoupledStatus::ok) {
    report_.status = CoupledStatus::not_converged;
    report_.body = balls.front().body;
  }
  return report_;
}

const CoupledReport& CoupledDynamics::evaluate(const double* state,
                                               ActiveForces<double>& forces) {
  if (hinges_->any_follows()) {
    follow(state, forces);
  } else {
    find_friction(state, forces);
  }
  if (report_.status == CoupledStatus::ok && hinges_->any_gets_under_way()) {
    refine();
  }
  return report_;
}

// Of those ball joints that have begun to slide.
bool CoupledDynamics::find_directions(const double* state,
                                      ActiveForces<double>& forces,
                                      const std::vector<Onset>& begun) {
  std::vector<Onset> balls;
  std::ranges::copy_if(
      begun, std::back_inserter(balls),
      [&](const Onset& onset) { return !hinge(onset.body).is_axis; });
  if (balls.empty() || directions(state, forces, balls).find()) return true;
  if (report_.status == CoupledStatus::ok) {
    report_.status = CoupledStatus::not_converged;
  }
  report_.body = balls.front().body;
  return false;
}

// Lets a resting hinge go.
Onset CoupledDynamics::begin_to_slide(int body) {
  Onset onset{body};
  const double tau = utilisation(body);
  if (tau > 1) onset.excess = (1 - 1 / tau) * vec3(reaction(body).moment);
  const Vector3d& direction = hinge(body).solver.slip_direction();
  if (!direction.isZero(0)) onset.direction = direction;
  set_direction(body, onset.direction);
  set_mode(body, HingeMode::sliding);
  return onset;
}

// The resting hinge that is furthest beyond what it can hold. -1: none is;
// or report_ says that one has no contact.
int CoupledDynamics::worst_resting(bool due) {
  // Half of the threshold: what the motion found on its way is above all of
  // it, but for the error of dense output. Where that is larger the hinge goes
  // on resting, and is looked at again from here. Hinges that are due at one
  // instant, as those of bodies that mirror each other, are so together.
  const double share = due ? 0.5 : 1;
  int worst = -1;
  double most = 1;
  for (int i = 0; i < size(); ++i) {
    if (mode(i) != HingeMode::resting) continue;
    const double tau = utilisation(i);
    if (std::isnan(tau)) {
      fail_at(i);
      return -1;
    }
    if (tau > std::max(most, 1 + share * (slip_limit(i) - 1))) {
      worst = i;
      most = tau;
    }
  }
  return worst;
}

const CoupledReport& CoupledDynamics::resolve_rest(const double* state,
                                                   ActiveForces<double>& forces,
                                                   bool due) {
  std::vector<Onset> begun;  // in this call
  // One change at a time, the worst first. For hinges whose friction is not
  // so strong that several answers are possible, each change brings the rest
  // nearer to what it should be; coming back to the same hinge again and
  // again says otherwise.
  const int change_limit = 4 * size() + 8;
  for (int change = 0; change < change_limit; ++change) {
    find_friction(state, forces);
    if (report_.status != CoupledStatus::ok ||
        !find_directions(state, forces, begun)) {
      return report_;
    }
    if (!begun.empty()) refine();
    if (report_.status != CoupledStatus::ok) return report_;

    // Friction must not drive what it should hold back.
    const auto held = std::ranges::find_if(begun, [&](const Onset& onset) {
      return is_driven(*hinges_, onset.body);
    });
    if (held != begun.end()) {
      set_mode(held->body, HingeMode::resting);
      begun.erase(held);
      continue;
    }
    const int worst = worst_resting(due);
    if (worst < 0) return report_;
    begun.push_back(begin_to_slide(worst));
  }
  report_.status = CoupledStatus::no_solution;
  report_.body = begun.empty() ? -1 : begun.back().body;
  return report_;
}

}  // namespace multibody
