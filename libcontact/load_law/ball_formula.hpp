#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "libcontact/friction/integrals.hpp"

/// The friction of a ball as a function of its load.
///
/// T = tan(theta0/2) is a polynomial in t, the logarithm of R_n. The power
/// Phi of friction over rho R_n |Dw| is a polynomial in e and x on each side of
/// the rim, where x is 0; its slope over a is the second component of the
/// moment. e is t, T (on [-1, 1]) or their mean. Near the rim Phi has a term
/// x^(7/2), by which it is smooth: inside by 1 - cos a over the contact's.
///
/// Derivatives follow their functions, in CONTACT_KEPT() if they are needed: Vx
/// is dV/dx, Vxe its slope over e.
// clang-format off
#define CONTACT_KEPT(...) __VA_ARGS__
#define CONTACT_LEFT_OUT(...)
#define CONTACT_EACH(DO) DO(0) DO(1) DO(2)
#define CONTACT_DOT(a, b) a##0 * b##0 + a##1 * b##1 + a##2 * b##2
#define CONTACT_LENGTH(a) sqrt(CONTACT_DOT(a, a))
#define CONTACT_CROSS(a, b)                                                   \
  k0 = a##1 * b##2 - a##2 * b##1;                                             \
  k1 = a##2 * b##0 - a##0 * b##2;                                             \
  k2 = a##0 * b##1 - a##1 * b##0;

#define CONTACT_LEFT_OUT_POLYNOMIAL(V, first, count, argument)                \
  V = poly(first, count, argument);
#define CONTACT_KEPT_POLYNOMIAL(V, first, count, argument)                    \
  place = first + count - 1; V = 0; V##e = 0;                                 \
  for (int k = 0; k < count; ++k) {                                           \
    V##e = V##e * argument + V;                                               \
    V = V * argument + poly(place, 1, argument);                              \
    place = place - 1;                                                        \
  }

