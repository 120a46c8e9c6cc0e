#include "multibody/friction/coupled_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/friction/coupled_impl.hpp"
#include "multibody/system/eigen_conversion.hpp"

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
  const double least = link.kind == HingeKind::axis
                           ? link.inertia(2, 2)
                           : std::min(link.inertia(0, 0), link.inertia(1, 1));
  return link.mass * link.arm / (least + about);
}

}  // namespace

CoupledDynamics::Impl::Impl(const System& system,
                            std::vector<HingeFriction> friction,
                            const CoupledOptions& coupled_options)
    : options(coupled_options),
      dynamics(system, options.instruction_set),
      tracker(friction, options.instruction_set) {
  if (static_cast<int>(friction.size()) != system.size()) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("friction of {} hinges", friction.size()),
        fmt::format("of {}, one for each body", system.size())));
  }
  for (int i = 0; i < system.size(); ++i) {
    const Link& link = system.links()[i];
    Hinge& hinge = hinges.emplace_back(std::move(friction[i]), link, i);
    hinge.leverage = leverage_of(link);
    hinge.mass = link.mass;
    hinge.length = std::max(link.arm, link.hinge.norm());
    if (link.kind == HingeKind::none) hinge.mode = HingeMode::released;
  }
  reactions_.resize(system.size());
  change_.resize(system.size());
  forget_path();
  rows_.reserve(system.size());
}

void CoupledDynamics::Impl::set_mode(int body, HingeMode mode) {
  Hinge& hinge = hinges[body];
  if (joint_mode(hinge.mode) != joint_mode(mode)) {
    // They stay those of the last evaluation.
    know_reactions();
    dynamics.set_mode(body, joint_mode(mode));
  }
  hinge.mode = mode;
  hinge.straight = hinge.follows = false;
  hinge.slope.setZero();
  tracker.stop(body);
  forget_path();
  last_pause_ = pause_ = 0;
  usual_contraction_ = usual_gain_ = 1;
  hinge.utilisation_of = -1;
  rows_known_ = false;
}

void CoupledDynamics::Impl::list_rows() {
  rows_.clear();
  for (int i = 0; i < static_cast<int>(hinges.size()); ++i) {
    if (active(hinges[i])) rows_.push_back(i);
  }
  rows_known_ = true;
}

void CoupledDynamics::Impl::take_rates(const double* state) {
  ++evaluation_;
  if (!rows_known_) list_rows();
  for (const int i : rows_) {
    Hinge& hinge = hinges[i];
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
    tracker.set_rate(i, hinge.rate);
  }
}

void CoupledDynamics::Impl::start(const double* state,
                                  ActiveForces<double>& forces) {
  state_ = state;
  forces_ = &forces;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    if (!active(hinges[i])) hinges[i].moment.setZero();
    forces.bodies[i].friction = vec3(hinges[i].moment);
  }
  if (prescribed) {
    dynamics.evaluate_prescribed(state, forces, *prescribed);
  } else {
    dynamics.evaluate(state, forces);
  }
  reactions_known_ = false;
}

void CoupledDynamics::Impl::apply_change() {
  forget_applied();
  for (const int i : rows_) {
    hinges[i].moment += vec3(change_[i]);
    forces_->bodies[i].friction = vec3(hinges[i].moment);
  }
  if (prescribed) {
    dynamics.evaluate_prescribed(state_, *forces_, *prescribed);
  } else {
    dynamics.add_friction(change_);
  }
  reactions_known_ = false;
}

CoupledRounding CoupledDynamics::Impl::noise() const {
  const auto size = [](const Vec3<double>& v) { return std::sqrt(dot(v, v)); };
  const double* w = state_ + StateLayout::angular_velocity;
  double rate = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  double force = size(forces_->carrier.force);
  double moment = size(forces_->carrier.moment);
  double mass = 0;
  double length = 0;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    if (hinge.mode == HingeMode::released) continue;
    const double* s = state_ + dynamics.layout().offset(static_cast<int>(i));
    rate = std::max(
        rate, hinge.is_axis ? std::abs(s[1]) : std::hypot(s[4], s[5], s[6]));
    force += size(forces_->bodies[i].force);
    moment += size(forces_->bodies[i].moment);
    mass += hinge.mass;
    length = std::max(length, hinge.length);
  }
  if (prescribed) force += mass * size(prescribed->linear);
  // Some tens of operations on each.
  constexpr double rounding = 1e-14;
  const double forces = rounding * (force + mass * length * rate * rate);
  return {forces, rounding * moment + length * forces};
}

