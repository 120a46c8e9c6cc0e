#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

namespace contact::detail::rules {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                  boost::multiprecision::et_off>;
inline const Real pi = boost::math::constants::pi<Real>();

/// A node of a rule, as kernel/cap_rule.hpp has it.
struct Node {
  Real cosine, weight;
  Real log_cosine_squared = 0;
};
using Rule = std::vector<Node>;

/// A modulus by its theta functions (Abramowitz and Stegun 16.27), whose
/// relative accuracy lasts up to u = K.
class Modulus {
 public:
  explicit Modulus(const Real& complementary_squared)
      : m(complementary_squared),
        k(quarter_period(m)),
        kc(quarter_period(1 - m)),
        at_0_(thetas(1)) {}

  /// At u, with the weight dn(u) du.
  Node node(const Real& u, const Real& du) const {
    const Real z = pi / 2 * u / (swapped() ? kc : k);
    const Thetas at = thetas(swapped() ? Real(cosh(z)) : Real(cos(z)));
    const Real cn = at_0_[2] / at_0_[0] * at[0] / at[2];
    const Real dn = at_0_[2] / at_0_[1] * at[1] / at[2];
    // K' is taken at iz: Jacobi's imaginary transformation (16.20).
    return swapped() ? Node{1 / cn, du * dn / cn} : Node{cn, du * dn};
  }
  /// The same times cos(am u).
  Node chord_node(const Real& u, const Real& du) const {
    Node result = node(u, du);
    result.weight *= result.cosine;
    return result;
  }

  const Real m;      ///< k'^2
  const Real k, kc;  ///< K, K'

 private:
  /// theta_2/(2 q^(1/4)), theta_3, theta_4.
  using Thetas = std::array<Real, 3>;

  /// K by the arithmetic-geometric mean.
  static Real quarter_period(const Real& complementary_squared) {
    Real a = 1;
    Real b = sqrt(complementary_squared);
    while (a - b > 1e-26) {
      const Real mean = (a + b) / 2;
      b = sqrt(a * b);
      a = mean;
    }
    return pi / (a + b);
  }
  bool swapped() const { return k > kc; }
  /// By the cosine of z; the nome is at most exp(-pi).
  Thetas thetas(const Real& cosine) const {
    const Real q = exp(-pi * std::max(k, kc) / std::min(k, kc));
    Thetas sum{cosine, 1, 1};
    Real even = 1;  // cos 2nz
    Real odd = cosine;
    Real power = 1;  // q^n^2
    for (int n = 1; n <= 8; ++n) {
      even = 2 * cosine * odd - even;
      odd = 2 * cosine * even - odd;
      power *= pow(q, 2 * n - 1);
      sum[0] += power * pow(q, n) * odd;
      sum[1] += 2 * power * even;
      sum[2] += (n % 2 == 0 ? 2 : -2) * power * even;
    }
    return sum;
  }

  const Thetas at_0_;
};

}  // namespace contact::detail::rules
