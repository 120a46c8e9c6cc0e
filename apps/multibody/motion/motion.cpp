#include "multibody/motion/motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/motion/motion_impl.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

double default_stop_speed(const MotionOptions& options) {
  if (options.stop_speed > 0) return options.stop_speed;
  // Below 1e-9 rad/s the rounding of the accelerations counts.
  return options.integrator == Integrator::rk4
             ? 1e-8
             : std::max(100 * options.absolute_tolerance, 1e-9);
}

void check_positive(double value, const char* name) {
  if (!(value > 0)) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("motion: {} = {}", name, value), "above 0"));
  }
}

void check_options(const MotionOptions& options) {
  check_positive(options.relative_tolerance, "relative_tolerance");
  check_positive(options.absolute_tolerance, "absolute_tolerance");
  check_positive(options.step, "step");
  check_positive(options.longest_step, "longest_step");
  check_positive(options.stall_changes, "stall_changes");
  check_positive(options.stall_span, "stall_span");
}

// To the dynamics it is one whose accelerations are given: no equation of the
// carrier is left to solve, and hinges on it do not feel each other.
void prescribe_fixed(const MotionStart& start, MotionOptions& options) {
  if (options.carrier_drive) {
    throw contact::Error(
        contact::detail::conflicts("motion: carrier_drive", "a fixed carrier"));
  }
  if (!start.carrier.velocity.isZero(0) ||
      !start.carrier.angular_velocity.isZero(0)) {
    throw contact::Error(contact::detail::must_be("start.carrier: velocity",
                                                  "0: the carrier is fixed"));
  }
  options.carrier_drive = CarrierDrive{};
}

BodyMotion checked_body(const BodyMotion& body, const std::string& place) {
  if (!body.position.allFinite() || !body.velocity.allFinite() ||
      !body.angular_velocity.allFinite()) {
    throw contact::Error(contact::detail::must_be(place, "finite"));
  }
  BodyMotion result = body;
  result.rotation = checked_rotation(body.rotation, place + ".rotation");
  return result;
}

// Numbers of a body on the carrier.
void put_hinged(const BodyStart& start, const Link& link,
                const std::string& place, double* to) {
  if (link.kind == HingeKind::axis) {
    to[0] = start.angle;
    to[1] = start.angle_rate;
  } else {
    const Matrix3d c =
        checked_rotation(start.rotation, place + ".rotation") * link.axes;
    const Eigen::Quaterniond q(c);
    Map<Eigen::Vector4d>{to} =
        Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()).normalized();
    Map<Vector3d>{to + 4} =
        link.axes.transpose() * start.relative_angular_velocity;
  }
  const double* rate = link.kind == HingeKind::axis ? to + 1 : to + 4;
  const int rates = link.kind == HingeKind::axis ? 1 : 3;
  const bool finite = std::isfinite(to[0]) &&
                      std::all_of(rate, rate + rates,
                                  [](double x) { return std::isfinite(x); });
  if (!finite) {
    throw contact::Error(contact::detail::must_be(place, "finite"));
  }
  if (start.locked &&
      std::any_of(rate, rate + rates, [](double x) { return x != 0; })) {
    throw contact::Error(contact::detail::must_be(
        place + ": relative velocity", "0 while the body is locked"));
  }
}

}  // namespace

MotionImpl::MotionImpl(const System& motion_system,
                       std::vector<HingeFriction> friction,
                       std::shared_ptr<const ForceModel> force_model,
                       const MotionStart& start,
                       const MotionOptions& motion_options)
    : system(motion_system),
      options(motion_options),
      stop_speed(default_stop_speed(motion_options)),
      forces(std::move(force_model)),
      coupled(system,
              friction.empty() ? std::vector<HingeFriction>(system.size())
                               : std::move(friction),
              motion_options.coupling),
      impulse(system),
      now(start.time),
      sample(this) {
  check_options(options);
  if (system.carrier().fixed) prescribe_fixed(start, options);
  joint_modes.resize(size());
  straight_from.resize(size());
  recent_.resize(size());
  slip_directions.resize(size());
  motions.resize(1 + size());
  rate_motions_.resize(1 + size());
  body_forces_.resize(1 + size());
  forces_.bodies.resize(size());
  held_units_.resize(size());
  // A step that ends at a break of the forces sees those before it.
  const auto right_hand_side = [this](double time, const double* state,
                                      double* to) {
    const double before = std::nextafter(next_break, time - 1);
    return rates(time < next_break ? time : before, state, to);
  };
  stepper = options.integrator == Integrator::rk4
                ? make_rk4_stepper(right_hand_side, options.step)
                : make_adaptive_stepper(
                      right_hand_side,
                      {options.relative_tolerance, options.absolute_tolerance,
                       options.longest_step, size()});
  const std::vector<double> state = start_state(start);
  // Whoever is at rest at the start has not come to rest.
  if (resolve_rest(state, -1)) restart(state);
  changes.clear();
}