// Whether the moments found can be the only ones: kappa < 1.
bool CoupledDynamics::Impl::converged_is_unique() {
  // The friction moment grows about in proportion to R, so that the first
  // number is about kappa; it is looked at closely where one of the two
  // comes near 1.
  constexpr double near_one = 0.5;
  // Too few digits to tell slopes.
  constexpr double few = 1e6;
  if (report.contraction < near_one &&
      largest_leverage_ < near_one * near_one) {
    return true;
  }
  const double least = report.contraction < near_one ? 0 : few * noise().moment;
  for (const int i : rows_) {
    const Hinge& hinge = hinges[i];
    const Vec3<double>& force = reaction(i).force;
    const double moment = hinge.solved.squaredNorm();
    const double rough = hinge.leverage * hinge.leverage * moment;
    if (rough < near_one * near_one * dot(force, force) &&
        report.contraction < near_one) {
      continue;
    }
    if (moment < least * least) continue;
    if (!(kappa(i) < 1)) {
      report.body = i;
      return false;
    }
  }
  return true;
}

const CoupledReport& CoupledDynamics::Impl::evaluate(
    const double* state, ActiveForces<double>& forces) {
  report = {};
  solutions.clear();
  take_rates(state);
  extrapolate(state);
  for (Vec3<double>& change : change_) change = {0, 0, 0};
  start(state, forces);
  if (rows_.empty()) return report;
  converge();
  if (report.status == CoupledStatus::out_of_range ||
      report.status == CoupledStatus::no_contact) {
    // Not to start from again.
    for (const int i : rows_) hinges[i].moment.setZero();
  } else if (report.status != CoupledStatus::ok || !converged_is_unique()) {
    search();
  }
  return report;
}

