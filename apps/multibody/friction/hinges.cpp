#include "multibody/friction/hinges.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/kinds.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Smallest inertia about the hinge for a rotation that moves the centre of
// mass.
double inertia_of(const Link& link) {
  const double about = link.mass * link.arm * link.arm;
  const double least = hinge_traits(link.kind).is_axis
                           ? link.inertia(2, 2)
                           : std::min(link.inertia(0, 0), link.inertia(1, 1));
  return least + about;
}

}  // namespace

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

Evaluation::Evaluation(const System& system)
    : dynamics(system),
      hinges(system.size()),
      change(system.size()),
      reactions(system.size()),
      slopes(system.is_star() ? 0 : system.size(), Matrix3d::Zero()) {
  forces.bodies.resize(system.size());
  active.reserve(system.size());
}

std::vector<Hinge> make_hinges(const System& system,
                               const std::vector<HingeFriction>& friction) {
  if (static_cast<int>(friction.size()) != system.size()) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("friction of {} hinges", friction.size()),
        fmt::format("of {}, one for each body", system.size())));
  }
  std::vector<Hinge> hinges;
  for (int i = 0; i < system.size(); ++i) {
    hinges.emplace_back(friction[i], system.links()[i], i);
  }
  for (const int i : system.order()) {
    const int parent = system.links()[i].parent;
    if (parent >= 0) hinges[i].length += hinges[parent].length;
  }
  return hinges;
}

void Hinges::set_state(const double* state) {
  ++at_.number;
  at_.solutions.clear();
  at_.is_refined = false;
  at_.active.clear();
  at_.cones.clear();
  Dynamics& dynamics = at_.dynamics;
  for (int i = 0; i < size(); ++i) {
    const JointMode mode = joint_mode(hinges_[i].mode);
    if (dynamics.mode(i) != mode) dynamics.set_mode(i, mode);
    if (hinges_[i].is_active()) at_.active.push_back(i);
    if (hinges_[i].mode != HingeMode::released) {
      const double* s = state + dynamics.layout().offset(i);
      hinges_[i].solver.set_state(s, memory(i).solver);
      now(i).push = hinges_[i].push_at(s);
      if (hinges_[i].slides_on_stop()) add_cone(i, s);
    }
  }
  if (state != at_.state.data()) {
    at_.state.assign(state, state + dynamics.layout().size());
  }
  for (const int i : active()) {
    const Hinge& hinge = hinges_[i];
    const Vector3d& direction = memory(i).direction;
    Vector3d& rate = now(i).rate;
    const double* s = state + dynamics.layout().offset(i);
    const bool dry = hinge.can_rest;
    if (!hinge.is_axis) {
      rate = Vector3d(s[4], s[5], s[6]);
      if (dry && (hinge.straight || rate.isZero(0))) rate = direction;
    } else {
      // Beyond the end of sliding, where a trial step may be, dry friction
      // keeps its direction.
      constexpr double least = 1e-100;
      const double sign = direction.z();
      rate = Vector3d(0, 0, dry ? sign * std::max(sign * s[1], least) : s[1]);
    }
  }
}

bool Hinges::any_gets_under_way() const {
  // Above this rate the uncertainty of the acceleration cannot end the motion
  // within a step.
  constexpr double slow = 1e-5;
  constexpr double share = 1e-4;
  return std::ranges::any_of(active(), [&](int i) {
    const Hinge& hinge = hinges_[i];
    const bool is_slow =
        hinge.follows || (hinge.is_axis && std::abs(now(i).rate.z()) < slow);
    return is_slow && hinge.can_rest &&
           hinge.inertia * acceleration(i).norm() <
               share * memory(i).moment.norm();
  });
}

void Hinges::start() {
  for (int i = 0; i < size(); ++i) {
    Vector3d& moment = memory(i).moment;
    if (!hinges_[i].is_active()) moment.setZero();
    forces().bodies[i].friction = vec3(moment);
  }
  for (ConeRest& cone : at_.cones) cone.moment = 0;
  evaluate();
  if (at_.cones.empty()) return;
  find_cone_inertia();
  keep_on_cones();
}