std::vector<double> MotionImpl::start_state(const MotionStart& start) {
  if (static_cast<int>(start.bodies.size()) != size()) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("start of {} bodies", start.bodies.size()),
        fmt::format("of {}, one for each body", size())));
  }
  std::vector<double> state(number_count());
  put_body(checked_body(start.carrier, "start.carrier"), Matrix3d::Identity(),
           state.data());
  for (int i = 0; i < size(); ++i) {
    const Link& link = system.links()[i];
    const BodyStart& body = start.bodies[i];
    const std::string place = fmt::format("start.bodies[{}]", i);
    double* to = &state[coupled.layout().offset(i)];
    if (link.kind == HingeKind::none) {
      put_body(checked_body(body.body, place), link.axes, to);
      change_mode(i, HingeMode::released);
      continue;
    }
    put_hinged(body, link, place, to);
    const Vector3d rate = rate_of(i, state.data());
    if (body.locked) {
      change_mode(i, HingeMode::locked);
    } else if (rate.isZero(0) && coupled.hinge(i).can_rest) {
      change_mode(i, HingeMode::resting);
    } else {
      change_mode(i, HingeMode::sliding);
      if (!rate.isZero(0)) coupled.set_direction(i, rate.normalized());
    }
  }
  return state;
}

void MotionImpl::restart(std::vector<double> state) {
  normalise(system, coupled.layout(), joint_modes, state.data());
  pending.reset();
  stepper->restart(now, state);
  look_at(now, state);
}

bool MotionImpl::redo_step_to(double time) {
  const double begin = stepper->begin();
  const std::vector<double> state(stepper->begin_state().begin(),
                                  stepper->begin_state().end());
  // A single step, unless the error control wants several.
  stepper->set_next_step(time - begin);
  stepper->restart(begin, state);
  return stepper->step(time);
}

// The state at a time of the last step by a step that ends there, so that no
// interpolation gets into what follows.
void MotionImpl::go_to(double time) {
  if (time != stepper->end()) redo_step_to(time);
  while (stepper->end() < time) {
    if (!stepper->step(time)) break;
  }
  look_at(time, stepper->end_state());
  pending.reset();
}

// After a break nothing of the step before it may be used.
bool MotionImpl::pass_break() {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double next = forces ? forces->next_break(stepper->end()) : never;
  if (next == next_break) return false;
  next_break = next;
  const std::vector<double> state(stepper->end_state().begin(),
                                  stepper->end_state().end());
  stepper->restart(stepper->end(), state);
  return true;
}

void MotionImpl::show_step(double time) {
  if (!step_watch) return;
  look_at(time, stepper->end_state());
  step_watch(sample);
}

// Where the direction of a ball joint that has just begun to slide comes to an
// end with nothing near to go on to, it stays until the joint is faster. True:
// the last step can be tried again.
bool MotionImpl::keep_directions() {
  bool any = false;
  for (int i = 0; i < size(); ++i) any |= coupled.hinge(i).follows;
  if (!any) return false;
  const std::vector<double> state(stepper->begin_state().begin(),
                                  stepper->begin_state().end());
  look_at(stepper->begin(), state);
  work_out();
  for (int i = 0; i < size(); ++i) {
    if (coupled.hinge(i).follows) coupled.slide_straight(i, true);
  }
  stepper->restart(stepper->begin(), state);
  return true;
}