CoupledDynamics::Impl::Response CoupledDynamics::Impl::response(int body) {
  Hinge& hinge = hinges[body];
  const double size = std::max(hinge.moment.norm(), 1.0);
  const auto alpha = [&] { return vec3(dynamics.relative_acceleration(body)); };
  const Vector3d alpha0 = alpha();
  const Vector3d force0 = vec3(reaction(body).force);
  const Vector3d moment0 = vec3(reaction(body).moment);
  Response r{Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
  for (int k = hinge.is_axis ? 2 : 0; k < 3; ++k) {
    for (Vec3<double>& change : change_) change = {0, 0, 0};
    const Vector3d change = size * Vector3d::Unit(k);
    change_[body] = vec3(change);
    apply_change();
    r.acceleration.col(k) = (alpha() - alpha0) / size;
    r.force.col(k) = (vec3(reaction(body).force) - force0) / size;
    r.moment.col(k) = (vec3(reaction(body).moment) - moment0) / size;
    change_[body] = vec3(Vector3d(-change));
    apply_change();
  }
  change_[body] = {0, 0, 0};
  return r;
}

std::span<const contact::JointSolution> CoupledDynamics::Impl::joints(
    int body) {
  Hinge& hinge = hinges[body];
  if (hinge.solver_is_behind && active(hinge)) {
    hinge.solver.slide(reaction(body), hinge.rate);
  }
  hinge.solver_is_behind = false;
  return hinge.solver.joints();
}

void CoupledDynamics::Impl::fail_at(int body) {
  const HingeSolver& solver = hinges[body].solver;
  const int joint = solver.failed_joint();
  const double force = solver.joints()[joint].reaction.norm();
  report.body = body;
  report.status = CoupledStatus::out_of_range;
  if (!std::isfinite(force)) return;
  report.status = CoupledStatus::no_contact;
  report.joint = joint;
  report.force = force;
}

double CoupledDynamics::Impl::kappa(int body) {
  Hinge& hinge = hinges[body];
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

double CoupledDynamics::Impl::utilisation(int body) {
  Hinge& hinge = hinges[body];
  if (hinge.utilisation_of != evaluation_) {
    // Rounding does not make a hinge slide.
    const CoupledRounding rounding = noise();
    const Reaction<double>& held = reaction(body);
    hinge.utilisation = vec3(held.force).norm() <= rounding.force &&
                                vec3(held.moment).norm() <= rounding.moment
                            ? 0
                            : hinge.solver.utilisation(held);
    hinge.utilisation_of = evaluation_;
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
HingeMode CoupledDynamics::mode(int body) const {
  return impl_->hinges[body].mode;
}
void CoupledDynamics::set_mode(int body, HingeMode mode) {
  impl_->set_mode(body, mode);
}
bool CoupledDynamics::can_rest(int body) const {
  return impl_->hinges[body].can_rest;
}
bool CoupledDynamics::has_friction(int body) const {
  return impl_->hinges[body].has_friction;
}
void CoupledDynamics::set_direction(int body, const Vector3d& direction) {
  impl_->hinges[body].direction = direction;
}
const Vector3d& CoupledDynamics::direction(int body) const {
  return impl_->hinges[body].direction;
}
void CoupledDynamics::slide_straight(int body, bool straight) {
  impl_->hinges[body].straight = straight;
  impl_->hinges[body].follows = false;
}
bool CoupledDynamics::slides_straight(int body) const {
  return impl_->hinges[body].straight;
}
void CoupledDynamics::follow_acceleration(int body) {
  impl_->hinges[body].straight = impl_->hinges[body].follows = true;
}
void CoupledDynamics::follow_acceleration(int body, double pace) {
  impl_->hinges[body].pace = pace;
  follow_acceleration(body);
}
bool CoupledDynamics::follows_acceleration(int body) const {
  return impl_->hinges[body].follows;
}
double CoupledDynamics::pace(int body) const {
  return impl_->hinges[body].pace;
}
void CoupledDynamics::prescribe_carrier(
    const std::optional<CarrierAcceleration<double>>& carrier) {
  impl_->prescribed = carrier;
}
const CoupledReport& CoupledDynamics::evaluate(const double* state,
                                               ActiveForces<double>& forces) {
  return impl_->any_follows() ? impl_->evaluate_following(state, forces)
                              : impl_->evaluate(state, forces);
}
const CoupledReport& CoupledDynamics::report() const { return impl_->report; }
void CoupledDynamics::set_trace(std::vector<OuterStep>* trace) {
  impl_->trace = trace;
}
const Vector3d& CoupledDynamics::friction_moment(int body) const {
  return impl_->hinges[body].moment;
}
void CoupledDynamics::set_friction_moment(int body, const Vector3d& moment) {
  impl_->hinges[body].moment = moment;
  impl_->forget_path();
}
const Reaction<double>& CoupledDynamics::reaction(int body) const {
  return impl_->reaction(body);
}
double CoupledDynamics::utilisation(int body) {
  return impl_->utilisation(body);
}
double CoupledDynamics::slip_limit(int body) const {
  return impl_->slip_limit(body);
}
std::span<const contact::JointSolution> CoupledDynamics::joints(
    int body) const {
  return impl_->joints(body);
}
const contact::JointContact& CoupledDynamics::contact(int body,
                                                      int joint) const {
  return impl_->hinges[body].solver.contact(joint);
}
std::span<const CoupledSolution> CoupledDynamics::solutions() const {
  return impl_->solutions;
}
bool CoupledDynamics::stops_within(int body, const Vector3d& rate,
                                   double step) {
  const Impl::Felt felt = impl_->felt(body);
  return impl_->hinges[body]
      .solver.prox(felt.inertia, rate / step + felt.free)
      .isZero(0);
}
CoupledRounding CoupledDynamics::rounding() const { return impl_->noise(); }
double CoupledDynamics::kappa(int body) { return impl_->kappa(body); }
const CoupledReport& CoupledDynamics::resolve_rest(const double* state,
                                                   ActiveForces<double>& forces,
                                                   int forced) {
  return impl_->resolve_rest(state, forces, forced);
}

}  // namespace multibody