void Hinges::evaluate() {
  if (is_prescribed()) {
    at_.dynamics.evaluate_prescribed(at_.state.data(), forces(),
                                     *at_.prescribed);
  } else {
    at_.dynamics.evaluate(at_.state.data(), forces());
  }
  at_.reactions_known = false;
}

void Hinges::add_moments(const std::vector<Vec3<double>>& changes) {
  if (is_prescribed() && !is_tree()) return evaluate();
  at_.dynamics.add_friction(changes);
  at_.reactions_known = false;
}

void Hinges::apply_changes() {
  ++at_.number;
  memory_.tracked.forget_applied();
  for (const int i : active()) {
    memory(i).moment += vec3(change(i));
    forces().bodies[i].friction = vec3(memory(i).moment);
    if (!at_.cones.empty()) add_stop(i);
  }
  add_moments(at_.change);
  keep_on_cones();
}

void Hinges::give_reactions(FrictionTracker& tracker) {
  tracker.take_reactions(at_.dynamics);
}

void Hinges::take_moment(int body, const Vector3d& moment) {
  memory(body).moment = now(body).solved = moment;
  forces().bodies[body].friction = vec3(moment);
  if (!at_.cones.empty()) add_stop(body);
}

void Hinges::move(FrictionTracker& tracker) {
  if (is_prescribed() && !is_tree()) {
    evaluate();
  } else {
    tracker.move(at_.dynamics);
    at_.reactions_known = false;
  }
  keep_on_cones();
  give_reactions(tracker);
}

void Hinges::know_reactions() {
  if (!at_.reactions_known) at_.dynamics.reactions(at_.reactions);
  at_.reactions_known = true;
}

Vector3d Hinges::acceleration(int body) const {
  return vec3(at_.dynamics.relative_acceleration(body));
}

double Hinges::solve(double floor) {
  double largest = 0;
  for (const int i : active()) {
    HingeInstant& hinge = now(i);
    hinge.solved =
        hinges_[i].solver.slide(reaction(i), hinge.rate, memory(i).solver);
    hinge.solver_is_behind = false;
    largest = std::max(largest, hinge.solved.norm());
  }
  double residual = 0;
  for (const int i : active()) {
    const Vector3d& solved = now(i).solved;
    const Vector3d& moment = memory(i).moment;
    const double difference = (solved - moment).norm();
    if (difference == 0) continue;
    const double own = difference / (solved.norm() + moment.norm() +
                                     small_share * largest + floor);
    // NaN must not be replaced by a later value.
    if (!(own <= residual) && !std::isnan(residual)) residual = own;
  }
  return residual;
}

std::span<const contact::JointSolution> Hinges::joints(int body) {
  HingeInstant& hinge = now(body);
  if (hinge.solver_is_behind && hinges_[body].is_active()) {
    hinges_[body].solver.slide(reaction(body), hinge.rate, memory(body).solver);
  }
  hinge.solver_is_behind = false;
  return memory(body).solver.joints;
}

CoupledRounding Hinges::rounding() const {
  const auto length_of = [](const Vec3<double>& v) {
    return std::sqrt(dot(v, v));
  };
  const double* w = at_.state.data() + StateLayout::angular_velocity;
  double rate = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  double force = length_of(forces().carrier.force);
  double moment = length_of(forces().carrier.moment);
  double mass = 0;
  double length = 0;
  const bool is_tree = this->is_tree();
  for (int i = 0; i < size(); ++i) {
    const Hinge& hinge = hinges_[i];
    if (hinge.mode == HingeMode::released) continue;
    const double* s = at_.state.data() + at_.dynamics.layout().offset(i);
    const double own =
        hinge.is_axis ? std::abs(s[1]) : std::hypot(s[4], s[5], s[6]);
    rate = is_tree ? rate + own : std::max(rate, own);
    force += length_of(forces().bodies[i].force);
    moment += length_of(forces().bodies[i].moment);
    // Effects of a moment further along the tree may cancel as well.
    if (is_tree) force += hinge.leverage * length_of(forces().bodies[i].moment);
    mass += hinge.mass;
    length = std::max(length, hinge.length);
  }
  if (is_prescribed()) force += mass * length_of(at_.prescribed->linear);
  // Rounding of some tens of operations on each number.
  constexpr double share = 1e-14;
  const double forces = share * (force + mass * length * rate * rate);
  return {forces, share * moment + length * forces};
}