// The sum of x^i g_i(e), whose coefficients begin `at` there.
#define CONTACT_SERIES(V, count, width, X, XX, E)                             \
  at = at + (count - 1) * width;                                              \
  V = 0; X(V##x = 0;) XX(V##xx = 0; V##xe = 0;) E(V##e = 0;)                  \
  for (int i = 0; i < count; ++i) {                                           \
    E##_POLYNOMIAL(g, at, width, e)                                           \
    XX(V##xx = V##xx * x + 2 * V##x; V##xe = V##xe * x + V##e;)               \
    X(V##x = V##x * x + V;) E(V##e = V##e * x + ge;)                          \
    V = V * x + g; at = at - width;                                           \
  }                                                                           \
  at = at + (count + 1) * width;

#define CONTACT_BALL_AT(SLOPE)                                                \
  SLOPE##_POLYNOMIAL(T, 0, nT, t)                                             \
  inverse = 1 / (1 + T * T); s = 2 * T * inverse; drop = s * T; c = 1 - drop;\
  e = share * (T - T_middle) / T_half + (1 - share) * t;                      \
  wide = q > s ? q : 1; span = wide * wide * c * c;                           \
  x = q > s ? (q - s) * (q + s) / span : 1 - q * q / ((1 + sa) * drop);       \
  x = x < 0 ? 0 : x; x = x > 1 ? 1 : x;                                       \
  at = q > s ? outside : nT;                                                  \
  CONTACT_SERIES(G, n, nh, CONTACT_KEPT, SLOPE, SLOPE)                        \
  root = sqrt(x) * x; power = 7;                                              \
  for (int i = 0; i < odd; ++i) {                                             \
    SLOPE##_POLYNOMIAL(g, at, nh, e)                                          \
    G = G + g * (root * x) * x;                                               \
    Gx = Gx + g * (root * x) * power / 2;                                     \
    SLOPE(                                                                    \
      Gxx = Gxx + g * root * power * (power - 2) / 4;                         \
      Ge = Ge + ge * root * x * x; Gxe = Gxe + ge * root * x * power / 2;     \
    )                                                                         \
    root = root * x; power = power + 2; at = at + nh;                         \
  }                                                                           \
  CONTACT_SERIES(r, nr, nrh, SLOPE, CONTACT_LEFT_OUT, SLOPE)                  \
  b = q > s ? s * s / span : s / drop; b = b * Gx;                            \
  Y = q > s ? (G + 2 * sa * sa * b) / wide : s * G - sa * b;                  \
  F = f * r * Y; H = q > s ? f * q : f * s; Phi = H * G;                      \
  Pa = q > s ? -f * sa * (G + 2 * b) : f * q * b;

#define CONTACT_BALL_LOAD                                                     \
  load = sqrt(R[0] * R[0] + R[1] * R[1] + R[2] * R[2]);                       \
  size = load == 0 ? 1 : load;                                                \
  e0 = R[0] / size; e1 = R[1] / size; e2 = R[2] / size;                       \
  held = load < low ? low : load; held = load > high ? high : held;

// A step of a secant, or of the slope K where that is none.
#define CONTACT_SECANT(y, K, is_steep)                                        \
  rate = y == last ? 1 : y - last; rate = y == last ? K : (h - offset) / rate;\
  rate = is_steep ? rate : K; rate = rate < 3 ? rate : K;                     \
  last = y; offset = h; y = y - h / rate;

#define CONTACT_BALL_UNIT(A) u##A = u##A / length;
#define CONTACT_BALL_MOMENT(A)                                                \
  M##A = Pa * ((e##A - u##A * cbs) * cs + k##A * turn) / size;                \
  M##A = still == 0 ? 0 : h * (Phi * u##A + M##A);

#define CONTACT_BALL_FRICTION                                                 \
  CONTACT_BALL_LOAD                                                           \
  log_R = log(held);                                                          \
  big = abs(w[0]); big = abs(w[1]) > big ? abs(w[1]) : big;                   \
  big = abs(w[2]) > big ? abs(w[2]) : big;                                    \
  size = big == 0 ? 1 : big;                                                  \
  u0 = w[0] / size; u1 = w[1] / size; u2 = w[2] / size;                       \
  length = CONTACT_LENGTH(u); length = length == 0 ? 1 : length;              \
  CONTACT_EACH(CONTACT_BALL_UNIT)                                             \
  CONTACT_CROSS(u, e)                                                         \
  sb2 = CONTACT_DOT(k, k); sb = sqrt(sb2);                                    \
  cbs = CONTACT_DOT(u, e); cb = abs(cbs);                                     \
  T = poly(0, nT, (log_R - middle) / half); s = 2 * T / (1 + T * T);          \
  K = 16 * s * s / 25; B = sb2 + K - f * f * cb * cb;                         \
  D = sqrt(B * B + 4 * K * cb * cb * f * f);                                  \
  y = B > 0 ? 2 * f * f / (B + D) : (D - B) / (2 * K * cb * cb + tiny);       \
  y = sqrt(y); last = y; offset = 0;                                          \
  tangent = 0; cg = 1; cs = 1; Phi = 0; Pa = 0;                               \
  for (int j = 0; j < rounds; ++j) {                                          \
    tangent = y; d = 1 / (1 + y * y);                                         \
    cg2 = cb * cb + sb2 * d; cg2 = cg2 == 0 ? 1 : cg2;                        \
    cg = sqrt(cg2); cs = sqrt(d); sa = cb / cg; q = sb * cs / cg;             \
    t = (log_R + log(cg) - middle) / half;                                    \
    CONTACT_BALL_AT(CONTACT_LEFT_OUT)                                         \
    h = y - F;                                                                \
    if (abs(h) < tolerance * y) break;                                        \
    K = 16 * s * s / 25; K = 1 - (1 - d) * sa * sa * q * q / (q * q + K);     \
    CONTACT_SECANT(y, K, 50 * rate > 1)                                       \
    y = y < 0 ? 0 : y;                                                        \
  }                                                                           \
  turn = side * tangent * cs; size = sb < tiny ? tiny : sb;                   \
  Pa = cbs < 0 ? -Pa : Pa; normal = load * cg; h = -radius * normal;          \
  still = big * load;                                                         \
  CONTACT_EACH(CONTACT_BALL_MOMENT)                                           \
  flag = load < low ? 1 : 0; flag = load > high ? 1 : flag;                   \
  flag = still == 0 ? 2 : flag; flag = M0 == M0 ? flag : 4;

// Slopes of Phi and of the force over a and l = ln R_n, by those over x and e,
// and the derivatives of M as in docs/explanation/joint.md: sums of products of
// two vectors each, of which A is a component.
#define CONTACT_BALL_SLOPES                                                   \
  CONTACT_BALL_AT(CONTACT_KEPT)                                               \
  Tl = load == held ? Te / half : 0;                                          \
  el = load == held ? share * Tl / T_half + (1 - share) / half : 0;           \
  sl = 2 * (1 - T * T) * inverse * inverse * Tl;                              \
  cl = -4 * T * inverse * inverse * Tl;                                       \
  K = s * s / (span * wide); xa = q > s ? -2 * K * sa : q / drop;             \
  xaa = q > s ? -2 * K * (q * q + 3 * sa * sa) / wide : -sa / drop;           \
  K = cl / (c * span); xl = q > s ? 2 * K * sa * sa : -cl * (1 - x) / drop;   \
  xal = q > s ? 4 * K * sa / wide : q * cl / (drop * drop);                   \
  Ha = q > s ? -f * sa : 0; Hl = q > s ? 0 : f * sl;                          \
  Gl = Gx * xl + Ge * el; Pl = Hl * G + H * Gl;                               \
  Paa = q > s ? -Phi : 0;                                                     \
  Paa = Paa + 2 * Ha * Gx * xa + H * (Gxx * xa * xa + Gx * xaa);              \
  Pal = Ha * Gl + Hl * Gx * xa + H * ((Gxx * xl + Gxe * el) * xa + Gx * xal);\
  Pq = q > s ? Ha * (G + 2 * b) / wide : f * b;                               \
  force = F * q; Fa = f * rx * xa * Y * q - r * sa * (Phi + Paa);             \
  Fl = f * (rx * xl + re * el) * Y * q + r * (q * Pl - sa * Pal);

#define CONTACT_BALL_VECTORS(A)                                               \
  d##A = ((e##A - u##A * K) * cs + k##A * turn) / size;                       \
  t##A = (k##A * cs - (e##A - u##A * K) * turn) / size;                       \
  n##A = sa * u##A + q * d##A; j##A = q * u##A - sa * d##A;                   \
  p##A = (t##A + side * ((force + Fl) * n##A + Fa * j##A)) / D;               \
  n##A = n##A - side * force * p##A; j##A = j##A + side * F * sa * p##A;

#define CONTACT_BALL_ROW(A)                                                   \
  Cn = h * ((Phi + Pl) * u##A + (Pa + Pal) * d##A);                           \
  Cj = h * (Pa * u##A + Paa * d##A); Ct = h * Pq * t##A;                      \
  X##A##0 = Cn * n0 + Cj * j0 + Ct * p0;                                      \
  X##A##1 = Cn * n1 + Cj * j1 + Ct * p1;                                      \
  X##A##2 = Cn * n2 + Cj * j2 + Ct * p2;                                      \
  Ct = (Ct + side * (F * sa * Cj - force * Cn)) / D; Cj = Cj + side * Fa * Ct;\
  Cn = (h * (Phi + Paa) * d##A + side * Fa * Ct) * normal / speed;            \
  Cj = (h * f * Y * t##A - side * F * Cj) * normal / speed;                   \
  W##A##0 = Cn * d0 + Cj * t0;                                                \
  W##A##1 = Cn * d1 + Cj * t1;                                                \
  W##A##2 = Cn * d2 + Cj * t2;

#define CONTACT_BALL_GRADIENT                                                 \
  CONTACT_BALL_FRICTION                                                       \
  CONTACT_BALL_SLOPES                                                         \
  D = 1 + (force + Fl) * force - Fa * F * sa;                                 \
  sign = cbs < 0 ? -1 : 1; sa = sign * sa; Pa = sign * Pa; Pal = sign * Pal;  \
  Pq = sign * Pq; Fa = sign * Fa;                                             \
  h = still == 0 ? 0 : -radius; speed = still == 0 ? 1 : big * length;        \
  K = 5 * abs(u0) < 3 ? 1 : 0; e0 = sb == 0 ? K : e0;                         \
  e1 = sb == 0 ? 1 - K : e1; e2 = sb == 0 ? 0 : e2;                           \
  K = CONTACT_DOT(u, e);                                                      \
  CONTACT_CROSS(u, e)                                                         \
  size = CONTACT_LENGTH(k); size = size == 0 ? 1 : size;                      \
  CONTACT_EACH(CONTACT_BALL_VECTORS)                                          \
  CONTACT_EACH(CONTACT_BALL_ROW)

#define CONTACT_BALL_HOLD                                                     \
  CONTACT_BALL_LOAD                                                           \
  m0 = m[0]; m1 = m[1]; m2 = m[2]; big = CONTACT_LENGTH(m);                   \
  along = abs(CONTACT_DOT(m, e)); along = along < tiny ? tiny : along;        \
  CONTACT_CROSS(m, e)                                                         \
  across = CONTACT_LENGTH(k); across = across < tiny ? tiny : across;         \
  target = log(across / along);                                               \
  log_cot = target > largest ? largest : target;                              \
  normal = held; both = 1; last = log_cot; offset = 0;                        \
  for (int j = 0; j < hold_rounds; ++j) {                                     \
    q = exp(log_cot); sa = 1 / sqrt(1 + q * q); q = q * sa;                   \
    t = (log(normal) - middle) / half;                                        \
    CONTACT_BALL_AT(CONTACT_LEFT_OUT)                                         \
    J = q * Phi - sa * Pa; Z = sa * Phi + q * Pa;                             \
    force = F * q; cg2 = 1 / (1 + force * force); normal = held * sqrt(cg2);  \
    both = J * J + Z * Z; part = Z * Z * cg2; part = part < tiny ? tiny : part;\
    h = both - part; h = h < tiny ? tiny : h;                                 \
    h = log(sqrt(h / part)) - target;                                         \
    CONTACT_SECANT(log_cot, 1, 10 * rate > 3)                                 \
    log_cot = log_cot > largest ? largest : log_cot;                          \
  }                                                                           \
  used = big * held / (radius * normal * sqrt(both) * load);                  \
  used = big == 0 ? 0 : used;

#define CONTACT_BALL_VARIABLES                                                \
  Real T, inverse, s, drop, c, e, wide, span, x, at, G, Gx, root, power, g, r,\
      b, Y, F, H, Phi, Pa;

// Coefficients of t in T; powers of x in G, of e in each, and odd powers; the
// same of r; evaluations; where the coefficients outside begin. Then reals.
#define CONTACT_BALL_NUMBERS(X, REAL)                                         \
  X(nT) X(n) X(nh) X(odd) X(nr) X(nrh) X(rounds) X(outside)                   \
  REAL(tolerance) REAL(radius) REAL(side) REAL(low) REAL(high) REAL(middle)   \
  REAL(half) REAL(T_middle) REAL(T_half) REAL(share) REAL(tiny)
// clang-format on

namespace contact::detail {

/// The law in double or float. `tolerance` is the relative residual of the last
/// evaluation. The table: T; inside G with its odd powers, r; outside the same.
template <class Real>
struct BallLaw {
#define CONTACT_COUNT(name) int name = 0;
#define CONTACT_REAL(name) Real name = 0;
  CONTACT_BALL_NUMBERS(CONTACT_COUNT, CONTACT_REAL)
#undef CONTACT_COUNT
#undef CONTACT_REAL
  std::vector<Real> table = {};
  /// Largest errors of M over |M|, as in PinLoadLaw.
  double error = 0;
  double float_error = 0;

  Real poly(Real first, int count, Real argument) const {
    Real sum = 0;
    for (int i = count; i-- > 0;) {
      sum = sum * argument + table[std::size_t(first) + std::size_t(i)];
    }
    return sum;
  }

// Float takes whole numbers as they are.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
  /// Friction force and both moments over rho at an axis, with f = 1: over R_n.
  FrictionTriple at_axis(Real t, Real sa, Real q) const {
    using std::sqrt;
    CONTACT_BALL_VARIABLES
    const Real f = 1;
    CONTACT_BALL_AT(CONTACT_LEFT_OUT)
    return {F * q, q * Phi - sa * Pa, sa * Phi + q * Pa};
  }
  void friction(const Real* R, const Real* w, Real f, Real* M) const {
    using std::abs, std::log, std::sqrt;
    CONTACT_BALL_VARIABLES
    Real t, sa, q, load, size, held, big, k0, k1, k2, last, offset, rate, h,
        normal, u0, u1, u2, e0, e1, e2, length, log_R, sb2, sb, cbs, cb, K, B,
        D, y, tangent, d, cg2, cg, cs, turn, still, M0, M1, M2, flag;
    CONTACT_BALL_FRICTION
    M[0] = M0;
    M[1] = M1;
    M[2] = M2;
    (void)flag;
  }
#pragma GCC diagnostic pop
};

}  // namespace contact::detail
