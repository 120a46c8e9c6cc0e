#include "multibody/friction/coupled_dynamics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "multibody/friction/search.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// The friction moment grows about in proportion to R, so that |M|/R times the
// response of R to M approximates kappa. Near 1 it is computed exactly.
constexpr double near_one = 0.5;

// Where kappa < 1 of each hinge is not sufficient, the matrix of chords of M_i
// over R_i times |dR_i/dM_j| decides. |M|/R is a chord too; other chords are
// steeper by at most a third (M = rho f N S, S grows from 1 to 1.31).
bool is_unique_in_tree(Hinges& at) {
  double most = 0;
  for (const int i : at.active()) {
    const Vec3<double>& force = at.reaction(i).force;
    const double share = at.now(i).solved.squaredNorm() / dot(force, force);
    // NaN: neither force nor moment.
    if (!(share <= most) && !std::isnan(share)) most = share;
  }
  Eigen::MatrixXd forces;
  return std::sqrt(most) * at.tree_response(forces) < near_one ||
         at.chord_kappa(std::move(forces)) < 1;
}

// True if the moments found must be the only ones. In a star kappa by the local
// slopes decides whether chords and the other hinges must be examined.
bool is_unique(Hinges& at) {
  if (at.is_tree()) return is_unique_in_tree(at);
  CoupledProgress& report = at.report();
  // Too few digits to determine slopes.
  constexpr double few = 1e6;
  if (report.contraction < near_one &&
      at.memory().tracked.largest_leverage() < near_one * near_one) {
    return true;
  }
  const double least =
      report.contraction < near_one ? 0 : few * at.rounding().moment;
  double largest = 0;
  for (const int i : at.active()) {
    const Vec3<double>& force = at.reaction(i).force;
    const double moment = at.now(i).solved.squaredNorm();
    const double rough = at[i].leverage * at[i].leverage * moment;
    if (rough < near_one * near_one * dot(force, force) &&
        report.contraction < near_one) {
      continue;
    }
    if (moment < least * least) continue;
    const double kappa = at.kappa(i);
    if (kappa < largest) continue;
    largest = kappa;
    report.body = i;
    if (!(kappa < 1)) return false;
  }
  if (largest >= near_one && !(at.chord_kappa() < 1)) return false;
  report.body = -1;
  return true;
}

void fail_at(int body, Hinges& at) {
  CoupledProgress& report = at.report();
  const HingeSolver::Memory& last = at.memory(body).solver;
  const int joint = HingeSolver::failed_joint(last);
  const double force = last.joints[joint].reaction.norm();
  report.body = body;
  report.status = CoupledStatus::out_of_range;
  if (!std::isfinite(force)) return;
  report.status = CoupledStatus::no_contact;
  report.joint = joint;
  report.contact = last.joints[joint].status;
  report.force = force;
}

// Change of the solved moments over the change of all moments, each in units of
// its size; and the slopes of hinges whose own moment changed notably, by
// Broyden's update. Other hinges changed with their neighbours.
void update_slopes(Hinges& at) {
  CoupledProgress& report = at.report();
  double dx = 0;
  double dg = 0;
  double most = 0;
  const auto change = [&](int i) {
    const double size = at.now(i).solved.squaredNorm();
    return size == 0
               ? 0
               : (at.memory(i).moment - at.now(i).last_moment).squaredNorm() /
                     size;
  };
  for (const int i : at.active()) {
    const HingeInstant& hinge = at.now(i);
    const double own = change(i);
    if (own == 0) continue;
    most = std::max(most, own);
    dx += own;
    dg += (hinge.solved - hinge.last_solved).squaredNorm() /
          hinge.solved.squaredNorm();
  }
  constexpr double rounding = 1e-20;  // squared
  if (!(dx > rounding)) return;
  report.contraction = std::max(report.contraction, std::sqrt(dg / dx));
  at.memory().tracked.learn_contraction(report.contraction);
  constexpr double notable = 0.1;  // squared
  for (const int i : at.active()) {
    if (at.is_tree() || change(i) < notable * most) continue;
    HingeMemory& memory = at.memory(i);
    const HingeInstant& hinge = at.now(i);
    const Vector3d by = memory.moment - hinge.last_moment;
    const Vector3d residual =
        hinge.solved - hinge.last_solved - memory.slope * by;
    memory.slope += residual * by.transpose() / by.squaredNorm();
  }
}

