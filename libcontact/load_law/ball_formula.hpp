#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "libcontact/load_law/formula.hpp"

/// The friction of a ball by its load.
///
/// T = tan(theta0/2) is a polynomial in t, the logarithm of R_n. The power
/// Phi of friction over rho R_n |Dw| is a polynomial in e and x on each side of
/// the rim, where x is 0; its slope over a is the second component of the
/// moment. e is t, T (on [-1, 1]) or their mean. Near the rim Phi has a term
/// x^(7/2), by which it is smooth: inside by 1 - cos a over the contact's.
// clang-format off
#define CONTACT_BALL_AT                                                      \
  T = poly(0, nT, t);                                                        \
  inverse = 1 / (1 + T * T);                                                 \
  s = 2 * T * inverse;                                                       \
  drop = 2 * T * T * inverse;                                                \
  c = 1 - drop;                                                              \
  e = share * (T - T_middle) / T_half + other * t;                           \
  wide = q > s ? q : 1;                                                      \
  x = q > s ? (q - s) * (q + s) / (wide * wide * c * c)                      \
            : 1 - q * q / ((1 + sa) * drop);                                 \
  x = x < 0 ? 0 : x;                                                         \
  x = x > 1 ? 1 : x;                                                         \
  at = q > s ? outside : inside;                                             \
  at = at + top;                                                             \
  G = 0;                                                                     \
  Gx = 0;                                                                    \
  for (int i = 0; i < n; ++i) {                                              \
    Gx = Gx * x + G;                                                         \
    G = G * x + poly(at, nh, e);                                             \
    at = at - nh;                                                            \
  }                                                                          \
  at = at + past;                                                            \
  root = sqrt(x) * x * x;                                                    \
  power = seven_halves;                                                      \
  for (int i = 0; i < odd; ++i) {                                            \
    g = poly(at, nh, e);                                                     \
    G = G + g * root * x;                                                    \
    Gx = Gx + g * root * power;                                              \
    root = root * x;                                                         \
    power = power + 1;                                                       \
    at = at + nh;                                                            \
  }                                                                          \
  at = at + r_top;                                                           \
  r = 0;                                                                     \
  for (int i = 0; i < nr; ++i) {                                             \
    r = r * x + poly(at, nrh, e);                                            \
    at = at - nrh;                                                           \
  }                                                                          \
  b = q > s ? s * s / (wide * wide * c * c) : s / drop;                      \
  b = b * Gx;                                                                \
  Y = q > s ? (G + 2 * sa * sa * b) / wide : s * G - sa * b;                 \
  F = f * r * Y;                                                             \
  Phi = q > s ? f * q * G : f * s * G;                                       \
  Pa = q > s ? -f * sa * (G + 2 * b) : f * q * b;

#define CONTACT_BALL_VARIABLES                                               \
  Real T, inverse, s, drop, c, e, wide, x, at, G, Gx, root, power, g, r, b,  \
      Y, F, Phi, Pa, t, sa, q, load, size, held, big, k0, k1, k2, last,      \
      offset, rate, h, normal;

#define CONTACT_BALL_LOAD                                                    \
  load = sqrt(R[0] * R[0] + R[1] * R[1] + R[2] * R[2]);                      \
  size = load == 0 ? 1 : load;                                               \
  held = load < low ? low : load;                                            \
  held = load > high ? high : held;

