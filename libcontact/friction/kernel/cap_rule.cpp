#include "libcontact/friction/kernel/cap_rule.hpp"

#include <bit>
#include <cstdint>

#include "libcontact/friction/kernel/rule_set.hpp"

namespace contact::detail {
namespace {

using namespace rules;

/// The rules of cap_rule(): not even the first use allocates.
class LongRules : public RuleSet {
 public:
  LongRules() {
    for_ranges([this](int index, const Modulus& modulus) {
      // Found by measurement: at most 3e-16 of error over all contacts and
      // axes.
      const Real k = modulus.k;
      const int n = node_count(8 * k / modulus.kc + 0.35L);
      fill(index, n,
           [&](int i) { return modulus.node(k * (i + 0.5L) / n, k / n); });
    });
    fill_index();
  }
  const CapRuleIndex& index() const { return index_; }

 private:
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

  CapRuleIndex index_{};
};

const LongRules& long_rules() {
  static const LongRules rules;
  return rules;
}

}  // namespace

const CapRule& cap_rule(int index) { return long_rules().rules()[index]; }
const CapRuleIndex& cap_rule_index() { return long_rules().index(); }

}  // namespace contact::detail