// Newton step of every hinge by its own slope; in a deeper tree of all hinges
// at once, because hinges react to their neighbours' moments.
// @param gain  of the last step; 0 before the first one
void set_steps(double gain, Hinges& at) {
  if (at.is_tree()) {
    // Slopes of other instants do as long as this is not exceeded: they take
    // longer than the contacts.
    constexpr double good = 0.03;
    at.set_tree_steps(!(gain <= good));
    for (const int i : at.active()) {
      at.now(i).last_moment = at.memory(i).moment;
      at.now(i).last_solved = at.now(i).solved;
    }
    return;
  }
  constexpr double strong = 0.9;
  constexpr double longest = 3;  // times the plain step
  for (const int i : at.active()) {
    HingeMemory& memory = at.memory(i);
    HingeInstant& hinge = at.now(i);
    const Vector3d residual = hinge.solved - memory.moment;
    if (memory.slope.norm() >= strong && at.report().contraction < strong) {
      memory.slope.setZero();  // outdated
    }
    Vector3d step = (Matrix3d::Identity() - memory.slope).inverse() * residual;
    // Newton step too long or NaN: damp it. If the iteration fails, the search
    // takes over.
    if (!(step.norm() <= longest * residual.norm())) step = 0.5 * residual;
    hinge.last_moment = memory.moment;
    hinge.last_solved = hinge.solved;
    at.change(i) = vec3(step);
  }
}

// Moment that a hinge cannot hold, N m.
double excess(int body, double tau, Hinges& at) {
  const Vec3<double>& held = at.reaction(body).moment;
  const double moment =
      at[body].is_axis ? std::abs(held.z) : std::sqrt(dot(held, held));
  return (1 - 1 / tau) * moment;
}

}  // namespace

CoupledDynamics::CoupledDynamics(const System& system,
                                 const std::vector<HingeFriction>& friction,
                                 const CoupledOptions& options)
    : options_(options),
      hinges_(make_hinges(system, friction)),
      beginning_{{}, TrackedLoop(friction, options)} {
  for (const Hinge& hinge : hinges_) {
    beginning_.hinges.emplace_back().solver = hinge.solver.make_memory();
    modes_.push_back(joint_mode(hinge.mode));
  }
  for (const Link& link : system.links()) kinds_.push_back(link.kind);
  layout_ = StateLayout(kinds_, modes_);
}

void CoupledDynamics::set_mode(int body, HingeMode mode,
                               FrictionMemory& memory) {
  Hinge& hinge = hinges_[body];
  hinge.mode = mode;
  hinge.straight = hinge.follows = false;
  if (mode == HingeMode::released) hinge.rests_on = -1;
  modes_[body] = joint_mode(mode);
  layout_ = StateLayout(kinds_, modes_);
  memory.forget(body);
}

double CoupledDynamics::utilisation(int body, Hinges at) const {
  const double tau = at.utilisation(body);
  // Above the uncertainty of tau by the tolerance, also next to much larger
  // friction.
  const double near = 1e4 * (slip_limit(body, at) - 1);
  if (!(std::abs(tau - 1) < near)) return tau;
  refine(at);
  return at.utilisation(body);
}

double CoupledDynamics::slip_limit(int body, Hinges at) const {
  const double threshold = hinge(body).is_axis ? options_.slip_threshold
                                               : options_.ball_slip_threshold;
  const double held = vec3(at.reaction(body).moment).norm();
  const double share = at.uncertain_moment() * at.utilisation(body) / held;
  // If a hinge holds almost nothing, for example without a body, the share is
  // infinite.
  constexpr double most = 1e-3;
  return 1 + (share > threshold ? std::min(share, most) : threshold);
}

const CoupledReport& CoupledDynamics::find_friction(const double* state,
                                                    Hinges& at) const {
  CoupledProgress& report = at.report();
  TrackedLoop& tracked = at.memory().tracked;
  report.start();
  at.set_state(state);
  tracked.extrapolate(at);
  at.start();
  if (at.active().empty()) return report;
  if (!tracked.converge(at)) {
    solve(options_.tolerance, at);
    if (report.status == CoupledStatus::ok) tracked.start(at);
  }
  if (report.status == CoupledStatus::out_of_range ||
      report.status == CoupledStatus::no_contact) {
    // The next evaluation does not start from the failed result.
    for (const int i : at.active()) at.memory(i).moment.setZero();
  } else if (report.status != CoupledStatus::ok || !is_unique(at)) {
    search(at);
  }
  return report;
}