#define CONTACT_BALL_FRICTION                                                \
  CONTACT_BALL_VARIABLES                                                     \
  Real u0, u1, u2, e0, e1, e2, length, log_R, sb2, sb, cbs, cb, K, B, D, y,  \
      tangent, d, cg2, cg, cs, turn, still, M0, M1, M2, flag;                \
  CONTACT_BALL_LOAD                                                          \
  log_R = log(held);                                                         \
  e0 = R[0] / size;                                                          \
  e1 = R[1] / size;                                                          \
  e2 = R[2] / size;                                                          \
  big = abs(w[0]);                                                           \
  big = abs(w[1]) > big ? abs(w[1]) : big;                                   \
  big = abs(w[2]) > big ? abs(w[2]) : big;                                   \
  size = big == 0 ? 1 : big;                                                 \
  u0 = w[0] / size;                                                          \
  u1 = w[1] / size;                                                          \
  u2 = w[2] / size;                                                          \
  length = sqrt(u0 * u0 + u1 * u1 + u2 * u2);                                \
  length = length == 0 ? 1 : length;                                         \
  u0 = u0 / length;                                                          \
  u1 = u1 / length;                                                          \
  u2 = u2 / length;                                                          \
  k0 = u1 * e2 - u2 * e1;                                                    \
  k1 = u2 * e0 - u0 * e2;                                                    \
  k2 = u0 * e1 - u1 * e0;                                                    \
  sb2 = k0 * k0 + k1 * k1 + k2 * k2;                                         \
  sb = sqrt(sb2);                                                            \
  cbs = u0 * e0 + u1 * e1 + u2 * e2;                                         \
  cb = abs(cbs);                                                             \
  T = poly(0, nT, (log_R - middle) / half);                                  \
  s = 2 * T / (1 + T * T);                                                   \
  K = 16 * s * s / 25;                                                       \
  B = sb2 + K - f * f * cb * cb;                                             \
  D = sqrt(B * B + 4 * K * cb * cb * f * f);                                 \
  y = B > 0 ? 2 * f * f / (B + D) : (D - B) / (2 * K * cb * cb + tiny);      \
  y = sqrt(y);                                                               \
  last = y;                                                                  \
  offset = 0;                                                                \
  tangent = 0;                                                               \
  cg = 1;                                                                    \
  cs = 1;                                                                    \
  Phi = 0;                                                                   \
  Pa = 0;                                                                    \
  for (int j = 0; j < rounds; ++j) {                                         \
    tangent = y;                                                             \
    d = 1 / (1 + y * y);                                                     \
    cg2 = cb * cb + sb2 * d;                                                 \
    cg2 = cg2 == 0 ? 1 : cg2;                                                \
    cg = sqrt(cg2);                                                          \
    cs = sqrt(d);                                                            \
    sa = cb / cg;                                                            \
    q = sb * cs / cg;                                                        \
    t = (log_R + log(cg) - middle) / half;                                   \
    CONTACT_BALL_AT                                                          \
    h = y - F;                                                               \
    if (abs(h) < tolerance * y) break;                                       \
    K = 16 * s * s / 25;                                                     \
    K = 1 - (1 - d) * sa * sa * q * q / (q * q + K);                         \
    rate = y == last ? 1 : y - last;                                         \
    rate = y == last ? K : (h - offset) / rate;                              \
    rate = 50 * rate > 1 ? rate : K;                                         \
    rate = rate < 3 ? rate : K;                                              \
    last = y;                                                                \
    offset = h;                                                              \
    y = y - h / rate;                                                        \
    y = y < 0 ? 0 : y;                                                       \
  }                                                                          \
  turn = side * tangent * cs;                                                \
  size = sb < tiny ? tiny : sb;                                              \
  Pa = cbs < 0 ? -Pa : Pa;                                                   \
  normal = load * cg;                                                        \
  h = -radius * normal;                                                      \
  still = big * load;                                                        \
  M0 = h * (Phi * u0 + Pa * ((e0 - u0 * cbs) * cs + k0 * turn) / size);      \
  M1 = h * (Phi * u1 + Pa * ((e1 - u1 * cbs) * cs + k1 * turn) / size);      \
  M2 = h * (Phi * u2 + Pa * ((e2 - u2 * cbs) * cs + k2 * turn) / size);      \
  M0 = still == 0 ? 0 : M0;                                                  \
  M1 = still == 0 ? 0 : M1;                                                  \
  M2 = still == 0 ? 0 : M2;                                                  \
  flag = load < low ? 1 : 0;                                                 \
  flag = load > high ? 1 : flag;                                             \
  flag = still == 0 ? 2 : flag;                                              \
  flag = M0 == M0 ? flag : 4;

// The same with slopes of Phi and of the force over a and l = ln R_n, by those
// over x and e, and the derivatives of M as in docs/explanation/joint.md: sums of products
// of two vectors each, of which A is a component.
#define CONTACT_BALL_HORNER(first, count, argument)                          \
  place = first + count - 1;                                                 \
  g = 0;                                                                     \
  ge = 0;                                                                    \
  for (int k = 0; k < count; ++k) {                                          \
    ge = ge * argument + g;                                                  \
    g = g * argument + poly(place, 1, argument);                             \
    place = place - 1;                                                       \
  }

