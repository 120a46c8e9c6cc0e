#pragma once

#include <string>

#include "libcontact/pair/material.hpp"
#include "support/numbers.hpp"

namespace contact::test {

/// A pair by its modulus ratio and Poisson's ratios, inner body first.
struct PairCase {
  double ratio, nu1, nu2;
  ElasticPair elastic() const {
    return ElasticPair::from_modulus_ratio(ratio, nu1, nu2);
  }
  std::string label() const {
    return "Ebar " + std::to_string(ratio) + ", nu " + std::to_string(nu1) +
           " " + std::to_string(nu2);
  }
};

/// Both ends and the middle of all ranges, and both sides of the switches of
/// the exact law's number of terms (theta0* = 95 and 138 deg).
inline constexpr PairCase exact_pairs[] = {
    {1, 0.3, 0.3},   {1, 0.3, 0.2},       {0, 0.3, 0.3}, {infinity, 0.3, 0},
    {0, 0.2, 0.2},   {0.3, 0, 0.5},       {1, 0, 0.5},   {1, 0.5, 0},
    {0, 0.33, 0.3},  {0, 0.45, 0.3},      {0, 0.49, 0},  {0.01, 0.49, 0.2},
    {1e-6, 0.3, 0},  {100, 0.5, 0.5},     {1e6, 0.2, 0}, {0.02, 0.32, 0.3},
    {0, 0.497, 0.3}, {0.001, 0.499, 0.3},
};

/// A selection of all cases.
inline constexpr PairCase fitted_pairs[] = {
    {1, 0.3, 0.3},   {0, 0.3, 0.3},    {infinity, 0.3, 0.25}, {0.01, 0.49, 0.2},
    {100, 0.2, 0.4}, {0.5, 0.1, 0.45}, {0, 0.5, 0.3},         {1, 0, 0.5}};

}  // namespace contact::test