double Hinges::uncertain_moment() const {
  // Share of one hinge in the rounding of all forces.
  constexpr double part = 0.1;
  double sum = 0;
  for (const int i : active()) sum += memory(i).moment.norm();
  return part * rounding().moment + refined_tolerance * sum;
}

Hinges::Response Hinges::response(int body) {
  const double size = std::max(memory(body).moment.norm(), 1.0);
  const Vector3d alpha0 = acceleration(body);
  const Vector3d force0 = vec3(reaction(body).force);
  const Vector3d moment0 = vec3(reaction(body).moment);
  Response r{Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
  for (int k = hinges_[body].is_axis ? 2 : 0; k < 3; ++k) {
    std::ranges::fill(at_.change, Vec3<double>{0, 0, 0});
    const Vector3d moved = size * Vector3d::Unit(k);
    change(body) = vec3(moved);
    apply_changes();
    r.acceleration.col(k) = (acceleration(body) - alpha0) / size;
    r.force.col(k) = (vec3(reaction(body).force) - force0) / size;
    r.moment.col(k) = (vec3(reaction(body).moment) - moment0) / size;
    change(body) = vec3(Vector3d(-moved));
    apply_changes();
  }
  change(body) = {0, 0, 0};
  return r;
}

// Forward differences, accurate to about 1e-6.
Hinges::Slopes Hinges::slopes(int body) {
  const Hinge& hinge = hinges_[body];
  Slopes slopes{Matrix3d::Zero(), Matrix3d::Zero()};
  const Reaction<double> at = reaction(body);
  const double force = vec3(at.force).norm();
  if (!(force > 0)) return slopes;
  const auto solved = [&](const Reaction<double>& reaction) {
    return hinge.solver.slide(reaction, now(body).rate, memory(body).solver);
  };
  const Vector3d middle = solved(at);
  constexpr double share = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const double step = share * force;
    Reaction<double> moved = at;
    moved.force = vec3(Vector3d(vec3(at.force) + step * Vector3d::Unit(k)));
    slopes.by_force.col(k) = (solved(moved) - middle) / step;
    if (!hinge.is_axis || k == 2) continue;
    moved = at;
    moved.moment = vec3(Vector3d(vec3(at.moment) + step * Vector3d::Unit(k)));
    slopes.by_held.col(k) = (solved(moved) - middle) / step;
  }
  solved(at);
  return slopes;
}

void Hinges::set_tree_steps(bool fresh) {
  std::ranges::fill(at_.change, Vec3<double>{0, 0, 0});
  std::ranges::fill(at_.slopes, Matrix3d::Zero());
  for (const int i : active()) {
    const Reaction<double>& at = reaction(i);
    Matrix3d& slope = memory(i).slope;
    if (fresh || slope.isZero(0)) {
      const std::optional<Matrix3d> known =
          hinges_[i].solver.slope(at, now(i).rate, memory(i).solver);
      slope = known ? *known : slopes(i).by_force;
    }
    at_.slopes[i] = slope;
    at_.change[i] = vec3(Vector3d(now(i).solved - slope * vec3(at.force)));
  }
  // Under the present moments of stops, which are found anew after the step.
  for (const ConeRest& cone : at_.cones) {
    change(cone.body) += vec3(Vector3d(cone.moment * cone.axis));
  }
  at_.dynamics.fitting_moments(at_.change, at_.slopes, at_.change);
  for (const ConeRest& cone : at_.cones) {
    change(cone.body) += vec3(Vector3d(-cone.moment * cone.axis));
    if (!hinges_[cone.body].is_active()) change(cone.body) = {0, 0, 0};
  }
  for (const int i : active()) {
    Vector3d step = vec3(at_.change[i]) - memory(i).moment;
    if (!step.allFinite()) step = 0.5 * (now(i).solved - memory(i).moment);
    at_.change[i] = vec3(step);
  }
}

