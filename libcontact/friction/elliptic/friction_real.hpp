#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>

#include "libcontact/friction/elliptic/integrals_real.hpp"
#include "libcontact/friction/integrals.hpp"

/// The functions of friction/elliptic/friction.hpp for any real type that
/// Boost.Math takes. Formulas and symbols: docs/internals/elliptic_form.md.
namespace contact {
namespace elliptic_form {

/// Contact and slip axis, as parameters of the integrals over the longitude.
template <class Real>
struct Cap {
  Real s, c;         ///< sine and cosine of theta0
  Real sa, q;        ///< sine and cosine of a
  bool pole_inside;  ///< z = s/q >= 1
  Real large;        ///< M = max(s, q)
  Real k, x;         ///< modulus m/M with m = min(s, q), and 1 - k^2
  Real n, p;         ///< characteristic m^2, and 1 - m^2
  Real g;            ///< 1 - M^2

  Cap(const Real& half_angle, const Real& sin_a, const Real& cos_a)
      : sa(sin_a), q(cos_a) {
    using std::cos, std::sin;
    s = sin(half_angle);
    c = cos(half_angle);
    pole_inside = s >= q;
    large = pole_inside ? s : q;
    const Real small = pole_inside ? q : s;
    k = small / large;
    n = small * small;
    p = pole_inside ? Real(sa * sa) : Real(c * c);
    g = pole_inside ? Real(c * c) : Real(sa * sa);
    // On the edge K and Pi are infinite, the combinations below are not:
    // they are continuous as x ln x, so a floor far below the rounding
    // serves for x = 0. The same for p at theta0 = 90 deg, a = 0.
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    const Real floor = epsilon * epsilon;
    x = (std::max)(Real((large - small) / large * (1 + k)), floor);
    p = (std::max)(p, floor);
  }
};

/// The four integrals over the longitude 0 <= phi <= asin(min(1, z)), with
/// D^2 = s^2 - q^2 sin^2 phi, R^2 = 1 - q^2 sin^2 phi.
template <class Real>
struct MeridianIntegrals {
  Real f;   ///< F = ∫ cos^2 phi D/R^2
  Real c;   ///< C = cos theta0 ∫ cos^2 phi D/R^4
  Real g;   ///< G = ∫ D^3/R^2
  Real gh;  ///< G + H, H = ∫ cos^2 phi D^3/R^4
};

template <class Real>
MeridianIntegrals<Real> meridian_integrals(const Cap<Real>& cap) {
  const Real& x = cap.x;
  const Real k2 = cap.k * cap.k, m2 = cap.large * cap.large;
  const Real s3 = cap.s * cap.s * cap.s;
  // w = sin^2, v = 1/(1 - n w); each is an integral over a quarter period.
  const Real k_cosine = elliptic_k_cosine<Real>(x);           // (1 - w)/Delta
  const Real k_sine = elliptic_k_sine<Real>(x);               // w/Delta
  const Real pi_cosine = elliptic_pi_cosine<Real>(cap.p, x);  // (1-w) v/Delta
  const Real pi_sine = elliptic_pi_sine<Real>(cap.p, x);      // w v/Delta
  const Real e = k_cosine + x * k_sine;                       // Delta
  const Real w_delta = (k_cosine + 2 * x * k_sine) / 3;       // w Delta
  // Delta^2 v = (1 - g v)/M^2 and n w v = v - 1 lower the degree. Towards
  // the edge K_sine and Pi_sine are large and must not be subtracted.
  const Real vf = (k_cosine - cap.g * pi_cosine) / m2;  // (1 - w) v Delta
  const Real vy = (pi_cosine - k_cosine) / cap.n;       // w (1 - w) v/Delta
  const Real vw = x < 0.5 ? vy + x * (pi_sine - k_sine) / cap.n
                          : (k_sine - cap.g * pi_sine) / m2;  // w v Delta
  const Real vc = (pi_cosine + vw) / 2;  // (1 - w) v^2 Delta
  if (cap.pole_inside) {
    const Real g = (e - cap.g * (vf + vw)) / m2;  // v Delta^3
    const Real gh = vf + (w_delta - cap.g * vw) / m2;
    return {cap.s * vf, cap.c * cap.s * vc, s3 * g, s3 * gh * 3 / 2};
  }
  const Real g = pi_cosine - vy;  // (1 - w)^2 v/Delta
  // w (1 - w)/Delta from 3 k^2 ∫ w^2/Delta = (1 + 2 k^2) sine - cosine.
  const Real wk = k_sine - ((1 + 2 * k2) * k_sine - k_cosine) / (3 * k2);
  const Real gh = g + (wk - cap.g * vy) / m2;
  const Real sk = cap.s * cap.k;
  return {sk * vf, cap.c * sk * vc, s3 * cap.k * g, s3 * cap.k * gh * 3 / 2};
}

/// f = d - sin d cos d for the arc d in [0, pi/2] with sin^2 d = y,
/// tan d = sine/cosine.
template <class Real>
Real arc_excess(const Real& y, const Real& sine, const Real& cosine) {
  using std::atan2, std::sqrt;
  if (y > 0.4) {
    // Loses 2 bits at most.
    return atan2(sine, cosine) -
           sine * cosine / (sine * sine + cosine * cosine);
  }
  // asin t - t sqrt(1 - t^2), t^2 = y, by its series (2/3) t^3 + ...
  Real term = Real(2) / 3, sum = term;
  const Real negligible = std::numeric_limits<Real>::epsilon() / 8;
  for (int k = 2; term > negligible; k += 2) {
    term *= y * ((k - 1) * (k + 1)) / (k * (k + 3));
    sum += term;
  }
  return y * sqrt(y) * sum;
}

/// The slip speed integral for cos theta0 >= 0: A = 2 ∫ f + 4 q^2 C with
/// f = d - sin d cos d, every term positive, by tanh-sinh quadrature over
/// psi = pi/2 - phi (pole inside) or pi/2 - chi, sin phi = z sin chi. The one
/// bad point of the integrand, where the slip axis is near the edge or the
/// contact near a hemisphere, is the end psi = 0.
template <class Real>
Real slip_speed_integral(const Cap<Real>& cap) {
  using std::sin, std::sqrt;
  thread_local boost::math::quadrature::tanh_sinh<Real> quadrature;
  const Real k2 = cap.k * cap.k, two_q2 = 2 * cap.q * cap.q;
  const auto integrand = [&](const Real& psi) -> Real {
    const Real sine = sin(psi), sine2 = sine * sine;
    const Real delta2 = cap.x + k2 * sine2;
    const Real delta = sqrt(delta2);
    const Real inverse_r2 = 1 / (cap.p + cap.n * sine2);
    const Real d = cap.s * (cap.pole_inside ? delta : sine);  // D
    const Real cos2_phi = cap.pole_inside ? sine2 : delta2;
    const Real f = arc_excess<Real>(d * d * inverse_r2, d, cap.c);
    const Real sum =
        f + two_q2 * cos2_phi * d * cap.c * inverse_r2 * inverse_r2;
    return cap.pole_inside ? sum : Real(sum * cap.k * sine / delta);
  };
  return 2 * quadrature.integrate(integrand, Real(0),
                                  boost::math::constants::half_pi<Real>());
}

/// False for NaN. Sine and cosine may exceed 1 by the rounding of unit
/// vectors.
template <class Real>
bool valid(const Real& half_angle, const Real& sin_a, const Real& cos_a) {
  const Real limit = 1.000001;
  return half_angle >= 0 && half_angle <= boost::math::constants::pi<Real>() &&
         sin_a >= -limit && sin_a <= limit && cos_a >= 0 && cos_a <= limit;
}

}  // namespace elliptic_form

/// @param sin_a, cos_a  sine and cosine of the slip axis angle
template <class Real>
Real slip_speed_integral(const Real& half_angle, const Real& sin_a,
                         const Real& cos_a) {
  using namespace boost::math::constants;
  if (!elliptic_form::valid(half_angle, sin_a, cos_a)) {
    return std::numeric_limits<Real>::quiet_NaN();
  }
  if (half_angle == 0) return Real(0);
  elliptic_form::Cap<Real> cap(half_angle, sin_a, cos_a);
  if (cap.c >= 0) return elliptic_form::slip_speed_integral(cap);
  cap.c = -cap.c;  // the rest of the sphere is the cap about the far pole
  return pi_sqr<Real>() - elliptic_form::slip_speed_integral(cap);
}

/// @param sin_a, cos_a  sine and cosine of the slip axis angle
template <class Real>
BasicFrictionIntegrals<Real> elliptic_friction_integrals(const Real& half_angle,
                                                         const Real& sin_a,
                                                         const Real& cos_a) {
  using std::sin;
  if (!elliptic_form::valid(half_angle, sin_a, cos_a)) {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    return {nan, {nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}};
  }
  if (half_angle == 0) {
    const Real one(cos_a > 0 ? 1 : 0), zero(0);
    return {zero, {zero, zero, zero}, {zero, zero, zero}, {one, one, zero}};
  }
  const elliptic_form::Cap<Real> cap(half_angle, sin_a, cos_a);
  const elliptic_form::MeridianIntegrals<Real> m =
      elliptic_form::meridian_integrals(cap);
  const Real &c = cap.c, &q = cos_a, &sa = sin_a;
  const Real half = sin(half_angle / 2);
  const Real rise = 2 * half * half;  // 1 - c
  // T = 2 ∫ f
  const Real t =
      slip_speed_integral<Real>(half_angle, sin_a, cos_a) - 4 * q * q * m.c;
  BasicFrictionIntegrals<Real> result;
  result.normal = boost::math::constants::third_pi<Real>() * rise * rise *
                  (2 + c);  // (3.4)
  result.area = {4 * q * m.f, q * (t + 4 * m.c), sa * t};
  result.pressure = {(result.area.sliding - c * result.area.force) / 2,
                     q * (m.gh * 4 / 3 - c * t), sa * (m.g * 4 / 3 - c * t)};
  result.coefficient = {result.pressure.force / result.normal,
                        result.pressure.sliding / result.normal,
                        result.pressure.spinning / result.normal};  // (3.9)
  return result;
}

}  // namespace contact
