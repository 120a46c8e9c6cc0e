#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "hosts/fmu/model.hpp"
#include "hosts/joint_handle.hpp"

namespace contact_hosts::fmu {
namespace {

// Indices of the variables, in the order of variables_of_joints().
enum Place : std::size_t {
  late,
  wear_coefficient,
  stop_speed,
  reaction,
  rate = reaction + 3,
  axis = rate + 3,
  free_rate = axis + 3,
  inertia = free_rate + 3,
  held = inertia + 9,
  moment = held + 3,
  next_rate = moment + 3,
  holds = next_rate + 3,
  utilisation,
  half_angle,
  peak_pressure,
  heat,
  wear
};

void add_vector(std::vector<Variable>& to, Role role, const std::string& name,
                const std::string& unit, const std::string& meaning) {
  for (const char part : {'x', 'y', 'z'}) {
    to.push_back({name + '_' + part, role, unit, meaning});
  }
}

std::vector<Variable> variables_of_joints() {
  constexpr Role in = Role::input;
  constexpr Role out = Role::output;
  std::vector<Variable> all = {
      {"one_step_late", Role::parameter, "",
       "co-simulation: outputs belong to the inputs of the last step's start; "
       "false: to those set last",
       0, true},
      {"wear_coefficient", Role::parameter, "1/Pa",
       "volume worn off over load and path"},
      {"stop_speed", Role::parameter, "rad/s",
       "model exchange: a ball that is slower has come to rest", 1e-7}};
  add_vector(all, in, "reaction", "N",
             "R on the body; with a seat, as all vectors, in the axes of the "
             "body that has it");
  add_vector(all, in, "rate", "rad/s", "Dw of the body against the carrier");
  add_vector(all, in, "axis", "", "of a pin, unit vector; 0: that of Dw");
  add_vector(all, in, "free_rate", "rad/s",
             "co-simulation: Dw at the end of the step without this friction");
  for (const char row : {'x', 'y', 'z'}) {
    add_vector(all, in, std::string("inertia_") + row, "N.m.s",
               "co-simulation: inertia about the joint over the time step; "
               "all 0: no step, friction alone");
  }
  add_vector(all, in, "held_moment", "N.m",
             "moment on the body that friction has to supply at rest");
  add_vector(all, out, "moment", "N.m", "friction moment on the body");
  add_vector(all, out, "next_rate", "rad/s",
             "co-simulation: Dw at the end of the step with friction");
  const std::vector<Variable> numbers = {
      {"holds", out, "", "the joint rests", 0, true},
      {"utilisation", out, "", "of what the resting joint holds, up to 1"},
      {"half_angle", out, "rad",
       "of the contact; NaN where it ends, at a rim or by relief"},
      {"peak_pressure", out, "Pa", "of the contact"},
      {"heat", out, "W", "of friction"},
      {"wear_rate", out, "m3/s", "volume worn off in a second"}};
  all.insert(all.end(), numbers.begin(), numbers.end());
  return all;
}

// Checks a call that a host may repeat with other inputs.
void valued(contact_status status) {
  if (status == CONTACT_OUT_OF_RANGE || status == CONTACT_NOT_CONVERGED ||
      status == CONTACT_OUT_OF_SEAT) {
    throw NoValue(contact_last_message());
  }
  must(status);
}

// State carried between steps, which hosts save and restore.
struct State {
  contact_step last;  // the accepted step, from which the next starts
  contact_step now;   // friction of the present inputs
  double way[3];      // model exchange: direction of the slip, unit
  int rests;          // model exchange
  int released;       // released at the last event, still at rest
  int has_started;    // co-simulation: the initialization is over
  double widest = NAN, most = NAN;  // half-angle and pressure so far
  // For notes: the last contact at a rim, or the first one without a largest
  // pressure; 0 if none.
  contact_solution at_rim;
};

class JointModel : public Model {
 public:
  explicit JointModel(const std::string& resources)
      : Model(resources, variables_of_joints()) {}

  void start() override {
    if (is_exchange()) return;
    take();
    state_.has_started = 1;
  }