#define CONTACT_BALL_SLOPES                                                  \
  CONTACT_BALL_HORNER(0, nT, t)                                              \
  Tl = load == held ? ge / half : 0;                                         \
  el = load == held ? share * Tl / T_half + other / half : 0;                \
  sl = 2 * (1 - T * T) * inverse * inverse * Tl;                             \
  cl = -4 * T * inverse * inverse * Tl;                                      \
  at = q > s ? outside : inside;                                             \
  at = at + top;                                                             \
  G = 0;                                                                     \
  Gx = 0;                                                                    \
  Gxx = 0;                                                                   \
  Ge = 0;                                                                    \
  Gxe = 0;                                                                   \
  for (int i = 0; i < n; ++i) {                                              \
    CONTACT_BALL_HORNER(at, nh, e)                                           \
    Gxx = Gxx * x + 2 * Gx;                                                  \
    Gx = Gx * x + G;                                                         \
    G = G * x + g;                                                           \
    Gxe = Gxe * x + Ge;                                                      \
    Ge = Ge * x + ge;                                                        \
    at = at - nh;                                                            \
  }                                                                          \
  at = at + past;                                                            \
  root = sqrt(x) * x;                                                        \
  power = seven_halves;                                                      \
  for (int i = 0; i < odd; ++i) {                                            \
    CONTACT_BALL_HORNER(at, nh, e)                                           \
    G = G + g * root * x * x;                                                \
    Gx = Gx + g * root * x * power;                                          \
    Gxx = Gxx + g * root * power * (power - 1);                              \
    Ge = Ge + ge * root * x * x;                                             \
    Gxe = Gxe + ge * root * x * power;                                       \
    root = root * x;                                                         \
    power = power + 1;                                                       \
    at = at + nh;                                                            \
  }                                                                          \
  at = at + r_top;                                                           \
  r = 0;                                                                     \
  rx = 0;                                                                    \
  re = 0;                                                                    \
  for (int i = 0; i < nr; ++i) {                                             \
    CONTACT_BALL_HORNER(at, nrh, e)                                          \
    rx = rx * x + r;                                                         \
    r = r * x + g;                                                           \
    re = re * x + ge;                                                        \
    at = at - nrh;                                                           \
  }                                                                          \
  K = s * s / (c * c * wide * wide * wide);                                  \
  xa = q > s ? -2 * K * sa : q / drop;                                       \
  xaa = q > s ? -2 * K * (q * q + 3 * sa * sa) / wide : -sa / drop;          \
  K = cl / (c * c * c * wide * wide);                                        \
  xl = q > s ? 2 * K * sa * sa : -cl * (1 - x) / drop;                       \
  xal = q > s ? 4 * K * sa / wide : q * cl / (drop * drop);                  \
  H = q > s ? f * q : f * s;                                                 \
  Ha = q > s ? -f * sa : 0;                                                  \
  Haa = q > s ? -f * q : 0;                                                  \
  Hl = q > s ? 0 : f * sl;                                                   \
  Gl = Gx * xl + Ge * el;                                                    \
  Pl = Hl * G + H * Gl;                                                      \
  Paa = Haa * G + 2 * Ha * Gx * xa + H * (Gxx * xa * xa + Gx * xaa);         \
  Pal = Ha * Gl + Hl * Gx * xa + H * ((Gxx * xl + Gxe * el) * xa + Gx * xal);\
  Pq = q > s ? Ha * (G + 2 * b) / wide : f * b;                              \
  force = F * q;                                                             \
  Fa = f * rx * xa * Y * q - r * sa * (Phi + Paa);                           \
  Fl = f * (rx * xl + re * el) * Y * q + r * (q * Pl - sa * Pal);

#define CONTACT_BALL_VECTORS(A)                                              \
  d##A = ((e##A - u##A * K) * cs + k##A * turn) / size;                      \
  t##A = (k##A * cs - (e##A - u##A * K) * turn) / size;                      \
  n##A = sa * u##A + q * d##A;                                               \
  j##A = q * u##A - sa * d##A;                                               \
  p##A = (t##A + side * ((force + Fl) * n##A + Fa * j##A)) / D;              \
  n##A = n##A - side * force * p##A;                                         \
  j##A = j##A + side * F * sa * p##A;

