#pragma once

// Included once by each tracker_kernel_*.cpp, which is compiled for its own
// instruction set.

#include <cmath>
#include <limits>

#include "multibody/tracking/tracker_kernel.hpp"
#include "multibody/tracking/tracker_lanes.hpp"

namespace multibody::detail {
namespace {

static_assert(TrackerExchange::size % width == 0);

// The kernel's functions are flattened: they call so many small ones that the
// compiler's limits on the growth of a file would leave some of them out.

// f(state, exchange, lane) of every packet of joints.
template <class F>
[[gnu::always_inline]] inline void for_all(const TrackerJoints& joints, F f) {
  constexpr int size = TrackerExchange::size;
  auto* state = static_cast<State*>(joints.states);
  for (int i = 0; i < joints.size; i += width) {
    f(*state++, joints.exchange[i / size], i % size);
  }
}
// As above, for packets with a tracked joint.
template <class F>
[[gnu::always_inline]] inline void for_joints(const TrackerJoints& joints,
                                              F f) {
  for_all(
      joints, [&](State & s, TrackerExchange & e, int k)
                  __attribute__((always_inline)) {
                    if (any_of(load(e.tracked + k) != 0.0)) f(s, e, k);
                  });
}

// Largest values over the tracked joints, NaN as infinity.
class Largest {
 public:
  explicit Largest(const TrackerJoints& joints) : floor_(joints.moment_floor) {}

  [[gnu::always_inline]] void add(const TrackerExchange& e, int k) {
    const auto none = load(e.tracked + k) == 0.0;
    const auto raise = [&](Lanes& most, const Lanes& x) {
      most = max(most, select(none, zero_, select(x >= zero_, x, infinity_)));
    };
    const Vector moment = load(e.moment, k);
    const Vector residual = moment - load(e.applied, k);
    raise(trust_, load(e.trust + k));
    raise(error_, load(e.error + k));
    raise(residual_,
          dot(residual, residual) / (4.0 * dot(moment, moment) + floor_));
  }
  TrackerLargest result() const {
    const double residual = std::sqrt(hmax(residual_));
    return {hmax(trust_), hmax(error_), residual, residual};
  }

