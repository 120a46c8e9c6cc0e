#include "libcontact/detail/cap_rule.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace contact::detail {
namespace {

using Real = long double;

/// Ranges of k'^2 from 1 downwards: four steps while few nodes suffice and
/// one more or less counts, then octaves. Below 2^-54 the modulus no longer
/// differs from 1 in double precision.
constexpr int octaves = 54;
constexpr std::array<Real, cap_rule_count> lower_bounds = [] {
  std::array<Real, cap_rule_count> bounds{0.875L, 0.625L, 0.5L, 0.375L, 0.25L};
  for (std::size_t i = 5; i < bounds.size(); ++i) bounds[i] = bounds[i - 1] / 2;
  return bounds;
}();
static_assert(lower_bounds.back() == 1 / Real(1LL << octaves));

/// Amplitude am(u, k) by the descending Landen transformation on the
/// arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6).
class Amplitude {
 public:
  explicit Amplitude(Real complementary_modulus) {
    Real b = complementary_modulus;
    a_[0] = 1;
    c_[0] = std::sqrt((1 - b) * (1 + b));
    while (steps_ + 1 < a_.size() && c_[steps_] > 1e-19L * a_[steps_]) {
      const Real a = a_[steps_];
      ++steps_;
      a_[steps_] = (a + b) / 2;
      c_[steps_] = (a - b) / 2;
      b = std::sqrt(a * b);
    }
  }
  Real quarter_period() const {
    return std::numbers::pi_v<Real> / 2 / a_[steps_];
  }
  Real operator()(Real u) const {
    Real phi = std::ldexp(a_[steps_] * u, static_cast<int>(steps_));
    for (std::size_t i = steps_; i > 0; --i) {
      phi = (phi + std::asin(c_[i] / a_[i] * std::sin(phi))) / 2;
    }
    return phi;
  }

 private:
  std::size_t steps_ = 0;
  std::array<Real, 24> a_{};
  std::array<Real, 24> c_{};
};

class Rules {
 public:
  Rules() {
    Real upper = 1;
    for (const Real lower : lower_bounds) {
      append(lower, upper);
      upper = lower;
    }
    // Addresses are taken when the store no longer grows.
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      double* const start = store_.data() + offsets_[i];
      rules_[i].cosine_squared = start;
      rules_[i].sine_squared = start + rules_[i].padded_size;
      rules_[i].weight = start + 2 * rules_[i].padded_size;
    }
    fill_index();
  }
  const CapRule& rule(int index) const { return rules_[index]; }
  const CapRuleIndex& index() const { return index_; }

 private:
  void append(Real lower, Real upper) {
    // The rule's k'^2 sits low in its range, so that no integrand of the
    // range has a singularity nearer than K'. The count was found by
    // measurement: at most 3e-16 of error over all contacts and axes.
    const Real m = lower + 0.15L * (upper - lower);
    const Amplitude am(std::sqrt(m));
    const Real k = am.quarter_period();
    const Real kc = Amplitude(std::sqrt(1 - m)).quarter_period();
    const int n = static_cast<int>(std::ceil(8 * k / kc + 0.35L));
    const int padded =
        (n + CapRule::lanes - 1) / CapRule::lanes * CapRule::lanes;
    const std::size_t start = store_.size();
    offsets_.push_back(start);
    rules_.push_back({n, padded, nullptr, nullptr, nullptr});
    store_.resize(start + 3 * padded, 0.0);
    for (int i = 0; i < padded; ++i) {
      // Padding repeats the last node, with weight 0.
      const Real phi = am(k * (std::min(i, n - 1) + 0.5L) / n);
      const Real s = std::sin(phi);
      const Real c = std::cos(phi);
      store_[start + i] = static_cast<double>(c * c);
      store_[start + padded + i] = static_cast<double>(s * s);
      if (i < n) {
        store_[start + 2 * padded + i] =
            static_cast<double>(k / n * std::sqrt(m + (1 - m) * c * c));
      }
    }
  }

  void fill_index() {
    constexpr std::int64_t width = std::int64_t{1} << CapRuleIndex::shift;
    for (int step = 0; step < CapRuleIndex::steps; ++step) {
      // The smallest number of the step.
      const double m =
          std::bit_cast<double>(CapRuleIndex::one - (step + 1) * width + 1);
      std::size_t i = 0;
      while (i + 1 < lower_bounds.size() && m < lower_bounds[i]) ++i;
      index_.rule_of_step[step] = static_cast<std::uint8_t>(i);
    }
  }

  std::vector<CapRule> rules_;
  std::vector<std::size_t> offsets_;
  std::vector<double> store_;
  CapRuleIndex index_{};
};

const Rules& rules() {
  static const Rules instance;
  return instance;
}

}  // namespace

const CapRule& cap_rule(int index) { return rules().rule(index); }
const CapRuleIndex& cap_rule_index() { return rules().index(); }

}  // namespace contact::detail