#define CONTACT_BALL_ROW(A)                                                  \
  Cn = h * ((Phi + Pl) * u##A + (Pa + Pal) * d##A);                          \
  Cj = h * (Pa * u##A + Paa * d##A);                                         \
  Ct = h * Pq * t##A;                                                        \
  X##A##0 = Cn * n0 + Cj * j0 + Ct * p0;                                     \
  X##A##1 = Cn * n1 + Cj * j1 + Ct * p1;                                     \
  X##A##2 = Cn * n2 + Cj * j2 + Ct * p2;                                     \
  Ct = (Ct + side * (F * sa * Cj - force * Cn)) / D;                         \
  Cj = Cj + side * Fa * Ct;                                                  \
  Cn = (h * (Phi + Paa) * d##A + side * Fa * Ct) * normal / speed;           \
  Cj = (h * f * Y * t##A - side * F * Cj) * normal / speed;                  \
  W##A##0 = Cn * d0 + Cj * t0;                                               \
  W##A##1 = Cn * d1 + Cj * t1;                                               \
  W##A##2 = Cn * d2 + Cj * t2;

#define CONTACT_BALL_GRADIENT                                                \
  CONTACT_BALL_FRICTION                                                      \
  Real place, ge, Tl, el, sl, cl, Gxx, Ge, Gxe, rx, re, xa, xaa, xl, xal, H, \
      Ha, Haa, Hl, Gl, Pl, Paa, Pal, Pq, force, Fa, Fl, speed, sign, d0, d1, \
      d2, t0, t1, t2, n0, n1, n2, j0, j1, j2, p0, p1, p2, Cn, Cj, Ct, X00,   \
      X01, X02, X10, X11, X12, X20, X21, X22, W00, W01, W02, W10, W11, W12,  \
      W20, W21, W22;                                                         \
  CONTACT_BALL_SLOPES                                                        \
  D = 1 + (force + Fl) * force - Fa * F * sa;                                \
  sign = cbs < 0 ? -1 : 1;                                                   \
  sa = sign * sa;                                                            \
  Pal = sign * Pal;                                                          \
  Pq = sign * Pq;                                                            \
  Fa = sign * Fa;                                                            \
  h = still == 0 ? 0 : -radius;                                              \
  speed = still == 0 ? 1 : big * length;                                     \
  K = 5 * abs(u0) < 3 ? 1 : 0;                                               \
  e0 = sb == 0 ? K : e0;                                                     \
  e1 = sb == 0 ? 1 - K : e1;                                                 \
  e2 = sb == 0 ? 0 : e2;                                                     \
  K = u0 * e0 + u1 * e1 + u2 * e2;                                           \
  k0 = u1 * e2 - u2 * e1;                                                    \
  k1 = u2 * e0 - u0 * e2;                                                    \
  k2 = u0 * e1 - u1 * e0;                                                    \
  size = sqrt(k0 * k0 + k1 * k1 + k2 * k2);                                  \
  size = size == 0 ? 1 : size;                                               \
  CONTACT_BALL_VECTORS(0)                                                    \
  CONTACT_BALL_VECTORS(1)                                                    \
  CONTACT_BALL_VECTORS(2)                                                    \
  CONTACT_BALL_ROW(0)                                                        \
  CONTACT_BALL_ROW(1)                                                        \
  CONTACT_BALL_ROW(2)

#define CONTACT_BALL_HOLD                                                    \
  CONTACT_BALL_VARIABLES                                                     \
  Real along, across, cot, log_cot, J, Z, force, cg2, both, part, used;      \
  CONTACT_BALL_LOAD                                                          \
  big = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);                       \
  along = abs(m[0] * R[0] + m[1] * R[1] + m[2] * R[2]) / size;               \
  along = along < tiny ? tiny : along;                                       \
  k0 = m[1] * R[2] - m[2] * R[1];                                            \
  k1 = m[2] * R[0] - m[0] * R[2];                                            \
  k2 = m[0] * R[1] - m[1] * R[0];                                            \
  across = sqrt(k0 * k0 + k1 * k1 + k2 * k2) / size;                         \
  across = across < tiny ? tiny : across;                                    \
  normal = held;                                                             \
  cot = across / along;                                                      \
  cot = cot > largest ? largest : cot;                                       \
  both = 1;                                                                  \
  last = log(cot);                                                           \
  offset = 0;                                                                \
  for (int j = 0; j < hold_rounds; ++j) {                                    \
    log_cot = log(cot);                                                      \
    sa = 1 / sqrt(1 + cot * cot);                                            \
    q = cot * sa;                                                            \
    t = (log(normal) - middle) / half;                                       \
    CONTACT_BALL_AT                                                          \
    J = q * Phi - sa * Pa;                                                   \
    Z = sa * Phi + q * Pa;                                                   \
    force = F * q;                                                           \
    cg2 = 1 / (1 + force * force);                                           \
    normal = held * sqrt(cg2);                                               \
    both = J * J + Z * Z;                                                    \
    part = Z * Z * cg2;                                                      \
    part = part < tiny ? tiny : part;                                        \
    h = both - part;                                                         \
    h = h < tiny ? tiny : h;                                                 \
    h = log(sqrt(h / part) * along / across);                                \
    rate = log_cot == last ? 1 : log_cot - last;                             \
    rate = log_cot == last ? 1 : (h - offset) / rate;                        \
    rate = 10 * rate > 3 ? rate : 1;                                         \
    rate = rate < 3 ? rate : 1;                                              \
    last = log_cot;                                                          \
    offset = h;                                                              \
    cot = exp(log_cot - h / rate);                                           \
    cot = cot > largest ? largest : cot;                                     \
  }                                                                          \
  used = big * held / (radius * normal * sqrt(both) * load);                 \
  used = big == 0 ? 0 : used;

#define CONTACT_BALL_CONSTANTS(X)                                            \
  X(radius) X(side) X(low) X(high) X(middle) X(half) X(T_middle) X(T_half)   \
  X(top) X(past) X(r_top) X(share) X(other) X(seven_halves) X(tiny) X(largest) X(tolerance)
// clang-format on

// Float takes whole numbers as they are.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"

namespace contact::detail {

/// Counts of the coefficients of a ball's law, and of evaluations.
struct BallCounts {
  int nT;   ///< powers of t in T
  int n;    ///< powers x^0, x^1, ...
  int nh;   ///< powers of e in each
  int odd;  ///< further powers, x^(7/2), x^(9/2), ...
  int nr;   ///< powers of x of the force over sigma_Y
  int nrh;  ///< powers of e in each
  int rounds;
  double residual;  ///< relative, of the last one
};

/// The law in double or float. The table: T; inside powers with theirs in e,
/// ratio; outside the same.
template <class Real>
struct BallLaw : BallCounts {
#define CONTACT_MEMBER(name) Real name = 0;
  CONTACT_BALL_CONSTANTS(CONTACT_MEMBER)
#undef CONTACT_MEMBER
  static constexpr int hold_rounds = 8;
  int inside = 0;
  int outside = 0;
  std::vector<Real> table = {};

  Real poly(Real first, int count, Real argument) const {
    Real sum = 0;
    for (int i = count; i-- > 0;) {
      sum = sum * argument + table[std::size_t(first) + std::size_t(i)];
    }
    return sum;
  }
  void friction(const Real* R, const Real* w, Real f, Real* M) const {
    using std::abs, std::log, std::sqrt;
    CONTACT_BALL_FRICTION
    M[0] = M0;
    M[1] = M1;
    M[2] = M2;
    (void)flag;
  }
};

#pragma GCC diagnostic pop

template <class To>
BallLaw<To> ball_law_in(const BallLaw<double>& law) {
  BallLaw<To> other{static_cast<const BallCounts&>(law)};
#define CONTACT_COPIED(name) other.name = static_cast<To>(law.name);
  CONTACT_BALL_CONSTANTS(CONTACT_COPIED)
#undef CONTACT_COPIED
  other.inside = law.inside;
  other.outside = law.outside;
  other.table.assign(law.table.begin(), law.table.end());
  return other;
}

inline Constants ball_constants(const BallLaw<double>& law) {
  Constants all;
  auto& to = all.numbers;
#define CONTACT_NAMED(name) to[#name] = double(law.name);
  CONTACT_BALL_CONSTANTS(CONTACT_NAMED)
  CONTACT_NAMED(nT)
  CONTACT_NAMED(n)
  CONTACT_NAMED(nh)
  CONTACT_NAMED(odd)
  CONTACT_NAMED(nr)
  CONTACT_NAMED(nrh)
  CONTACT_NAMED(rounds)
  CONTACT_NAMED(hold_rounds)
  CONTACT_NAMED(inside)
  CONTACT_NAMED(outside)
#undef CONTACT_NAMED
  return all;
}

inline constexpr std::string_view ball_friction_formula =
    CONTACT_TEXT_OF(CONTACT_BALL_FRICTION);
inline constexpr std::string_view ball_gradient_formula =
    CONTACT_TEXT_OF(CONTACT_BALL_GRADIENT);
inline constexpr std::string_view ball_hold_formula =
    CONTACT_TEXT_OF(CONTACT_BALL_HOLD);

}  // namespace contact::detail
