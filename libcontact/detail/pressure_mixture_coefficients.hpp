#pragma once

// clang-format off
/// Made by the program fit-pressure-mixture
/// (reference/pressure_mixture_fit.hpp); do not edit. Largest relative error
/// of S on the pairs of the fit above each.
namespace contact::detail {

inline constexpr int mixture_terms = 5;
struct MixtureCoefficients {
  double equal[mixture_terms];     ///< c_k, k = 1, 2, ...
  double contrast[mixture_terms];  ///< d_k
};

// S: 0.77 %
inline constexpr MixtureCoefficients ball_mixture = {
    {1.5157, -11.3876, 36.3091, -44.4514, 19.4684},
    {-1.5164, 16.5879, -49.9796, 62.3334, -28.0844},
};

// S: 0.07 %
inline constexpr MixtureCoefficients pin_mixture = {
    {0.0179, 0.3627, -0.1749, 2.7315, -1.8861},
    {-0.7572, 1.6799, -4.9860, 8.6584, -4.6840},
};

}  // namespace contact::detail
// clang-format on
