#pragma once

/// Complete elliptic integrals, the only place of the library that calls
/// Boost's elliptic functions (docs/internals/elliptic.md).
///
/// Everything takes the complementary parameter x = 1 - k^2 and, for the
/// third kind, the complementary characteristic p = 1 - n, because that is
/// where the digits are: K has a logarithmic singularity at x = 0. With
/// Delta = sqrt(1 - k^2 sin^2 phi) and integrals over 0 <= phi <= pi/2:
///
///     K = int 1/Delta            = cosine part + sine part
///     E = int Delta
///     Pi = int 1/((1 - n sin^2 phi) Delta) = cosine part + sine part
///
/// where the cosine part has cos^2 phi, the sine part sin^2 phi in its
/// numerator. The friction integrals consist of these parts: each is positive,
/// and they stay accurate where K - E or Pi - K have lost their digits (x -> 1,
/// n -> 0). Fukushima calls the parts of K B and D
/// (docs/reference/references.md#fukushima-2011). All reduce to Carlson's
/// symmetric integrals, DLMF 19.25.
///
/// Arguments: x >= 0 (x > 1 is an imaginary modulus), p >= 0. K, Pi and the
/// sine parts are +infinity at x = 0, Pi and its sine part also at p = 0.
/// Arguments outside, infinite or NaN give NaN; nothing throws.
///
/// Accuracy: largest relative error 1e-15 on x in [1e-300, 1e3] and
/// p in [1e-12, 1e3] (friction/elliptic_integrals_test.cpp,
/// data/reference/elliptic.csv). For other real types include
/// friction/elliptic/integrals_real.hpp.
namespace contact {

/// Complete elliptic integral of the first kind K.
double elliptic_k(double x);
/// Complete elliptic integral of the second kind E.
double elliptic_e(double x);
/// Complete elliptic integral of the third kind Pi.
double elliptic_pi(double p, double x);

/// Cosine part of K, (E - x K)/k^2; 1 at x = 0, pi/4 at x = 1.
double elliptic_k_cosine(double x);
/// Sine part of K, (K - E)/k^2; pi/4 at x = 1.
double elliptic_k_sine(double x);
/// Cosine part of Pi, (K - p Pi)/n. At p = 0 it equals K, at p = 1 the
/// cosine part of K.
double elliptic_pi_cosine(double p, double x);
/// Sine part of Pi, (Pi - K)/n. At p = 1 it equals the sine part of K.
double elliptic_pi_sine(double p, double x);

/// The engineering approximation of the paper (section 3, after (3.9)),
///     K = 1.3863 + 0.1845 x - (0.5 + 0.0879 x) ln x,  0 < x <= 1.
/// Largest relative error 1.1e-3 (friction/elliptic_integrals_test.cpp).
double elliptic_k_chebyshev(double x);
/// The paper's
///     E = 1 + 0.5708 x - 0.1948 x ln x,  0 <= x <= 1.
/// Largest relative error 2.7e-3 (friction/elliptic_integrals_test.cpp).
double elliptic_e_chebyshev(double x);

}  // namespace contact
