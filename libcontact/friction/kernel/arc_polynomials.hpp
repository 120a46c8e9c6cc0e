#pragma once

#include <array>

namespace contact::detail {

/// Polynomials of the exact method in x = cos d, d in [0, pi/2] the length
/// of a great-circle arc inside the contact:
///   arc_f(x) = (d - sin d cos d) / sin^3 d             = f / sd^3
///   arc_h(x) = (2/3 - x arc_f(x)) / sin^2 d            = h / sd^5
/// f, h as in docs/internals/exact_method.md. Both are analytic on [0, 1],
/// their nearest singularity is x = -1. Coefficients of powers of (x - centre),
/// by interpolation at the Chebyshev points of the interval in 60-digit
/// arithmetic; friction/exact_test.cpp makes them anew and compares.
template <int n>
struct ArcPolynomial {
  double lower;   ///< the interval is [lower, 1]
  double centre;  ///< (lower + 1)/2
  std::array<double, n> coefficients;
};

/// arc_h on [0.8, 1], largest relative error 7e-18.
inline constexpr ArcPolynomial<12> arc_h_short{
    0.8,
    0.9,
    {0.14994026190617876148, -0.18081845721911528583, 0.15885740728685891579,
     -0.12174285985941223274, 0.08632229694819317981, -0.058188578293079658663,
     0.037849340025089047251, -0.02397385286408275484, 0.014875002153705695044,
     -0.0090794450578870005408, 0.0055262401597772192587,
     -0.0032905082143727632194}};

/// arc_h on [0.4, 1], largest relative error 2e-17.
inline constexpr ArcPolynomial<18> arc_h_medium{
    0.4,
    0.7,
    {0.19359170112947610075, -0.26228356113002077334, 0.25837662695951236601,
     -0.22179997296091280282, 0.17605550190180553155, -0.13280184161381696985,
     0.096638392439427798107, -0.06846567642956605996, 0.047511104989808507499,
     -0.032429117433097600953, 0.021837497740045966123,
     -0.014540916778970040945, 0.0095957280312444198006,
     -0.0062775372312692393166, 0.0040225619697627035889,
     -0.0025976524817592431281, 0.0019961271356761389647,
     -0.0012737694307533910344}};

/// arc_f on [0, 1], largest relative error 2e-17.
inline constexpr ArcPolynomial<23> arc_f_long{
    0.0, 0.5, {0.94559943487486031164,   -0.77546779691694683692,
               0.59875254155481108998,   -0.44721657432236426406,
               0.32709604110719660452,   -0.23580565865431707899,
               0.16820789039445089556,   -0.11902592075079329912,
               0.083691778270683421051,  -0.058546306003572899852,
               0.040783190424823299397,  -0.028308360081693314292,
               0.019590632253193216228,  -0.013528768085836771931,
               0.0093171009840989988443, -0.0063604129906739827046,
               0.0043642985347430945507, -0.0031841994150368184379,
               0.0021774448186592260557, -0.00094185702527279599416,
               0.0006441740246075682522, -0.0013125277766663192871,
               0.00089289938862256578964}};

}  // namespace contact::detail
