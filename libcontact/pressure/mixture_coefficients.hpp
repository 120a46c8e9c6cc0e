#pragma once

// clang-format off
/// Made by the program fit-pressure-mixture
/// (reference/pressure_mixture_fit.hpp); do not edit. Largest relative error
/// of S on the pairs of the fit above each.
namespace contact::detail {

inline constexpr int mixture_terms = 5;
struct MixtureCoefficients {
  int power;                       ///< power of cos(theta0/2)
  double equal[mixture_terms];     ///< c_k, k = 1, 2, ...
  double contrast[mixture_terms];  ///< d_k
};

// S: 0.75 %
inline constexpr MixtureCoefficients ball_mixture = {
    2,
    {1.2917, -11.6865, 37.2404, -48.8929, 23.0630},
    {-1.0237, 12.5462, -37.3604, 46.1848, -20.1122},
};

// S: 0.07 %
inline constexpr MixtureCoefficients pin_mixture = {
    3,
    {0.0511, -1.4513, 0.9431, -0.4792, 0.0545},
    {-0.8214, 2.1728, -6.9457, 8.9377, -3.5582},
};

}  // namespace contact::detail
// clang-format on