 private:
  double floor_;
  Lanes trust_ = 0.0, error_ = 0.0, residual_ = 0.0;
  // Once: inside add() compilers make functions of them.
  const Lanes zero_ = 0.0;
  const Lanes infinity_ = std::numeric_limits<double>::infinity();
};

// The worst of 1200 random joints on paths of steps of 1e-3 was wrong by 3.1
// times what the errors of its slopes say (tracking/joint_tracker_test.cpp).
constexpr double error_safety = 5;

// A prediction at the present R by s.slip.
[[gnu::always_inline]] inline void set_prediction(State& s, TrackerExchange& e,
                                                  int k) {
  set_moment(s);
  s.reaction = load(e.reaction, k);
  // Errors of the slopes since the last evaluation, and of Newton's steps.
  const Slip& t = s.slip;
  s.error = s.slope_error * (abs(t.move.force) + abs(t.move.cosine)) +
            t.sin_psi * t.squares;
  store(s.moment, e.moment, k);
  store(error_safety * s.error, e.error + k);
}

// The present R and Dw, and the prediction of the secants.
[[gnu::always_inline]] inline void set_slip(State& s, TrackerExchange& e,
                                            int k) {
  s.frame = frame_of(load(e.reaction, k), load(e.rate, k), s);
  s.slip = solve(s);
  store(larger(s.slip.trust, s.frame.inverse_sine * (1 / largest_inverse_sine)),
        e.trust + k);
}

[[gnu::always_inline]] inline void extend(State& s, TrackerExchange& e, int k) {
  const Frame& f = s.frame;
  const Vector change = load(e.reaction, k) - s.reaction;
  store(s.moment + s.jacobian * change, e.moment, k);
  // Over R sin b. The contact moves by it and, as cos a does over b, by twice.
  const Vector felt = change - (1.0 - s.is_ball) * dot(change, f.w) * f.w;
  const Lanes shift = f.inverse_reaction * f.inverse_sine *
                      (abs(felt.x) + abs(felt.y) + abs(felt.z));
  store(error_safety * (s.error + shift * (2.0 * s.slope_error + shift)),
        e.error + k);
}
// Packets with an error above this in a joint.
[[gnu::flatten]] TrackerLargest predict(const TrackerJoints& joints,
                                        double enough) {
  Largest most(joints);
  for_joints(joints, [&](State& s, TrackerExchange& e, int k) {
    const Lanes error = load(e.error + k);  // below 0 where M_t is far off
    const auto settled = error >= 0.0 && error <= enough;
    if (all_of(settled || load(e.tracked + k) == 0.0)) {
      for (double* row : {e.due, e.asked, e.exact}) store(Lanes(0.0), row + k);
      extend(s, e, k);
    } else {
      store(Lanes(1.0), e.due + k);
      set_slip(s, e, k);
      set_prediction(s, e, k);
    }
    most.add(e, k);
  });
  return most.result();
}

[[gnu::flatten]] TrackerLargest extend(const TrackerJoints& joints) {
  Largest most(joints);
  for_joints(joints, [&](State& s, TrackerExchange& e, int k) {
    extend(s, e, k);
    most.add(e, k);
  });
  return most.result();
}

// The contact predicted by the secants, and its values from the window.
[[gnu::always_inline]] inline void set_contact(State& s, TrackerExchange& e,
                                               int k) {
  set_slip(s, e, k);
  const Lanes force = s.frame.reaction * s.slip.cos_g;
  const Lanes place = s.window.place(force);
  const Lanes first = s.window.value(s.window.first, place);
  const Lanes second = s.window.value(s.window.second, place);
  store(force, e.force + k);
  store(max(s.slip.axis_sin, Lanes(smallest_axis)), e.axis_sin + k);
  store(max(s.slip.axis_cos, Lanes(smallest_axis)), e.axis_cos + k);
  store(first, e.half_angle_sin + k);
  store(second, e.half_angle_cos + k);
  store(first, e.friction + k);
  store(second, e.sliding + k);
  store(Lanes(0.0), e.spinning + k);
  const auto tracked = load(e.tracked + k) != 0.0;
  const auto inside = abs(place) <= 1.0;
  const auto known = inside && (s.is_ball == 0.0 || s.is_plain != 0.0);
  const Lanes one(1.0), none(0.0);
  store(select(inside, none, one), e.outside + k);
  store(select(tracked && !known, one, none), e.asked + k);
  store(select(tracked, s.is_plain, none), e.exact + k);
}

[[gnu::flatten]] TrackerLargest prepare(const TrackerJoints& joints) {
  Largest most(joints);
  for_joints(joints, [&](State& s, TrackerExchange& e, int k) {
    extend(s, e, k);
    most.add(e, k);
    if (e.due[k] != 0) set_contact(s, e, k);
  });
  return most.result();
}

// Functions of R_n alone need no learning: for a pin the window has them all.
[[gnu::always_inline]] inline void take_window(State& s,
                                               const TrackerExchange& e,
                                               int k) {
  const auto known = s.is_ball == 0.0 && load(e.outside + k) == 0.0;
  s.is_known = select(known, Lanes(1.0), Lanes(0.0));
  if (none_of(known)) return;
  const Lanes force = load(e.force + k);
  const auto take = [&](Secants<Lanes> & f, const Lanes(&differences)[12])
      __attribute__((always_inline)) {
    const Secants<Lanes> told = s.window.tangent(differences, force);
    f.by_force = select(known, told.by_force, f.by_force);
    f.by_cosine = select(known, told.by_cosine, f.by_cosine);
    f.curvature = select(known, told.curvature, f.curvature);
  };
  take(s.friction, s.window.first);
  take(s.sliding, s.window.second);
  s.slope_error = select(known, Lanes(0.0), s.slope_error);
}

// Values by (3.7), (3.8) from the integrals, if not given.
[[gnu::always_inline]] inline void take_integrals(const State& s,
                                                  TrackerExchange& e, int k) {
  const auto exact = s.is_plain != 0.0;
  const Lanes area = s.area_part * s.inverse_force;
  const auto take = [&](double* row, int i, const Lanes& over) {
    const Lanes value = s.pressure_part * load(e.integrals[i] + k) +
                        area * load(e.integrals[i + 3] + k);
    store(select(exact, value * over, load(row + k)), row + k);
  };
  take(e.friction, 0, s.inverse_axis_cosine);
  take(e.sliding, 1, s.inverse_axis_cosine);
  take(e.spinning, 2, 1.0 / load(e.axis_sin + k));
}

// Broyden's update of all slopes by the values at the contact of s.slip.
[[gnu::always_inline]] inline void learn(State& s, const TrackerExchange& e,
                                         int k) {
  // Moves so short have errors of 1e-8 of their length and more by rounding,
  // 1e-16, and carry no information. Nor do moves beyond the range of the
  // series.
  constexpr double shortest = 1e-8;
  constexpr double largest_miss = trust_radius;
  const Move& move = s.slip.move;
  const Lanes square = move.force * move.force + move.cosine * move.cosine;
  const auto tells = square > shortest * shortest;
  const Lanes inverse = 1.0 / select(tells, square, Lanes(1.0));
  // A curvature: on the same line (cosine, squared: 27 deg), and not back near
  // where it came from, where its share vanishes.
  const Lanes p = along(s, move);
  const Lanes product = bend(s, p);
  const auto bends = tells && p * p * s.inverse_square > 0.8 * square &&
                     abs(product) > 0.2 * square;
  const Lanes inverse_bend = 1.0 / select(bends, product, Lanes(1.0));
  // @return errors of the slopes
  const auto update = [&](Secants<Lanes> & f, const Lanes& found)
      __attribute__((always_inline)) {
    // (A pin has no spinning moment.)
    const Lanes grown =
        select(found == f.value, Lanes(0.0), log_ratio(found, f.value));
    const Lanes missed = grown - growth(f, move);
    const auto fair = abs(missed) < largest_miss;
    const Lanes share = select(tells && fair, missed * inverse, Lanes(0.0));
    f.by_force += share * move.force;
    f.by_cosine += share * move.cosine;
    f.curvature = select(bends, select(fair, missed * inverse_bend, Lanes(0.0)),
                         f.curvature);
    f.value = found;
    return abs(missed);
  };
  const Lanes friction = update(s.friction, load(e.friction + k));
  const Lanes sliding = update(s.sliding, load(e.sliding + k));
  const Lanes spinning = update(s.spinning, load(e.spinning + k));
  // Weighted by the effect of each on the moment.
  const Lanes y = s.sliding.value * s.slip.axis_cos;
  const Lanes z = s.spinning.value * s.slip.axis_sin;
  const Lanes missed =
      friction * s.slip.sin_psi + (sliding * y + spinning * z) / (y + z);
  // Slopes across the line that the contact has gone are not looked at: errors
  // are forgotten slowly, and never below a percent. (With no memory error() is
  // too small by twice as much on paths of steps of 1e-4.)
  s.slope_error = select(
      tells, max(max(0.7 * s.slope_error, missed * sqrt(inverse)), Lanes(1e-2)),
      s.slope_error);
  s.last_move = {select(tells, move.force, s.last_move.force),
                 select(tells, move.cosine, s.last_move.cosine)};
  s.inverse_square = select(tells, inverse, s.inverse_square);
}

// Takes the values at the contact of s.slip, then a Newton step from there.
[[gnu::always_inline]] inline void correct(State& s, TrackerExchange& e,
                                           int k) {
  const Frame& f = s.frame;
  Slip& t = s.slip;
  s.inverse_force = 1.0 / load(e.force + k);
  s.inverse_axis_cosine = 1.0 / load(e.axis_cos + k);
  take_integrals(s, e, k);
  learn(s, e, k);
  take_window(s, e, k);
  t.move = {Lanes(0.0), Lanes(0.0)};
  const Lanes value = s.friction.value * f.speed;
  newton(t, s, log_ratio(t.tangent, value));
  store(larger(load(e.trust + k), abs(t.step) * (1 / trust_radius)),
        e.trust + k);
  set_prediction(s, e, k);
  s.last_inverse_reaction = f.inverse_reaction;
  s.last_sine = f.sine;
  s.last_cosine = f.cosine;
  s.last_speed = f.speed;
  s.last_tangent = t.tangent;
  s.last_residual = log_ratio(t.tangent, value);
}
[[gnu::flatten]] TrackerLargest correct(const TrackerJoints& joints) {
  Largest most(joints);
  for_joints(joints, [&](State& s, TrackerExchange& e, int k) {
    if (e.due[k] != 0) correct(s, e, k);
    most.add(e, k);
  });
  return most.result();
}

[[gnu::flatten]] void step(const TrackerJoints& joints) {
  for_all(joints, [](State&, TrackerExchange& e, int k) {
    const Vector applied = load(e.applied, k);
    const Vector residual = load(e.moment, k) - applied;
    // Lanes without a joint have step 0.
    const auto none = load(e.tracked + k) == 0.0;
    const Vector step = {select(none, Lanes(0.0), residual.x),
                         select(none, Lanes(0.0), residual.y),
                         select(none, Lanes(0.0), residual.z)};
    store(step, e.step, k);
    store(applied + step, e.applied, k);
  });
}

[[gnu::flatten]] void keep(const TrackerJoints& joints) {
  for_all(joints, [](State& s, TrackerExchange& e, int k) {
    const Vector applied = load(e.applied, k);
    s.stretch = applied - s.kept;
    s.kept = applied;
  });
}

[[gnu::flatten]] void extrapolate(const TrackerJoints& joints, double share) {
  for_all(joints, [&](State& s, TrackerExchange& e, int k) {
    store(s.kept + share * s.stretch, e.applied, k);
  });
}

constexpr TrackerKernel make_kernel() {
  return {width, predict, extend, prepare, correct, step, keep, extrapolate};
}

}  // namespace
}  // namespace multibody::detail