// |dR_i/dM_j| of the active hinges, R_i their forces or moments.
Eigen::MatrixXd Hinges::responses(Vec3<double> Reaction<double>::*part) {
  const std::vector<int>& all = active();
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(all.size(), all.size());
  std::vector<Vector3d> before;
  for (const int i : all) before.push_back(vec3(reaction(i).*part));
  std::ranges::fill(at_.change, Vec3<double>{0, 0, 0});
  for (std::size_t j = 0; j < all.size(); ++j) {
    const int moved = all[j];
    const double size = std::max(memory(moved).moment.norm(), 1.0);
    for (int k = hinges_[moved].is_axis ? 2 : 0; k < 3; ++k) {
      const Vector3d by = size * Vector3d::Unit(k);
      change(moved) = vec3(by);
      apply_changes();
      for (std::size_t i = 0; i < all.size(); ++i) {
        squares(i, j) +=
            (vec3(reaction(all[i]).*part) - before[i]).squaredNorm() /
            (size * size);
      }
      change(moved) = vec3(Vector3d(-by));
      apply_changes();
    }
    change(moved) = {0, 0, 0};
  }
  return squares.cwiseSqrt();
}

// R(M) depends on positions and masses; Equations clears the stored value when
// masses change.
double Hinges::tree_response(Eigen::MatrixXd& to) {
  constexpr double near = 0.02;  // rad; of a ball twice that, by quaternions
  std::vector<double>& known = memory_.response_at;
  known.resize(1 + 4 * hinges_.size(), std::numeric_limits<double>::infinity());
  bool is_near = known[0] == is_prescribed();
  known[0] = is_prescribed();
  for (int pass = 0; pass < (is_near ? 1 : 2); ++pass) {
    for (int i = 0; i < size(); ++i) {
      if (hinges_[i].mode == HingeMode::released) continue;
      const double* s = at_.state.data() + at_.dynamics.layout().offset(i);
      for (int k = 0; k < (hinges_[i].is_axis ? 1 : 4); ++k) {
        double& last = known[1 + 4 * i + k];
        is_near = is_near && std::abs(s[k] - last) <= near;
        if (!is_near) last = s[k];
      }
    }
  }
  if (!is_near) {
    to = responses(&Reaction<double>::force);
    memory_.tree_response = to.rowwise().sum().maxCoeff();
  }
  return memory_.tree_response;
}

// Largest slope and largest chord |F(X') - F(X)|/|X' - X| over many X', where X
// is one part of the reaction.
double Hinges::chord(int body, Vec3<double> Reaction<double>::*part) {
  const Hinge& hinge = hinges_[body];
  const auto [by_force, by_held] = slopes(body);
  const bool is_force = part == &Reaction<double>::force;
  // Moments matter only for groups.
  const bool is_group = !by_held.isZero(0);
  if (!is_force && !is_group) return 0;
  double steepest = (is_force ? by_force : by_held).norm();
  Reaction<double> at = reaction(body);
  const auto solved = [&] {
    return hinge.solver.slide(at, now(body).rate, memory(body).solver);
  };
  const Vector3d middle = solved();
  const Vector3d here = vec3(at.*part);
  const Vector3d axial(0, 0, hinge.is_axis ? here.z() : 0);
  const double size = (here - axial).norm() > 0 ? (here - axial).norm() : 1;
  // A pin's chord is steepest where only the size differs.
  const bool is_pin = hinge.is_axis && !is_group;
  const int around = is_pin ? 0 : 1;
  const int per_decade = is_pin ? 4 : 1;
  constexpr int decades = 6;
  const auto look = [&](const Vector3d& way) {
    for (int k = -decades * per_decade; k <= decades * per_decade; ++k) {
      at.*part = vec3(
          Vector3d(axial + size * std::pow(10, double(k) / per_decade) * way));
      const double by = (vec3(at.*part) - here).norm();
      if (by < 1e-3 * size) continue;
      const double slope = (solved() - middle).norm() / by;
      if (slope > steepest) steepest = slope;  // no NaN: no contact there
    }
  };
  if (here != axial) look((here - axial) / size);
  for (int x = -around; x <= around; ++x) {
    for (int y = -around; y <= around; ++y) {
      for (int z = -around; z <= around; ++z) {
        if (x || y || z) look(Vector3d(x, y, z).normalized());
      }
    }
  }
  at.*part = vec3(here);
  solved();
  return steepest;
}