  std::vector<double> indicators() override {
    return {stop_indicator(), state_.rests ? over() : -1};
  }

  bool settle() override {
    if (state_.rests) {
      if (over() <= 0) return false;
      is_stale_ = true;
      std::copy_n(state_.now.rest.direction, 3, state_.way);
      state_.last.solution = state_.now.rest.slip;
      state_.rests = 0;
      state_.released = 1;
      return true;
    }
    const double speed = std::sqrt(dot(in(rate), in(rate)));
    const bool turned = dot(in(rate), state_.way) < 0;
    if (can_rest_ && (state_.released ? turned : is_slow(speed))) {
      state_.rests = 1;
      is_stale_ = true;
      state_.released = 0;
      return true;
    }
    if (speed > 0 && ahead() <= 0) turn_way(speed);
    is_stale_ = true;
    return false;
  }

  std::string notes() override {
    if (!joint_) return {};
    std::string all;
    for (std::size_t i = 0;
         const char* note = contact_joint_note(joint_.get(), i); ++i) {
      (all += note) += '\n';
    }
    const auto add = [&all](const std::string& more) {
      if (!all.empty() && all.back() != '\n' && !more.empty()) all += '\n';
      all += more;
    };
    add(text_of([this](char* text, std::size_t size) {
      return contact_joint_contact_notes(joint_.get(), state_.widest,
                                         state_.most, text, size);
    }));
    const bool was_there = state_.at_rim.normal_force > 0;
    const auto& solution = was_there ? state_.at_rim : state_.now.solution;
    add(text_of([&](char* text, std::size_t size) {
      return contact_joint_solution_notes(joint_.get(), &solution, text, size);
    }));
    return all;
  }

  bool accept() override {
    take();
    if (!state_.released) return false;
    if (ahead() > 0) state_.released = 0;
    return dot(in(rate), state_.way) < 0;
  }