// Refines the friction of the last evaluation to refined_tolerance. Where a
// hinge begins to slide, its acceleration is of the size of the threshold and
// of the usual tolerance, so that its direction needs better moments. (Results
// of a search are already that accurate.)
void CoupledDynamics::refine(Hinges& at) const {
  Evaluation& found = at.evaluation();
  if (found.is_refined || at.active().empty() || !found.solutions.empty()) {
    return;
  }
  found.is_refined = true;
  const double usual_gain = at.memory().usual_gain;
  const int iterations = found.report.iterations;
  solve(Hinges::refined_tolerance, at);
  found.report.iterations += iterations;
  at.memory().usual_gain = usual_gain;
  if (found.report.status == CoupledStatus::not_converged) search(at);
}

void CoupledDynamics::solve(double tolerance, Hinges& at) const {
  CoupledProgress& report = at.report();
  FrictionMemory& memory = at.memory();
  // Occasionally evaluates the residual after a step even if this is not
  // needed.
  constexpr int look_every = 8;
  const bool look = ++memory.loops % look_every == 0;
  double last = 0;
  int stalled = 0;
  double floor = 0;
  for (report.iterations = 1;; ++report.iterations) {
    const bool first = report.iterations == 1;
    // A slow loop may be limited by rounding.
    constexpr int patience = 5;
    if (report.iterations == patience) {
      floor = at.rounding().moment / tolerance;
    }
    report.residual = at.solve(floor);
    report.add_step();
    if (!std::isfinite(report.residual)) {
      report.status = CoupledStatus::out_of_range;
      const std::vector<int>& active = at.active();
      const auto lost =
          std::find_if(active.rbegin(), active.rend(),
                       [&](int i) { return !at.now(i).solved.allFinite(); });
      if (lost != active.rend()) fail_at(*lost, at);
      return;
    }
    // A step of Newton's through a tree may be the last one.
    if (!first && at.is_tree()) update_slopes(at);
    if (report.residual <= tolerance) return;
    // Rounding of the reactions may exceed the tolerance.
    constexpr double rounding = 1e-8;
    stalled = first || report.residual < 0.5 * last ? 0 : stalled + 1;
    if (stalled >= 2 && report.residual <= rounding) return;
    if (report.iterations >= options_.iteration_limit) {
      report.status = CoupledStatus::not_converged;
      return;
    }
    if (!first) {
      if (!at.is_tree()) update_slopes(at);
      memory.usual_gain =
          std::max(report.residual / last, 0.7 * memory.usual_gain);
    }
    set_steps(first ? 0 : report.residual / last, at);
    at.apply_changes();
    // Residual expected after this step, at the gain of recent steps.
    constexpr double safety = 10;
    const double left = safety * memory.usual_gain * report.residual;
    if (!(first && look) && left <= tolerance) {
      report.residual = left;
      return;
    }
    last = report.residual;
  }
}

bool CoupledDynamics::stops_within(int body, const Vector3d& rate, double step,
                                   Hinges at) {
  const Hinges::Felt felt = at.felt(body);
  return at[body]
      .solver
      .prox(felt.inertia, rate / step + felt.free, at.memory(body).solver)
      .isZero(0);
}

SlipDirections CoupledDynamics::directions(const double* state, Hinges& at,
                                           std::vector<Onset> balls) const {
  return {at,
          [=, this, &at] {
            return find_friction(state, at).status == CoupledStatus::ok;
          },
          std::move(balls)};
}

void CoupledDynamics::follow(const double* state, Hinges& at) const {
  std::vector<Onset> balls;
  for (int i = 0; i < size(); ++i) {
    if (hinge(i).follows) balls.push_back({i});
  }
  SlipDirections slip = directions(state, at, balls);
  const std::vector<Vector3d> before = slip.get();
  if (slip.settle()) return;
  slip.set(before);
  CoupledProgress& report = at.report();
  if (report.status == CoupledStatus::ok) {
    report.status = CoupledStatus::not_converged;
    report.body = balls.front().body;
  }
}

const CoupledReport& CoupledDynamics::evaluate(const double* state,
                                               FrictionMemory& memory,
                                               Evaluation& evaluation) const {
  Hinges here = at(memory, evaluation);
  if (std::ranges::any_of(hinges_, &Hinge::follows)) {
    follow(state, here);
  } else {
    find_friction(state, here);
  }
  if (evaluation.report.status == CoupledStatus::ok &&
      here.any_gets_under_way()) {
    refine(here);
  }
  return evaluation.report;
}