// Chords of a reaction and rate nearby serve again, because a search for each
// takes as long as 50 to 400 contacts.
const HingeMemory::Chords& Hinges::chords(int body) {
  constexpr double near = 0.02;
  HingeMemory::Chords& known = memory(body).chords;
  Eigen::Matrix3d at;
  at << vec3(reaction(body).force), vec3(reaction(body).moment), now(body).rate;
  const auto is_near = [&](int k) {
    return (at.col(k) - known.at.col(k)).norm() <= near * at.col(k).norm();
  };
  if (!is_near(0) || !is_near(1) || !is_near(2)) {
    known = {at, chord(body, &Reaction<double>::force),
             chord(body, &Reaction<double>::moment)};
  }
  return known;
}

// For two solutions |M_i' - M_i| <= c_i |R_i' - R_i| <= sum K_ij |M_j' - M_j|,
// where c_i is the steepest chord of friction from the present R_i; slopes
// alone do not bound it. The solutions coincide if the spectral radius of K is
// below 1. By Collatz and Wielandt the radius is at most the largest (K
// x)_i/x_i for any x > 0.
double Hinges::chord_kappa(Eigen::MatrixXd forces) {
  const auto n = static_cast<Eigen::Index>(active().size());
  Eigen::MatrixXd k = forces.size() > 0 ? std::move(forces)
                                        : responses(&Reaction<double>::force);
  Eigen::VectorXd by_held(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const HingeMemory::Chords& steepest = chords(active()[i]);
    k.row(i) *= steepest.by_force;
    by_held[i] = steepest.by_held;
  }
  if (!by_held.isZero(0)) {
    k += by_held.asDiagonal() * responses(&Reaction<double>::moment);
  }
  Eigen::VectorXd x = Eigen::VectorXd::Ones(k.rows());
  double bound = std::numeric_limits<double>::infinity();
  constexpr int rounds = 50;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd next = k * x;
    bound = std::min(bound, next.cwiseQuotient(x).maxCoeff());
    // Averaged, so that it stays above 0 and does not oscillate.
    x = x + next;
    x /= x.maxCoeff();
  }
  return bound;
}

double Hinges::kappa(int body) {
  const Response by_moment = response(body);
  const auto [by_force, by_held] = slopes(body);
  // Frobenius norms exceed the largest stretch by a factor of up to 3, which is
  // on the safe side.
  return by_force.norm() * by_moment.force.norm() +
         by_held.norm() * by_moment.moment.norm();
}

double Hinges::work_out_utilisation(int body) {
  // Rounding must not make a hinge slide.
  const CoupledRounding least = rounding();
  const Reaction<double>& held = reaction(body);
  const bool is_little = vec3(held.moment).norm() <= least.moment;
  now(body).stop_moment = 0;
  if (is_little && vec3(held.force).norm() <= least.force) return 0;
  const Hinge& hinge = hinges_[body];
  if (hinge.rests_on >= 0) return utilisation_on_cone(body);
  const double tau = hinge.has_friction
                         ? hinge.solver.utilisation(held, memory(body).solver)
                         : 0;
  const int push = now(body).push;
  if (push == 0 || std::isnan(tau)) return tau;
  if (push * held.moment.z >= 0) return 0;  // the stop carries it all
  if (hinge.can_rest) return tau;
  return is_little ? 0 : std::numeric_limits<double>::infinity();
}

double Hinges::utilisation(int body) {
  HingeInstant& hinge = now(body);
  if (hinge.utilisation_of != at_.number) {
    hinge.utilisation = work_out_utilisation(body);
    hinge.utilisation_of = at_.number;
  }
  return hinge.utilisation;
}

Hinges::Felt Hinges::felt(int body) {
  joints(body);  // for the convex problem
  Matrix3d mobility = response(body).acceleration;
  const Vector3d free = acceleration(body) - mobility * memory(body).moment;
  if (const ConeRest* cone = cone_of(body)) {
    // Hardly anything turns it off its stop, or towards it.
    constexpr double stiff = 1e-8;
    mobility += stiff * mobility.norm() * cone->axis * cone->axis.transpose();
  }
  const Matrix3d inertia = mobility.inverse();
  return {0.5 * (inertia + inertia.transpose()), free};
}

}  // namespace multibody
