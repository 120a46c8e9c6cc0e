#pragma once

#include "libcontact/base/lanes.hpp"
#include "libcontact/base/lanes/inverse_root.hpp"
#include "libcontact/base/lanes/select.hpp"
#include "multibody/tracking/tracker_exchange.hpp"
#include "multibody/tracking/tracker_state.hpp"

// The mathematics of joints in lanes: prediction by the secants for R and Dw.
// Part of tracker_kernel_impl.hpp.

namespace multibody::detail {
namespace {

using namespace contact::detail;

using Vector = Vec3<Lanes>;
using State = TrackerState<Lanes>;
using Frame = ReactionFrame<Lanes>;
using Slip = SlipState<Lanes>;
using Move = ContactMove<Lanes>;

[[gnu::always_inline]] inline Lanes load(const double* from) {
  return Lanes::load(from);
}
[[gnu::always_inline]] inline void store(const Lanes& x, double* to) {
  x.store(to);
}
// Vectors of joint k and those after it.
[[gnu::always_inline]] inline Vector load(const TrackerExchange::Vectors& from,
                                          int k) {
  return {load(from.x + k), load(from.y + k), load(from.z + k)};
}
[[gnu::always_inline]] inline void store(const Vector& v,
                                         TrackerExchange::Vectors& to, int k) {
  store(v.x, to.x + k);
  store(v.y, to.y + k);
  store(v.z, to.z + k);
}

// The larger number; NaN if one of them is NaN, which max() does not guarantee.
[[gnu::always_inline]] inline Lanes larger(const Lanes& a, const Lanes& b) {
  return select(a >= b, a, select(b >= a, b, a + b));
}
// ln(a/b) for a close to b; exact to its sixth power.
[[gnu::always_inline]] inline Lanes log_ratio(const Lanes& a, const Lanes& b) {
  const Lanes x = (a - b) / (a + b);
  const Lanes x2 = x * x;
  return x * (2.0 + x2 * (2.0 / 3 + x2 * (2.0 / 5)));
}
// ln(1 + x) for small x, to its seventh power.
[[gnu::always_inline]] inline Lanes log_of_growth(const Lanes& x) {
  const Lanes x2 = x * x;
  return x * ((1.0 - x * (1.0 / 2)) +
              x2 * ((1.0 / 3 - x * (1.0 / 4)) +
                    x2 * ((1.0 / 5 - x * (1.0 / 6)) + x2 * (1.0 / 7))));
}
// exp(x) for small x, to its fifth power.
[[gnu::always_inline]] inline Lanes exponential(const Lanes& x) {
  const Lanes x2 = x * x;
  return (1.0 + x) +
         x2 * ((1.0 / 2 + x * (1.0 / 6)) + x2 * (1.0 / 24 + x * (1.0 / 120)));
}

[[gnu::always_inline]] inline Frame frame_of(const Vector& force,
                                             const Vector& rate,
                                             const State& s) {
  Frame f;
  // Three roots side by side rather than one after the other.
  const Vector across = cross(rate, force);
  const Lanes across2 = dot(across, across);
  const Lanes speed2 = dot(rate, rate);
  const Lanes reaction2 = dot(force, force);
  const Lanes inverse_across = inverse_root(across2);
  const Lanes inverse_speed = inverse_root(speed2);
  const Lanes speed = speed2 * inverse_speed;
  // A pin takes the part of R normal to its axis, whatever rounding adds.
  const auto pin = s.is_ball == 0.0;
  f.inverse_reaction =
      select(pin, inverse_across * speed, inverse_root(reaction2));
  f.reaction = select(pin, across2 * inverse_across * inverse_speed,
                      reaction2 * f.inverse_reaction);
  const Lanes inverse = inverse_speed * f.inverse_reaction;
  f.w = inverse_speed * rate;
  f.q = inverse_across * across;
  f.p = cross(f.q, f.w);
  const Lanes cosine = s.is_ball * (dot(rate, force) * inverse);
  f.sine = select(pin, Lanes(1.0), across2 * inverse_across * inverse);
  f.inverse_sine =
      select(pin, Lanes(1.0), inverse_across * (speed * f.reaction));
  f.sign = select(cosine < 0.0, Lanes(-1.0), Lanes(1.0));
  f.cosine = f.sign * cosine;
  f.speed = select(s.is_viscous == 0.0, Lanes(1.0), speed);
  return f;
}

// Newton's step in ln tan psi; what depends on it by differentials.
[[gnu::always_inline]] inline void newton(Slip& t, const State& s,
                                          const Lanes& residual) {
  const auto fall = t.response();
  // docs/explanation/joint.md (6)
  t.inverse_slope = 1.0 / (1.0 + s.friction.by_force * fall.force +
                           2.0 * s.friction.by_cosine * fall.cosine);
  t.step = -residual * t.inverse_slope;
  t.squares += t.step * t.step;
  t.shift(t.step);
  t.move.force -= fall.force * t.step;
  t.move.cosine -= 2.0 * fall.cosine * t.step;
}

// Along the move v to the last contact, to which the slopes belong, the
// second-order part of a move by p/|v| is curvature * bend(p).
[[gnu::always_inline]] inline Lanes along(const State& s, const Move& m) {
  return m.force * s.last_move.force + m.cosine * s.last_move.cosine;
}
[[gnu::always_inline]] inline Lanes bend(const State& s, const Lanes& p) {
  return p * (p * s.inverse_square + 1.0);
}
// The same up to three lengths of that move: of short ones a curvature is
// mostly rounding, and motions that begin go on in ever longer ones.
[[gnu::always_inline]] inline Lanes useful_bend(const State& s, const Move& m) {
  const Lanes p = along(s, m);
  return select(
      s.is_known != 0.0, m.force * m.force,
      select(abs(p) * s.inverse_square < 3.0, bend(s, p), Lanes(0.0)));
}
// Change of ln F by a move.
[[gnu::always_inline]] inline Lanes growth(const Secants<Lanes>& f,
                                           const Move& m) {
  return f.by_force * m.force + f.by_cosine * m.cosine;
}
[[gnu::always_inline]] inline Lanes growth(const Secants<Lanes>& f,
                                           const Move& m, const Lanes& bend) {
  return growth(f, m) + f.curvature * bend;
}

// The root of ln tan psi - ln f/cos a for s.frame: a Newton step by the secants
// from the prediction of the last solution and its responses.
[[gnu::always_inline]] inline Slip solve(const State& s) {
  const Frame& f = s.frame;
  const Lanes reaction =
      log_of_growth(f.reaction * s.last_inverse_reaction - 1.0);
  const Lanes angle = f.sine * s.last_cosine - f.cosine * s.last_sine;
  const Lanes speed = log_ratio(f.speed, s.last_speed);
  const Lanes guess = s.tangent_by_reaction * reaction +
                      s.tangent_by_angle * angle + s.slip.inverse_slope * speed;
  Slip t;
  t.set(s.last_tangent * exponential(guess), f.sine, f.cosine);
  const Move move = {
      log_of_growth(f.reaction * t.cos_g * s.inverse_force - 1.0),
      2.0 * log_of_growth(t.axis_cos * s.inverse_axis_cosine - 1.0)};
  t.move = move;
  t.squares = 0.0;
  const Lanes expected = growth(s.friction, move, useful_bend(s, move)) + speed;
  newton(t, s, guess + s.last_residual - expected);
  t.trust = (1 / trust_radius) *
            larger(larger(abs(reaction) + abs(angle), abs(guess)),
                   larger(abs(move.force) + abs(move.cosine), abs(t.step)));
  return t;
}

// M_t at s.slip, and the slopes of M_t and tan psi over R:
//   M_t = -rho R_n ((Y C^2 + Z S^2) w + S C (Z - Y) d),  C, S = cos a, sin a,
//   d = p cos psi + s q sin psi,  Y = c_Y/cos a, Z = c_Z/sin a
[[gnu::always_inline]] inline void set_moment(State& s) {
  const Frame& f = s.frame;
  const Slip& t = s.slip;
  const Lanes second = useful_bend(s, t.move);
  const Lanes sliding = s.sliding.value * f.speed *
                        exponential(growth(s.sliding, t.move, second));
  const Lanes spinning = s.spinning.value * f.speed *
                         exponential(growth(s.spinning, t.move, second));
  const Lanes scale = -s.radius * f.reaction * t.cos_g;
  const Lanes c2 = t.axis_cos * t.axis_cos;
  const Lanes s2 = t.axis_sin * t.axis_sin;
  const Lanes sc = f.sign * t.axis_sin * t.axis_cos;
  const Lanes difference = spinning - sliding;
  const Lanes length = sliding * c2 + spinning * s2;
  const Lanes across = sc * difference;
  const Vector d = t.cos_psi * f.p + s.side * t.sin_psi * f.q;
  const Vector turned = t.cos_psi * f.q - s.side * t.sin_psi * f.p;
  s.moment = scale * (length * f.w + across * d);

  // Slopes of ln cos g and ln cos^2 a over ln R, b and ln tan psi.
  const Lanes sin2_psi = t.sin_psi * t.sin_psi;
  const Lanes inverse_g = 1.0 / t.cos_g;
  const Lanes inverse_g2 = inverse_g * inverse_g;
  const Lanes g_by_angle = -f.sine * f.cosine * sin2_psi * inverse_g2;
  const Lanes cosine_by_angle = 2.0 * f.cosine * f.inverse_sine * inverse_g2;
  const auto change = [&](const Lanes& reaction, const Lanes& angle,
                          const Lanes& tangent) __attribute__((always_inline)) {
    const Lanes cos_g = g_by_angle * angle - sin2_psi * c2 * tangent;
    const Move move = {reaction + cos_g,
                       cosine_by_angle * angle - 2.0 * sin2_psi * s2 * tangent};
    const Lanes d_sliding = sliding * growth(s.sliding, move);
    const Lanes d_spinning = spinning * growth(s.spinning, move);
    const Lanes d_length =
        d_sliding * c2 + d_spinning * s2 - difference * c2 * move.cosine;
    // sin a = cos b/cos g
    const Lanes d_sine = -f.sine * inverse_g * angle - t.axis_sin * cos_g;
    const Lanes d_sc =
        f.sign * t.axis_cos * (d_sine + 0.5 * t.axis_sin * move.cosine);
    const Lanes d_across = sc * (d_spinning - d_sliding) + d_sc * difference;
    return scale * ((d_length + move.force * length) * f.w +
                    (d_across + move.force * across) * d +
                    s.side * across * t.sin_psi * t.cos_psi * tangent * turned);
  };
  s.tangent_by_reaction = s.friction.by_force * t.inverse_slope;
  s.tangent_by_angle = (s.friction.by_cosine * cosine_by_angle +
                        s.friction.by_force * g_by_angle) *
                       t.inverse_slope;
  const Lanes one(1.0), none(0.0);
  const Vector by_reaction = change(one, none, s.tangent_by_reaction);
  const Vector by_angle = change(none, one, s.tangent_by_angle);
  const Vector by_turn = scale * across * turned;
  // d ln R, db and the turn about w over dR.
  const Lanes inverse = f.inverse_reaction;
  const Vector along = inverse * (f.sign * f.cosine * f.w + f.sine * f.p);
  const Vector tilt =
      s.is_ball * inverse * (f.cosine * f.p - f.sign * f.sine * f.w);
  const Vector turn = inverse * f.inverse_sine * f.q;
  const auto column = [&](const Lanes& a, const Lanes& b, const Lanes& c) {
    return a * by_reaction + b * by_angle + c * by_turn;
  };
  s.jacobian = {column(along.x, tilt.x, turn.x),
                column(along.y, tilt.y, turn.y),
                column(along.z, tilt.z, turn.z)};
}

}  // namespace
}  // namespace multibody::detail
