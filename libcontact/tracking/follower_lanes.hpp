#pragma once

#include "libcontact/base/inverse_root.hpp"
#include "libcontact/base/lanes.hpp"
#include "libcontact/base/select.hpp"
#include "libcontact/tracking/follower_kernel.hpp"

// Joints in lanes: their rows, the geometry of R and Dw, what the contact's
// moves and slopes tell. Part of follower_kernel_impl.hpp.

namespace contact::detail {
namespace {

static_assert(FollowerRows::lanes % width == 0);
using Row = FollowerRow;

// Lanes of one packet of joints in all rows.
class Packet {
 public:
  Packet(FollowerRows rows, int first)
      : numbers_(rows.at(static_cast<Row>(0), first)) {}
  [[gnu::always_inline]] Lanes operator[](Row row) const {
    return Lanes(at(row), stdx::element_aligned);
  }
  [[gnu::always_inline]] void set(Row row, const Lanes& x) const {
    x.copy_to(at(row), stdx::element_aligned);
  }

 private:
  double* at(Row row) const {
    return numbers_ + static_cast<int>(row) * FollowerRows::lanes;
  }

  double* numbers_;
};

struct Vector {
  Lanes x, y, z;
};
[[gnu::always_inline]] inline Vector operator+(const Vector& a,
                                               const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Vector operator-(const Vector& a,
                                               const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Vector operator*(const Lanes& s,
                                               const Vector& v) {
  return {s * v.x, s * v.y, s * v.z};
}
[[gnu::always_inline]] inline Lanes dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[gnu::always_inline]] inline Vector get(const Packet& p, Row x, Row y, Row z) {
  return {p[x], p[y], p[z]};
}
[[gnu::always_inline]] inline void set(const Packet& p, Row first,
                                       const Vector& v) {
  const auto next = [first](int i) {
    return static_cast<Row>(static_cast<int>(first) + i);
  };
  p.set(next(0), v.x);
  p.set(next(1), v.y);
  p.set(next(2), v.z);
}

// The larger one; NaN if one of them is, which max() does not promise.
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

// R and Dw: e = w cos b + p sin b, q = w x p.
struct Frame {
  Vector w, p, q;
  Lanes reaction, inverse_reaction;
  Lanes sine, cosine;  // of min(b, pi - b)
  Lanes inverse_sine;
  Lanes sign;   // of cos b
  Lanes speed;  // 1 if friction is dry
};

[[gnu::always_inline]] inline Frame frame_of(const Packet& p) {
  Frame f;
  const Vector force =
      get(p, Row::reaction_x, Row::reaction_y, Row::reaction_z);
  const Vector rate = get(p, Row::rate_x, Row::rate_y, Row::rate_z);
  // Three roots side by side rather than one after the other.
  const Vector across = cross(rate, force);
  const Lanes across2 = dot(across, across);
  const Lanes speed2 = dot(rate, rate);
  const Lanes reaction2 = dot(force, force);
  const Lanes inverse_across = inverse_root(across2);
  const Lanes inverse_speed = inverse_root(speed2);
  const Lanes speed = speed2 * inverse_speed;
  // Of a pin what is normal to its axis, rounding or not.
  const Lanes ball = p[Row::ball];
  const auto pin = ball == 0.0;
  f.inverse_reaction =
      select(pin, inverse_across * speed, inverse_root(reaction2));
  f.reaction = select(pin, across2 * inverse_across * inverse_speed,
                      reaction2 * f.inverse_reaction);
  const Lanes inverse = inverse_speed * f.inverse_reaction;
  f.w = inverse_speed * rate;
  f.q = inverse_across * across;
  f.p = cross(f.q, f.w);
  const Lanes cosine = ball * (dot(rate, force) * inverse);
  f.sine = select(pin, Lanes(1.0), across2 * inverse_across * inverse);
  f.inverse_sine =
      select(pin, Lanes(1.0), inverse_across * (speed * f.reaction));
  f.sign = select(cosine < 0.0, Lanes(-1.0), Lanes(1.0));
  f.cosine = f.sign * cosine;
  f.speed = select(p[Row::viscous] == 0.0, Lanes(1.0), speed);
  return f;
}

// SlipTriangle, in lanes.
struct Triangle {
  Lanes sin_psi, cos_psi, cos_g, axis_sine, axis_cosine;
};
[[gnu::always_inline]] inline Triangle triangle_of(const Lanes& tangent,
                                                   const Frame& f) {
  const Lanes leg = f.cosine * tangent;
  const Lanes r2 = 1.0 + tangent * tangent;
  const Lanes s2 = 1.0 + leg * leg;
  const auto [inverse_r, inverse_s] = inverse_roots(r2, s2);
  Triangle t;
  t.cos_psi = inverse_r;
  t.sin_psi = tangent * inverse_r;
  t.cos_g = s2 * inverse_s * inverse_r;
  t.axis_sine = f.cosine * (r2 * inverse_r * inverse_s);
  t.axis_cosine = f.sine * inverse_s;
  return t;
}

// Moves of the contact from the last evaluation.
struct Move {
  Lanes force, cosine;  // ln R_n, ln cos^2 a
};
[[gnu::always_inline]] inline Move move_of(const Packet& p, const Frame& f,
                                           const Triangle& t) {
  return {
      log_of_growth(f.reaction * t.cos_g * p[Row::last_inverse_force] - 1.0),
      2.0 * log_of_growth(t.axis_cosine * p[Row::last_inverse_axis_cosine] -
                          1.0)};
}

struct Slopes {
  Lanes force, cosine;
};
[[gnu::always_inline]] inline Slopes slopes(const Packet& p, Row by_force,
                                            Row by_cosine) {
  return {p[by_force], p[by_cosine]};
}
[[gnu::always_inline]] inline Slopes friction_slopes(const Packet& p) {
  return slopes(p, Row::friction_by_force, Row::friction_by_cosine);
}
[[gnu::always_inline]] inline Slopes sliding_slopes(const Packet& p) {
  return slopes(p, Row::sliding_by_force, Row::sliding_by_cosine);
}
[[gnu::always_inline]] inline Slopes spinning_slopes(const Packet& p) {
  return slopes(p, Row::spinning_by_force, Row::spinning_by_cosine);
}
[[gnu::always_inline]] inline Lanes along(const Slopes& s, const Move& m) {
  return s.force * m.force + s.cosine * m.cosine;
}

// What is of second order on the way that the contact went last, where the
// slopes are those of its last stretch: c d (d + length) at the distance d.
struct Bend {
  Lanes distance;
  Lanes product;  // d (d + length)
};
[[gnu::always_inline]] inline Bend bend_of(const Packet& p, const Move& m) {
  const Lanes d = m.force * p[Row::way_force] + m.cosine * p[Row::way_cosine];
  return {d, d * (d + p[Row::way_length])};
}
// Not beyond some lengths.
[[gnu::always_inline]] inline Lanes useful(const Packet& p, const Bend& b) {
  constexpr double furthest = 3;
  return select(abs(b.distance) < furthest * p[Row::way_length], b.product,
                Lanes(0.0));
}

// d(residual) over dln tan psi, docs/joint.md (6).
[[gnu::always_inline]] inline Lanes residual_slope(const Triangle& t,
                                                   const Slopes& friction) {
  return 1.0 + t.sin_psi * t.sin_psi *
                   (friction.force * t.axis_cosine * t.axis_cosine +
                    2.0 * friction.cosine * t.axis_sine * t.axis_sine);
}

// A step in ln tan psi by its differentials.
[[gnu::always_inline]] inline void step_on(Triangle& t, const Lanes& step) {
  const Lanes sine = t.sin_psi * t.sin_psi * step;
  const Lanes cosine = t.cos_psi * t.cos_psi * step;
  const Lanes axis_sine = sine * t.axis_sine * t.axis_sine;
  const Lanes axis_cosine = sine * t.axis_cosine * t.axis_cosine;
  t.sin_psi *= 1.0 + cosine;
  t.cos_psi *= 1.0 - sine;
  t.cos_g *= 1.0 - axis_cosine;
  t.axis_sine *= 1.0 + axis_cosine;
  t.axis_cosine *= 1.0 - axis_sine;
}

}  // namespace
}  // namespace contact::detail
