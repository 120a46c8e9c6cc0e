#include "study/statistics/verdict.hpp"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "libcontact/base/error.hpp"

namespace study {

double at_most(std::size_t k, std::size_t n, double p) {
  if (k >= n) return 1;
  return cdf(boost::math::binomial(static_cast<double>(n), p),
             static_cast<double>(k));
}

std::size_t runs_needed(std::size_t failures, const Demand& demand) {
  constexpr std::size_t most = 1'000'000'000;
  const auto enough = [&](std::size_t n) {
    return at_most(failures, n, 1 - demand.success) <= demand.risk;
  };
  std::size_t above = failures + 1;
  while (!enough(above)) {
    if (above > most) {
      throw contact::Error("a requirement that needs more than 1e9 runs");
    }
    above *= 2;
  }
  std::size_t below = failures;
  while (above - below > 1) {
    const std::size_t middle = below + (above - below) / 2;
    (enough(middle) ? above : below) = middle;
  }
  return above;
}

Answer answer(std::size_t failures, std::size_t runs, const Demand& demand) {
  const double p = 1 - demand.success;
  if (at_most(failures, runs, p) <= demand.risk) return Answer::met;
  const bool too_many =
      failures > 0 && 1 - at_most(failures - 1, runs, p) <= demand.risk;
  return too_many ? Answer::not_met : Answer::open;
}

Bounds failure_bounds(std::size_t failures, std::size_t runs, double risk) {
  using boost::math::binomial;
  const auto n = static_cast<double>(runs);
  const auto k = static_cast<double>(failures);
  return {binomial::find_lower_bound_on_p(n, k, risk),
          binomial::find_upper_bound_on_p(n, k, risk)};
}

// The i-th of n sorted numbers is below the percentile unless at most i - 1
// numbers are below it.
Percentile percentile(std::span<const double> sorted, double p, double risk) {
  const std::size_t n = sorted.size();
  Percentile result{std::nan(""), {}, {}};
  if (n == 0) return result;
  // Median-unbiased for any distribution: Hyndman and Fan (1996), definition 8.
  const double place =
      std::clamp(p * (static_cast<double>(n) + 1. / 3) - 2. / 3, 0.,
                 static_cast<double>(n - 1));
  const auto i = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(i);
  // (A difference of infinities would be NaN.)
  result.value =
      share == 0 ? sorted[i] : (1 - share) * sorted[i] + share * sorted[i + 1];
  const auto number = [&](double q) {
    return static_cast<std::size_t>(
        quantile(boost::math::binomial_distribution<
                     double, boost::math::policies::policy<
                                 boost::math::policies::discrete_quantile<
                                     boost::math::policies::integer_round_up>>>(
                     static_cast<double>(n), q),
                 1 - risk));
  };
  // Fewer than `number` of n are below it, except with probability `risk`;
  // correspondingly from above.
  const std::size_t below = number(p);
  const std::size_t above = number(1 - p);
  if (below < n) result.high = sorted[below];
  if (above < n) result.low = sorted[n - 1 - above];
  return result;
}

}  // namespace study