 private:
  static double dot(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  const double* in(Place first) const { return &values_[first]; }

  void make() override {
    const auto keys = settings();
    const std::vector<contact_setting> given = c_settings(keys);
    contact_joint* read = nullptr;
    must(contact_joint_read(file().c_str(), given.data(), given.size(), &read));
    joint_.reset(read);
    contact_joint_size size;
    must(contact_joint_get_size(read, &size));
    is_ball_ = size.kind == CONTACT_BALL;
    can_rest_ = can_rest(read);
    state_ = {};
  }

  void step(double, double) override { take(); }

  // Outputs that lag by one step change only with a step.
  void evaluate() override {
    if (!is_exchange() && values_[late] == 1 && state_.has_started) return;
    find();
    show();
  }
  void take() {
    evaluate_now();
    state_.last = state_.now;
  }
  void evaluate_now() {
    find();
    show();
    is_stale_ = false;
  }

  void find() {
    if (is_exchange()) return state_.rests ? hold() : slide();
    const double* const w = in(inertia);
    if (std::all_of(w, w + 9, [](double x) { return x == 0; })) {
      return solve(in(rate));
    }
    contact_step_start start{};
    std::copy_n(in(reaction), 3, start.reaction);
    std::copy_n(in(rate), 3, start.angular_velocity);
    std::copy_n(in(free_rate), 3, start.free);
    std::copy_n(in(axis), 3, start.axis);
    valued(
        contact_joint_step(joint_.get(), &start, w, &state_.last, &state_.now));
  }

  // Computes the friction at a rate, and leaves the rate unchanged.
  void solve(const double* of) {
    contact_slip slip{};
    std::copy_n(in(reaction), 3, slip.reaction);
    std::copy_n(of, 3, slip.angular_velocity);
    std::copy_n(in(axis), 3, slip.axis);
    contact_step& now = state_.now;
    valued(contact_joint_solve(joint_.get(), &slip, &state_.last.solution,
                               &now.solution));
    std::copy_n(now.solution.friction_moment, 3, now.moment);
    std::copy_n(in(rate), 3, now.angular_velocity);
    now.holds = 0;
    now.rest = {};
  }

  // Smooths friction through the stop, which an event finds.
  double least() const { return is_ball_ ? values_[stop_speed] : 1e-12; }
  void slide() {
    double of[3];
    std::copy_n(in(rate), 3, of);
    const double speed =
        is_ball_ ? std::sqrt(dot(of, of)) : dot(of, state_.way);
    if (can_rest_ && speed < least() && dot(state_.way, state_.way) > 0) {
      for (int i = 0; i < 3; ++i) of[i] = least() * state_.way[i];
    }
    solve(of);
  }

  void hold() {
    contact_hold hold{};
    std::copy_n(in(reaction), 3, hold.reaction);
    std::copy_n(in(held), 3, hold.moment);
    std::copy_n(in(axis), 3, hold.axis);
    contact_step& now = state_.now;
    valued(contact_joint_at_rest(joint_.get(), &hold, &state_.last.rest,
                                 &now.rest));
    now.solution = now.rest.slip;
    std::copy_n(in(held), 3, now.moment);
    std::fill_n(now.angular_velocity, 3, 0.0);
    now.holds = 1;
  }

  void show() {
    const contact_step& now = state_.now;
    std::copy_n(now.moment, 3, &values_[moment]);
    std::copy_n(now.angular_velocity, 3, &values_[next_rate]);
    values_[holds] = now.holds;
    values_[utilisation] = now.rest.utilisation;
    values_[half_angle] = now.solution.half_angle;
    values_[peak_pressure] = now.solution.peak_pressure;
    state_.widest = std::fmax(state_.widest, now.solution.half_angle);
    state_.most = std::fmax(state_.most, now.solution.peak_pressure);
    // The maximum above has no meaning for a contact without a largest
    // pressure.
    const bool is_worst = state_.at_rim.normal_force > 0 &&
                          std::isnan(state_.at_rim.peak_pressure);
    if (std::isnan(now.solution.half_angle) && !is_worst) {
      state_.at_rim = now.solution;
    }
    values_[heat] = -dot(now.moment, now.angular_velocity);
    values_[wear] = wear_rate();
  }

  double wear_rate() const {
    const contact_step& now = state_.now;
    if (values_[wear_coefficient] == 0 || now.holds) return 0;
    contact_slip slip{};
    std::copy_n(now.angular_velocity, 3, slip.angular_velocity);
    double pv;
    valued(contact_rating_get(joint_.get(), &slip, &now.solution, "pv_total",
                              &pv));
    return values_[wear_coefficient] * pv;
  }

  // Distance of a resting joint from its limit; above 0 the joint is released.
  double over() {
    evaluate_now();
    return state_.now.rest.utilisation - 1 - (is_ball_ ? 1e-8 : 1e-10);
  }
  // Speed of a sliding joint along its slip; 0 where it may have stopped.
  double ahead() const {
    return dot(in(rate), state_.way) - (is_ball_ ? values_[stop_speed] : 0);
  }
  double stop_indicator() const {
    const bool may_stop = can_rest_ && !state_.rests && !state_.released &&
                          dot(state_.way, state_.way) > 0;
    return may_stop ? ahead() : 1;
  }
  bool is_slow(double speed) const {
    if (is_ball_) return speed <= 1.5 * values_[stop_speed];
    return speed == 0 ||
           (dot(state_.way, state_.way) > 0 && dot(in(rate), state_.way) <= 0);
  }
  void turn_way(double speed) {
    for (int i = 0; i < 3; ++i) state_.way[i] = in(rate)[i] / speed;
  }

  static_assert(std::is_trivially_copyable_v<State>);
  std::string state() override {
    return {reinterpret_cast<const char*>(&state_), sizeof state_};
  }
  void set_state(const std::string& bytes) override {
    if (bytes.size() != sizeof state_) {
      throw std::runtime_error("state must be one of this FMU");
    }
    std::memcpy(static_cast<void*>(&state_), bytes.data(), sizeof state_);
  }

  JointHandle joint_{nullptr, contact_joint_free};
  bool is_ball_ = true;
  bool can_rest_ = true;
  State state_{};
};

}  // namespace

std::unique_ptr<Model> joint_model(const std::string& resources) {
  return std::make_unique<JointModel>(resources);
}

}  // namespace contact_hosts::fmu