bool MotionImpl::step() {
  constexpr double early = -std::numeric_limits<double>::infinity();
  show_step(std::min(stepper->end(), std::nextafter(next_break, early)));
  if (pass_break()) show_step(stepper->end());
  const double from = stepper->end();
  if (!stepper->step(next_break)) {
    if (keep_directions()) return true;
    now = from;
    look_at(now, stepper->begin_state());
    // Why, if a coupled evaluation did not come out.
    const bool coupled_failed =
        failed_report.status != CoupledStatus::ok && failed_time >= from;
    set_failure(coupled_failed ? failed_report : CoupledReport{},
                coupled_failed ? failed_time : from);
    return false;
  }
  ++counts.steps;
  pending = find_event();
  if (!pending) {
    for (std::size_t i = 0; i < events.size(); ++i) {
      note_user_value(static_cast<int>(i), samples.user[i].back());
    }
    return true;
  }
  const Found found = *pending;
  const double planned = stepper->next_step();
  if (found.time <= stepper->begin()) {
    const std::vector<double> state(stepper->begin_state().begin(),
                                    stepper->begin_state().end());
    stepper->restart(stepper->begin(), state);
  } else if (found.time < stepper->end() && !redo_step_to(found.time)) {
    if (keep_directions()) {
      pending.reset();
      return true;
    }
    set_failure({}, stepper->end());
    return false;
  }
  // Several steps instead: what comes before the event may still be asked for,
  // so they are taken one by one.
  if (stepper->end() < found.time) {
    pending.reset();
    look_at(stepper->end(), stepper->end_state());
    note_user_values();
    return true;
  }
  // A step that ends early for the sake of others says nothing of the next one;
  // what follows the change of a hinge wants short ones at first.
  if (found.watch.kind == Watch::Kind::user) {
    stepper->set_next_step(std::max(stepper->next_step(), planned));
  }
  pending = found;
  return true;
}

Stop MotionImpl::advance_to(double time, bool look) {
  event = -1;
  for (long steps = 0; !failure; ++steps) {
    if (pending && pending->time <= time) {
      const Found found = *pending;
      pending.reset();
      if (handle(found)) return failure ? Stop::failed : Stop::event;
      continue;
    }
    if (stepper->end() >= time) {
      now = std::max(now, time);
      if (!look) return Stop::time;
      trial_.resize(number_count());
      stepper->interpolate(now, trial_);
      look_at(now, trial_);
      return Stop::time;
    }
    if (steps >= options.step_limit) {
      set_failure({}, stepper->end());
      failure->reason = fmt::format("at {} s: {} steps were not enough",
                                    stepper->end(), options.step_limit);
      break;
    }
    if (halt && halt()) {
      now = stepper->end();
      look_at(now, stepper->end_state());
      return Stop::halted;
    }
    if (!step()) break;
  }
  return Stop::failed;
}

// A state has the numbers of the bodies, the work of friction of each body, the
// work of the forces, and what each body's hinge holds.
int MotionImpl::held_by() const {
  const int number = stepper->largest_error();
  if (number < 0 || number == work_at()) return -1;
  if (number > work_at()) return 1 + number - held_at(0);
  if (number >= dissipated_at(0)) return 1 + number - dissipated_at(0);
  int body = 0;
  while (body < size() && number >= coupled.layout().offset(body)) ++body;
  return body;
}

void MotionImpl::look_back(
    double time, const std::function<void(const MotionSample&)>& look) {
  // Back again, whatever look() throws.
  struct Return {
    MotionImpl& motion;
    double time;
    std::vector<double> state;
    ~Return() { motion.look_at(time, state); }
  } const back{*this, view_time, view_state};
  trial_.resize(number_count());
  stepper->interpolate(time, trial_);
  look_at(time, trial_);
  look(sample);
}

MotionState MotionImpl::state_of(double time,
                                 std::span<const double> numbers) const {
  MotionState s;
  s.time = time;
  s.numbers.assign(numbers.begin(), numbers.end());
  for (int i = 0; i < size(); ++i) {
    s.modes.push_back(coupled.mode(i));
    s.directions.push_back(coupled.direction(i));
    s.friction.push_back(coupled.friction_moment(i));
    s.straight_from.push_back(coupled.hinge(i).straight ? straight_from[i] : 0);
    s.paces.push_back(coupled.hinge(i).follows ? coupled.hinge(i).pace : 0);
    s.hinge_angles.push_back(motions[1 + i].hinge_angle);
  }
  s.step = stepper->next_step();
  return s;
}

MotionState MotionImpl::save() {
  go_to(now);
  return state_of(now, view_state);
}