// Directions of the ball joints that have begun to slide.
bool CoupledDynamics::find_directions(const double* state, Hinges& at,
                                      const std::vector<Onset>& begun) const {
  std::vector<Onset> balls;
  std::ranges::copy_if(
      begun, std::back_inserter(balls),
      [&](const Onset& onset) { return !hinge(onset.body).is_axis; });
  if (balls.empty() || directions(state, at, balls).find()) return true;
  CoupledProgress& report = at.report();
  if (report.status == CoupledStatus::ok) {
    report.status = CoupledStatus::not_converged;
  }
  report.body = balls.front().body;
  return false;
}

// Releases a resting hinge.
Onset CoupledDynamics::begin_to_slide(int body, Hinges& at) {
  Onset onset{body};
  const double tau = utilisation(body, at);
  const int push = at.now(body).push;
  Vector3d held = vec3(at.reaction(body).moment);
  if (hinge(body).rests_on >= 0) {
    const double moment = at.stop_moment(body);
    held -= moment * push * at.cone_axis(body);
    if (moment == 0) rest_on(body, -1, at.memory());  // it slides off
  }
  if (tau > 1) onset.excess = (1 - 1 / tau) * held;
  const Vector3d& direction = at.memory(body).solver.slip_direction;
  if (!direction.isZero(0)) onset.direction = direction;
  if (hinge(body).is_axis && push != 0) {
    onset.direction = push * Vector3d::UnitZ();
  }
  at.memory(body).direction = onset.direction;
  set_mode(body, HingeMode::sliding, at.memory());
  return onset;
}

// The resting hinge that exceeds its limit most; in a deeper tree by its excess
// as a moment, because the excess of one hinge may be large for a neighbour.
// -1: none, or the report names a hinge without a contact.
int CoupledDynamics::worst_resting(bool due, Hinges& at) const {
  // Half of the threshold: a hinge found along the motion exceeds all of it,
  // except for the error of dense output. If this error is larger, the hinge
  // continues to rest, and is checked again from here. Hinges that are due at
  // one instant, as in mirrored bodies, begin to slide together.
  const double share = due ? 0.5 : 1;
  int worst = -1;
  double most = at.is_tree() ? 0 : 1;
  for (int i = 0; i < size(); ++i) {
    if (mode(i) != HingeMode::resting) continue;
    const double tau = utilisation(i, at);
    if (std::isnan(tau)) {
      fail_at(i, at);
      return -1;
    }
    const double beyond = at.is_tree() ? excess(i, tau, at) : tau;
    if (tau > 1 + share * (slip_limit(i, at) - 1) && beyond > most) {
      worst = i;
      most = beyond;
    }
  }
  return worst;
}

// The ball joint whose stop would have to pull most; -1: none.
int CoupledDynamics::worst_pulled(Hinges& at) const {
  int worst = -1;
  for (int i = 0; i < size(); ++i) {
    if (!hinge(i).slides_on_stop() || !pulls(i, at)) continue;
    if (worst < 0 || at.stop_moment(i) < at.stop_moment(worst)) worst = i;
  }
  return worst;
}

const CoupledReport& CoupledDynamics::resolve_rest(const double* state,
                                                   FrictionMemory& memory,
                                                   Evaluation& evaluation,
                                                   bool due) {
  Hinges here = at(memory, evaluation);
  CoupledProgress& report = evaluation.report;
  std::vector<Onset> begun;  // in this call
  // One change at a time, the worst first. If friction is not so strong that
  // several solutions are possible, each change brings the other hinges closer
  // to their final modes; returning to the same hinge repeatedly indicates
  // several solutions.
  const int change_limit = (here.is_tree() ? 8 : 4) * size() + 8;
  for (int change = 0; change < change_limit; ++change) {
    find_friction(state, here);
    if (report.status != CoupledStatus::ok ||
        !find_directions(state, here, begun)) {
      return report;
    }
    if (!begun.empty()) refine(here);
    if (report.status != CoupledStatus::ok) return report;

    // Friction must not drive a hinge that it should hold.
    const auto held = std::ranges::find_if(
        begun, [&](const Onset& onset) { return is_driven(here, onset.body); });
    if (held != begun.end()) {
      set_mode(held->body, HingeMode::resting, memory);
      begun.erase(held);
      continue;
    }
    const int worst = worst_resting(due, here);
    if (worst >= 0) {
      begun.push_back(begin_to_slide(worst, here));
      continue;
    }
    const int pulled =
        report.status == CoupledStatus::ok ? worst_pulled(here) : -1;
    if (pulled < 0) return report;
    rest_on(pulled, -1, memory);
  }
  report.status = CoupledStatus::no_solution;
  report.body = begun.empty() ? -1 : begun.back().body;
  return report;
}

}  // namespace multibody
