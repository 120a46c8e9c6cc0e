#include "multibody/motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <utility>

#include "libcontact/base/constants.hpp"
#include "multibody/motion/force_kinks.hpp"
#include "multibody/motion/hinge_changes.hpp"
#include "multibody/motion/hinge_events.hpp"
#include "multibody/motion/motion_start.hpp"
#include "multibody/motion/state_check.hpp"
#include "multibody/motion/step_path.hpp"
#include "multibody/motion/user_events.hpp"

namespace multibody {
namespace {

using contact::detail::infinity;

const char* reason(CoupledStatus status) {
  switch (status) {
    case CoupledStatus::not_converged:
      return "the friction moments and the reactions do not converge";
    case CoupledStatus::no_solution:
      return "no friction moments were found that fit the reactions they cause";
    case CoupledStatus::several_solutions:
      return "several friction moments fit the reactions they cause";
    case CoupledStatus::out_of_range:
      return "a force or a velocity is not a finite number";
    case CoupledStatus::no_contact:
      return "a contact has no value";
    case CoupledStatus::ok:
      return "the shortest steps do not meet the tolerance";
  }
  return "";
}

std::string reason(const HingeSolver& solver, const CoupledReport& report) {
  const contact::JointContact& contact = solver.contact(report.joint);
  const double force = report.force;
  if (report.contact == contact::Status::out_of_seat) {
    return fmt::format(
        "no contact on the joint's seat carries its load of {:.6g} N: it "
        "points out of the seat, or almost",
        force);
  }
  if (report.contact == contact::Status::not_converged) {
    return fmt::format(
        "the contact under {:.6g} N was not found to full accuracy", force);
  }
  const std::string law = contact.half_angle_law().name();
  return std::isfinite(contact.half_angle(force).half_angle)
             ? fmt::format(
                   "half-angle law {} and pressure law {} give no friction "
                   "under {:.6g} N",
                   law, contact.pressure_law().name(), force)
             : fmt::format("half-angle law {} has no value under {:.6g} N", law,
                           force);
}

}  // namespace

std::string MotionFailure::message() const {
  if (body < 0) return reason;
  if (joint < 0) return fmt::format("{} (body {})", reason, body);
  return fmt::format("{} (body {}, joint {})", reason, body, joint);
}

Motion::Motion(const System& system, std::vector<HingeFriction> friction,
               std::shared_ptr<const ForceModel> forces,
               const MotionStart& start, const MotionOptions& options)
    : options_(checked_options(system, start, options)), now_(start.time) {
  equations_ = std::make_unique<Equations>(system, std::move(friction),
                                           std::move(forces), options_);
  view_ = std::make_unique<MotionSample>(*equations_);
  const auto made_by = [equations = equations_.get()](auto function) {
    return std::bind_front(function, equations);
  };
  const Rates rates{made_by(&Equations::rates_in_step),
                    made_by(&Equations::rates_aside)};
  stepper_ = options_.integrator == Integrator::rk4
                 ? make_rk4_stepper(rates, options_.step)
                 : make_adaptive_stepper(
                       rates, {options_.relative_tolerance,
                               options_.absolute_tolerance,
                               options_.longest_step, system.size()});
  hinges_ = std::make_unique<HingeChanges>(*equations_, *view_, options_);
  hinge_events_ = std::make_unique<HingeEvents>(*equations_, *view_, *stepper_,
                                                *hinges_, options_);
  path_ = std::make_unique<StepPath>(*equations_, *stepper_);
  kinks_ = std::make_unique<ForceKinks>(*equations_, *view_);
  user_events_ = std::make_unique<UserEvents>(*view_);
  resume(start_state(*equations_, start));
  // Hinges at rest at the start have not come to rest.
  hinges_->forget();
}

Motion::~Motion() = default;
Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;

void Motion::set_failure(const CoupledReport& report, double time) {
  const std::string why =
      report.status == CoupledStatus::no_contact
          ? reason(equations_->coupled.hinge(report.body).solver, report)
          : reason(report.status);
  failure_ = MotionFailure{report.status,
                           time,
                           report.body,
                           fmt::format("at {} s: {}", time, why),
                           {},
                           report.joint};
  if (report.status == CoupledStatus::several_solutions) {
    failure_->solutions = equations_->last().solutions;
  }
}

// Restarts from a state in which hinges may have other modes. After a failure
// the motion stays in that state.
bool Motion::resume(std::vector<double> state, bool due) {
  const CoupledReport report = hinges_->resolve_rest(now_, state, due);
  if (report.status != CoupledStatus::ok) set_failure(report, now_);
  restart(std::move(state));
  return !failure_;
}

void Motion::restart(std::vector<double> state) {
  normalise(equations_->system, equations_->coupled.layout(),
            equations_->modes(), state.data());
  pending_.clear();
  stepper_->restart(now_, state);
  view_->show(now_, state);
}

bool Motion::redo_step_to(double time) {
  // A single step, unless the error control wants several.
  stepper_->set_next_step(time - stepper_->begin());
  stepper_->restart_at_begin();
  return stepper_->step(time);
}

// Repeats the last step while forces have kinks in it: the part after a kink
// was computed with the wrong piece of their tables.
bool Motion::end_at_kink() {
  const double planned = stepper_->next_step();
  constexpr int most = 50;
  for (int i = 0; i < most; ++i) {
    const std::optional<double> time = kinks_->first(*stepper_);
    if (!time) break;
    if (!redo_step_to(*time)) return false;
    stepper_->set_next_step(std::max(stepper_->next_step(), planned));
  }
  return true;
}

// Ends the last step at a time by recomputing it, so that later results do not
// depend on interpolation.
void Motion::go_to(double time) {
  if (time != stepper_->end()) redo_step_to(time);
  while (stepper_->end() < time) {
    if (!stepper_->step(time)) break;
  }
  view_->show(time, stepper_->end_state());
  pending_.clear();
}

// Results before a break must not be used after it.
bool Motion::pass_break() {
  const double next = equations_->break_after(stepper_->end());
  if (next == equations_->next_break) return false;
  equations_->next_break = next;
  stepper_->restart_at_end();
  return true;
}

// Between the steps, after all looks into the last one.
void Motion::keep_on_cones() {
  if (!hinges_->any_on_cones()) return;
  const std::span<const double> end = stepper_->end_state();
  std::vector<double> state(end.begin(), end.end());
  hinges_->put_on_cones(state);
  stepper_->restart(stepper_->end(), state);
}

void Motion::show_step(double time) {
  if (!step_watch_) return;
  view_->show(time, stepper_->end_state());
  step_watch_(*view_);
}

// Freezes the direction of a ball joint that has just begun to slide, if its
// motion has stalled with an undefined direction, until the joint is faster.
// True: repeat the last step.
bool Motion::keep_directions() {
  CoupledDynamics& coupled = equations_->coupled;
  std::vector<int> following;
  for (int i = 0; i < coupled.size(); ++i) {
    if (coupled.hinge(i).follows) following.push_back(i);
  }
  if (following.empty()) return false;
  view_->show(stepper_->begin(), stepper_->begin_state());
  view_->work_out();
  for (const int i : following) {
    equations_->memory.hinges[i].direction =
        view_->hinges().memory(i).direction;
    coupled.slide_straight(i, true);
  }
  stepper_->restart_at_begin();
  return true;
}

// The first events in the last step. An application's event at a stop, such as
// a latch that catches the body, comes before the stop.
std::vector<StepEvent> Motion::find_events() {
  user_events_->sample(*stepper_);
  std::vector<StepEvent> hinges = hinge_events_->first();
  const std::optional<StepEvent> user = user_events_->first(*stepper_);
  if (!user || hinges.empty()) {
    return user ? std::vector{*user} : std::move(hinges);
  }
  const bool hits = hinges.front().kind == StepEvent::Kind::hits_stop;
  const double first = hinges.front().time;
  const double instant = hits ? 1e-12 * (1 + std::abs(first)) : 0;
  return user->time < first + instant ? std::vector{*user} : std::move(hinges);
}

bool Motion::step() {
  const double before_break = std::nextafter(equations_->next_break, -infinity);
  show_step(std::min(stepper_->end(), before_break));
  if (pass_break()) show_step(stepper_->end());
  keep_on_cones();
  const double from = stepper_->end();
  if (!stepper_->step(equations_->next_break) || !end_at_kink()) {
    if (keep_directions()) return true;
    now_ = from;
    view_->show(now_, stepper_->begin_state());
    // Why, if a coupled evaluation did not come out.
    const CoupledReport& failed = equations_->failed_report;
    if (failed.status != CoupledStatus::ok && equations_->failed_time >= from) {
      set_failure(failed, equations_->failed_time);
    } else {
      set_failure({}, from);
    }
    return false;
  }
  ++steps_;
  pending_.clear();
  std::vector<StepEvent> found = find_events();
  if (found.empty()) {
    user_events_->go_on();
    return true;
  }
  const double time = found.front().time;
  const double planned = stepper_->next_step();
  if (time <= stepper_->begin()) {
    stepper_->restart_at_begin();
  } else if (time < stepper_->end() && !redo_step_to(time)) {
    if (keep_directions()) return true;
    set_failure({}, stepper_->end());
    return false;
  }
  // Takes several steps: what comes before the event may still be queried, so
  // each is a separate step.
  if (stepper_->end() < time) {
    view_->show(stepper_->end(), stepper_->end_state());
    user_events_->go_on_from_view();
    return true;
  }
  // A step shortened for another reason does not predict the next one; after
  // the change of a hinge first steps are short.
  if (found.front().kind == StepEvent::Kind::user) {
    stepper_->set_next_step(std::max(stepper_->next_step(), planned));
  }
  pending_ = std::move(found);
  return true;
}

Stop Motion::advance_to(double time) {
  event_ = -1;
  for (long steps = 0; !failure_; ++steps) {
    if (!pending_.empty() && pending_.front().time <= time) {
      if (handle(std::exchange(pending_, {}))) {
        return failure_ ? Stop::failed : Stop::event;
      }
      continue;
    }
    if (stepper_->end() >= time) {
      now_ = std::max(now_, time);
      view_->show(*stepper_, now_);
      return Stop::time;
    }
    if (steps >= options_.step_limit) {
      set_failure({}, stepper_->end());
      failure_->reason =
          fmt::format("at {} s: the limit of {} steps is reached",
                      stepper_->end(), options_.step_limit);
      break;
    }
    if (halt_ && halt_()) {
      now_ = stepper_->end();
      view_->show(stepper_->end(), stepper_->end_state());
      return Stop::halted;
    }
    if (!step()) break;
  }
  return Stop::failed;
}

// Handles a hinge's event as far as it changes only the state. True: decide
// again which hinges hold.
bool Motion::pass_event(const StepEvent& event, std::vector<double>& state) {
  const int i = event.index;
  switch (event.kind) {
    case StepEvent::Kind::slows_down:
    case StepEvent::Kind::speeds_up:
      hinges_->slide_straight(i, event.kind == StepEvent::Kind::slows_down);
      return false;
    case StepEvent::Kind::rest_ends:
      return true;
    case StepEvent::Kind::settles:
      hinges_->end_bounces(now_, i);
      return true;
    case StepEvent::Kind::leaves_stop:
      hinges_->leave_stop(now_, i);
      return true;
    default:
      hinges_->stop(i, state);
      hinges_->change(now_, i, HingeMode::resting);
      return true;
  }
}

// True for an event of the application, or the end.
bool Motion::handle(const std::vector<StepEvent>& found) {
  now_ = found.front().time;
  view_->show(now_, stepper_->end_state());
  if (found.front().kind == StepEvent::Kind::user) {
    user_events_->report(found.front());
    event_ = found.front().index;
    return true;
  }
  if (stepper_->begin() < now_) show_step(now_);
  if (changes_time_ != now_) changes_here_ = 0;
  changes_time_ = now_;
  std::vector<double> state = view_->state();
  bool due = false;
  bool resolve = false;
  std::vector<int> hits;
  for (const StepEvent& event : found) {
    const CoupledReport stuck{.status = CoupledStatus::not_converged,
                              .body = event.index};
    // Impacts of bodies on each other's stops die out, but slowly.
    const int most = 8 * equations_->size() + 100;
    if (++changes_here_ > most) {
      set_failure(stuck, now_);
      failure_->reason =
          fmt::format("at {} s: more than {} changes at one time", now_, most);
      return true;
    }
    if (const auto reason = hinges_->stalls(now_, event.index)) {
      set_failure(stuck, now_);
      failure_->reason = *reason;
      return true;
    }
    due |= event.kind == StepEvent::Kind::rest_ends;
    if (event.kind == StepEvent::Kind::hits_stop) {
      hits.push_back(event.index);
    } else {
      resolve |= pass_event(event, state);
    }
  }
  if (!hits.empty()) hinges_->hit(now_, hits, state);
  resolve |= !hits.empty();
  if (!resolve) {
    restart(std::move(state));
  } else if (!resume(std::move(state), due)) {
    return true;
  }
  const std::optional<int> jumped = user_events_->jumped();
  if (jumped) event_ = *jumped;
  return jumped.has_value();
}

// The state in view after a body's hinge is removed.
std::vector<double> Motion::let_go(int body, const std::vector<double>& from) {
  const CoupledDynamics& coupled = equations_->coupled;
  const StateLayout before = coupled.layout();
  hinges_->change(now_, body, HingeMode::released);
  equations_->keep_hinge_angle(body, view_->motions()[1 + body].hinge_angle);
  std::vector<double> state(equations_->number_count());
  std::copy_n(from.begin(), StateLayout::body_size, state.begin());
  for (int i = 0; i < coupled.size(); ++i) {
    const Link& link = equations_->system.links()[i];
    double* to = &state[equations_->offset(i)];
    if (i == body) {
      put_body(view_->motions()[1 + i], link.axes, to);
    } else {
      std::copy_n(&from[before.offset(i)],
                  StateLayout::link_size(link.kind, equations_->modes()[i]),
                  to);
    }
  }
  std::copy(from.begin() + before.size(), from.end(),
            state.begin() + coupled.layout().size());
  return state;
}

void Motion::change(const MotionChange& what) {
  const auto is = [&](HingeMode mode) {
    return [this, mode](int body) { return view_->mode(body) == mode; };
  };
  const auto fixed = [this](int body) { return is_fixed(view_->mode(body)); };
  const auto can_latch = [&](int body) {
    return !fixed(body) && view_->mode(body) != HingeMode::released;
  };
  if (!what.forces && std::ranges::none_of(what.unlocked, fixed) &&
      std::ranges::none_of(what.latched, can_latch) &&
      std::ranges::all_of(what.released, is(HingeMode::released))) {
    return;
  }
  go_to(now_);
  for (const int body : what.unlocked) {
    if (!fixed(body)) continue;
    const bool can_rest =
        equations_->coupled.can_rest(body, view_->state().data());
    hinges_->change(now_, body,
                    can_rest ? HingeMode::resting : HingeMode::sliding);
  }
  std::vector<double> state = view_->state();
  std::vector<int> latched;
  std::ranges::copy_if(what.latched, std::back_inserter(latched), can_latch);
  hinges_->latch(now_, latched, state);
  for (const int body : what.released) {
    if (view_->mode(body) != HingeMode::released) state = let_go(body, state);
  }
  if (what.forces) equations_->forces = *what.forces;
  resume(std::move(state));
}

int Motion::add_event(MotionEvent event) {
  go_to(now_);
  return user_events_->add(std::move(event));
}

void Motion::look_back(
    double time, const std::function<void(const MotionSample&)>& look) const {
  // Restores the view, whatever look() throws.
  struct Return {
    MotionSample& view;
    double time;
    std::vector<double> state;
    ~Return() { view.show(time, state); }
  } const back{*view_, view_->time(), view_->state()};
  view_->show(*stepper_, time);
  look(*view_);
}

BodyMotion Motion::place_back(int body, double time) const {
  return path_->place(body, time);
}

MotionState Motion::save() {
  go_to(now_);
  MotionState state;
  state.time = now_;
  state.numbers = view_->state();
  for (int i = 0; i < equations_->size(); ++i) {
    const Hinge& hinge = equations_->coupled.hinge(i);
    const HingeMemory& memory = equations_->memory.hinges[i];
    state.modes.push_back(hinge.mode);
    state.directions.push_back(memory.direction);
    state.friction.push_back(memory.moment);
    state.straight_from.push_back(hinge.straight ? hinges_->straight_from(i)
                                                 : 0);
    state.paces.push_back(hinge.follows ? memory.pace : 0);
    state.hinge_angles.push_back(view_->motions()[1 + i].hinge_angle);
    state.settle_times.push_back(hinges_->settle_time(i));
    state.rests_on.push_back(hinge.rests_on);
  }
  state.losses = equations_->losses;
  state.step = stepper_->next_step();
  const std::optional<MotionFailure> failure = failure_;
  restore(state);
  failure_ = failure;
  return state;
}

void Motion::restore(const MotionState& state) {
  check_layout(state, *equations_);
  failure_.reset();
  now_ = state.time;
  CoupledDynamics& coupled = equations_->coupled;
  equations_->memory = coupled.beginning();
  for (int i = 0; i < coupled.size(); ++i) {
    equations_->set_mode(i, state.modes[i]);
    coupled.rest_on(i, state.rests_on[i], equations_->memory);
    HingeMemory& memory = equations_->memory.hinges[i];
    memory.direction = state.directions[i];
    memory.moment = state.friction[i];
    coupled.slide_straight(i, state.straight_from[i] > 0);
    if (state.paces[i] > 0) {
      memory.pace = state.paces[i];
      coupled.follow_acceleration(i);
    }
    hinges_->restore(i, state.straight_from[i], state.settle_times[i]);
    view_->keep_hinge_angle(i, state.hinge_angles[i]);
    equations_->keep_hinge_angle(i, state.hinge_angles[i]);
  }
  equations_->losses = state.losses;
  equations_->begin_at(now_, state.numbers.data());
  changes_here_ = 0;
  stepper_->set_next_step(state.step);
  pending_.clear();
  stepper_->restart(now_, state.numbers);
  view_->show(now_, state.numbers);
  user_events_->restart();
}

const MotionSample& Motion::sample() const { return *view_; }
double Motion::step_begin() const { return stepper_->begin(); }
double Motion::last_step() const { return stepper_->end() - stepper_->begin(); }
int Motion::held_by() const {
  return equations_->owner_of(stepper_->largest_error());
}
const std::vector<HingeChange>& Motion::changes() const {
  return hinges_->all();
}
const std::vector<HingeImpact>& Motion::impacts() const {
  return hinges_->impacts();
}
MotionCounts Motion::counts() const {
  return {equations_->evaluations, steps_, equations_->outer_iterations,
          equations_->unproven};
}

}  // namespace multibody