MotionState MotionImpl::step_state() const {
  MotionState s = state_of(stepper->begin(), stepper->begin_state());
  s.step = stepper->end() - stepper->begin();
  return s;
}

void MotionImpl::restore(const MotionState& s) {
  failure.reset();
  now = s.time;
  recent_.assign(size(), {});
  for (int i = 0; i < size(); ++i) {
    change_mode(i, s.modes[i]);
    coupled.set_direction(i, s.directions[i]);
    coupled.set_friction_moment(i, s.friction[i]);
    straight_from[i] = s.straight_from[i];
    coupled.slide_straight(i, s.straight_from[i] > 0);
    if (s.paces[i] > 0) coupled.follow_acceleration(i, s.paces[i]);
    keep_hinge_angle(i, s.hinge_angles[i]);
  }
  stepper->set_next_step(s.step);
  pending.reset();
  stepper->restart(now, s.numbers);
  look_at(now, s.numbers);
  for (std::size_t i = 0; i < events.size(); ++i) {
    user_values[i] = events[i].function(sample);
  }
}

Motion::Motion(const System& system, std::vector<HingeFriction> friction,
               std::shared_ptr<const ForceModel> forces,
               const MotionStart& start, const MotionOptions& options)
    : impl_(std::make_unique<MotionImpl>(system, std::move(friction),
                                         std::move(forces), start, options)) {}
Motion::~Motion() = default;
Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;

double Motion::time() const { return impl_->now; }
Stop Motion::advance_to(double time, bool look) {
  return impl_->advance_to(time, look);
}
int Motion::event() const { return impl_->event; }
const std::optional<MotionFailure>& Motion::failure() const {
  return impl_->failure;
}
const MotionSample& Motion::sample() const { return impl_->sample; }
void Motion::release(int body) { impl_->release(body); }
void Motion::lock(int body) { impl_->lock(body); }
void Motion::unlock(int body) { impl_->unlock(body); }
void Motion::set_forces(std::shared_ptr<const ForceModel> forces) {
  impl_->go_to(impl_->now);
  impl_->forces = std::move(forces);
  const std::vector<double> state = impl_->view_state;
  if (impl_->resolve_rest(state, -1)) impl_->restart(state);
}
int Motion::add_event(MotionEvent event) {
  impl_->events.push_back(std::move(event));
  impl_->go_to(impl_->now);
  impl_->user_values.push_back(impl_->events.back().function(impl_->sample));
  impl_->needs_forces.push_back(false);
  impl_->crossings.emplace_back();
  impl_->samples.user.emplace_back();
  return static_cast<int>(impl_->events.size()) - 1;
}
void Motion::watch_steps(std::function<void(const MotionSample&)> look) {
  impl_->step_watch = std::move(look);
}
void Motion::halt_when(std::function<bool()> halt) {
  impl_->halt = std::move(halt);
}
double Motion::step_begin() const { return impl_->stepper->begin(); }
double Motion::last_step() const {
  return impl_->stepper->end() - impl_->stepper->begin();
}
int Motion::held_by() const { return impl_->held_by(); }
void Motion::look_back(
    double time, const std::function<void(const MotionSample&)>& look) const {
  impl_->look_back(time, look);
}
const std::vector<HingeChange>& Motion::changes() const {
  return impl_->changes;
}
MotionState Motion::step_state() const { return impl_->step_state(); }
MotionState Motion::save() const { return impl_->save(); }
void Motion::restore(const MotionState& state) { impl_->restore(state); }
MotionCounts Motion::counts() const { return impl_->counts; }

double MotionSample::time() const { return motion_->view_time; }
std::span<const BodyMotion> MotionSample::motions() const {
  return motion_->motions;
}
HingeMode MotionSample::mode(int body) const {
  return motion_->coupled.mode(body);
}
double MotionSample::angle(int body) const {
  return motion_->view_state[motion_->coupled.layout().offset(body)];
}
HingeSample MotionSample::hinge(int body) const { return motion_->hinge(body); }
Vector3d MotionSample::acceleration(int place) const {
  // A hinged body's velocity is not among the numbers of the state.
  return motion_->acceleration(place);
}
Vector3d MotionSample::angular_acceleration(int place) const {
  return motion_->angular_acceleration(place);
}
EnergyBook MotionSample::energy() const { return motion_->energy(); }

}  // namespace multibody
