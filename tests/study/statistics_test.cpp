// Draws, distributions, verdicts and drivers, each against another route.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "study/plan/design.hpp"
#include "study/plan/distribution.hpp"
#include "study/plan/draws.hpp"
#include "study/statistics/drivers.hpp"
#include "study/statistics/verdict.hpp"
#include "support/error_message.hpp"

namespace contact::test::statistics_test {
namespace {

using study::Stream;

// Philox 4x32-10 as its authors describe it (Salmon et al., SC11, section 3.3).
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c,
                                    std::array<std::uint32_t, 2> k) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
    c = {std::uint32_t(b >> 32) ^ c[1] ^ k[0], std::uint32_t(b),
         std::uint32_t(a >> 32) ^ c[3] ^ k[1], std::uint32_t(a)};
    k = {k[0] + 0x9E3779B9, k[1] + 0xBB67AE85};
  }
  return c;
}

TEST(Stream, IsPhiloxOfSeedRunAndHash) {
  // The known answers of its authors.
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c,
                                          0x9b00dbd8}));
  // FNV's own table.
  EXPECT_EQ(study::hash_of(""), 0xcbf29ce484222325);
  EXPECT_EQ(study::hash_of("a"), 0xaf63dc4c8601ec8c);
  const auto answer = philox({5, 2, 0x8601ec8c, 0xaf63dc4c}, {9, 1});
  EXPECT_EQ(Stream(0x100000009, "a").bits(0x200000005),
            std::uint64_t{answer[1]} << 32 | answer[0]);
  EXPECT_EQ(study::uniform_of(0), study::lowest_uniform);
  EXPECT_EQ(study::uniform_of(~std::uint64_t{0}), study::highest_uniform);
}

TEST(Stream, IsUniformAndIndependent) {
  constexpr int n = 100'000;
  const Stream a(7, "a");
  const Stream b(7, "b");
  const Stream other_seed(8, "a");
  double mean = 0;
  double square = 0;
  double with_b = 0;
  double with_seed = 0;
  double with_next = 0;
  for (int i = 0; i < n; ++i) {
    const double u = a.uniform(i) - 0.5;
    mean += u / n;
    square += u * u / n;
    with_b += u * (b.uniform(i) - 0.5) / n;
    with_seed += u * (other_seed.uniform(i) - 0.5) / n;
    with_next += u * (a.uniform(i + 1) - 0.5) / n;
  }
  // Four deviations of the means: 1/sqrt(12 n), sqrt(1/180/n), 1/12/sqrt(n).
  const double root = std::sqrt(n);
  EXPECT_NEAR(mean, 0, 4 / std::sqrt(12) / root);
  EXPECT_NEAR(square, 1. / 12, 4 / std::sqrt(180) / root);
  for (const double covariance : {with_b, with_seed, with_next}) {
    EXPECT_NEAR(covariance, 0, 4. / 12 / root);
  }
}

TEST(Stream, PermutationsAreWhole) {
  const Stream stream(3, "key");
  for (const std::uint64_t n : {1, 2, 3, 10, 64, 1000}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < n; ++i) {
      places.insert(stream.permuted(i, n));
    }
    EXPECT_EQ(places.size(), n);
    EXPECT_EQ(*places.rbegin(), n - 1);
  }
  EXPECT_NE(stream.permuted(0, 1000), Stream(3, "other").permuted(0, 1000));
}

study::Quantile quantile_of(const std::string& text) {
  return study::read_distribution(
      TomlTable::from_text(text, "d.toml", study::distribution_keys()));
}

struct Moments {
  double mean;
  double deviation;
};
// By the midpoint rule over u.
Moments moments(const study::Quantile& quantile) {
  constexpr int n = 200'000;
  double mean = 0;
  double square = 0;
  for (int i = 0; i < n; ++i) {
    const double x = quantile((i + 0.5) / n);
    mean += x / n;
    square += x * x / n;
  }
  return {mean, std::sqrt(square - mean * mean)};
}

// Closed formulas of mean and deviation; the rule's error comes from the tails.
TEST(Distribution, MomentsOfAllKinds) {
  const auto expect = [](const std::string& text, double mean,
                         double deviation) {
    const Moments m = moments(quantile_of(text));
    EXPECT_NEAR(m.mean, mean, 2e-5 * deviation) << text;
    EXPECT_NEAR(m.deviation, deviation, 1e-4 * deviation) << text;
  };
  expect("kind = 'normal'\nmean = 3\ndeviation = 2\n", 3, 2);
  // Cut at one deviation: variance 1 - 2 phi(1)/(2 Phi(1) - 1).
  expect("kind = 'normal'\nmean = 3\ndeviation = 2\nlow = 1\nhigh = 5\n", 3,
         2 * std::sqrt(1 - 2 * 0.24197072451914337 / 0.6826894921370859));
  expect("kind = 'log_normal'\nmedian = 2\nlog_deviation = 0.25\n",
         2 * std::exp(0.03125),
         2 * std::exp(0.03125) * std::sqrt(std::expm1(0.0625)));
  expect("kind = 'uniform'\nlow = -1\nhigh = 3\n", 1, 4 / std::sqrt(12));
  expect("kind = 'triangular'\nlow = 0\nmode = 1\nhigh = 4\n", 5. / 3,
         std::sqrt((16. + 1 - 4) / 18));
  // Half of it uniform in 0 to 1, half in 1 to 5.
  expect("kind = 'table'\nvalues = [0, 1, 5]\ncumulative = [0, 0.5, 1]\n", 1.75,
         std::sqrt((1. / 3 + 124. / 12) / 2 - 1.75 * 1.75));
  expect("kind = 'list'\nvalues = [1, 2, 4]\n", 7. / 3, std::sqrt(14. / 9));
  expect("kind = 'list'\nvalues = [1, 2]\nweights = [1, 3]\n", 1.75,
         std::sqrt(3. / 16));
}

// The part left above a limit is the mirror of that left below, to the last
// draw: next to 1 a probability has no such digits.
TEST(Distribution, HasTailsAboveAsBelow) {
  const std::string normal = "kind = 'normal'\nmean = 0\ndeviation = 1\n";
  for (const auto& [above, below] :
       {std::pair("low = 4\n", "high = -4\n"),
        {"low = 3.75\nhigh = 11.25\n", "low = -11.25\nhigh = -3.75\n"}}) {
    const auto up = quantile_of(normal + above);
    const auto down = quantile_of(normal + below);
    for (const double u : {0x1p-53, 0.1, 0.5, 0.9, 1 - 0x1p-53}) {
      EXPECT_NEAR(up(u), -down(1 - u), 1e-12) << u;
    }
  }
}

TEST(Distribution, LimitsAreKept) {
  const auto cut = quantile_of(
      "kind = 'normal'\nmean = 0\ndeviation = 1\nlow = -0.5\nhigh = 2\n");
  EXPECT_NEAR(cut(study::lowest_uniform), -0.5, 1e-12);
  EXPECT_NEAR(cut(study::highest_uniform), 2, 1e-12);
  EXPECT_LE(-0.5, cut(study::lowest_uniform));
  EXPECT_LE(cut(study::highest_uniform), 2);
  EXPECT_ERROR(quantile_of("kind = 'uniform'\nlow = 1\nhigh = 1\n"),
               "d.toml:3: high = 1 must be above low");
  for (const char* const kind : {"'uniform'", "'triangular'\nmode = 0"}) {
    const std::string text = std::string("kind = ") + kind;
    EXPECT_TRUE(
        std::isfinite(quantile_of(text + "\nlow = -1\nhigh = 1e150\n")(0.5)));
    EXPECT_TRUE(error_message([&] {
                  quantile_of(text + "\nlow = -1e150\nhigh = 1e150\n");
                }).ends_with("high = 1e+150 must be at most 1e150 above low"));
  }
  EXPECT_ERROR(
      quantile_of("kind = 'normal'\nmean = 0\ndeviation = 1\nlow = 9\n"),
      "d.toml:4: low = 9 must be a limit that leaves a millionth of the "
      "distribution");
}

// Hanson and Beard, NASA/TP-2010-216447, at 10 % consumer's risk; those with
// more failures from the sum of the binomial's terms.
TEST(Verdict, RunsNeeded) {
  const std::vector<std::size_t> three_sigma = {852, 1440, 1970};
  const std::vector<std::size_t> one_sided = {1705, 2880, 3941, 4947, 5920};
  for (std::size_t k = 0; k < three_sigma.size(); ++k) {
    EXPECT_EQ(study::runs_needed(k, {0.9973, 0.1}), three_sigma[k]);
  }
  for (std::size_t k = 0; k < one_sided.size(); ++k) {
    EXPECT_EQ(study::runs_needed(k, {0.99865, 0.1}), one_sided[k]);
  }
  // Probability of at most k failures by its terms.
  const auto by_terms = [](std::size_t failures, std::size_t n, double p) {
    double term = std::exp(static_cast<double>(n) * std::log1p(-p));
    double sum = term;
    for (std::size_t k = 1; k <= failures; ++k) {
      term *=
          static_cast<double>(n - k + 1) / static_cast<double>(k) * p / (1 - p);
      sum += term;
    }
    return sum;
  };
  for (const double success : {0.9, 0.99, 0.9973, 0.99865}) {
    for (const double risk : {0.05, 0.1, 0.5}) {
      for (std::size_t k = 0; k < 12; ++k) {
        const std::size_t n = study::runs_needed(k, {success, risk});
        EXPECT_LE(by_terms(k, n, 1 - success), risk * (1 + 1e-10));
        EXPECT_GT(by_terms(k, n - 1, 1 - success), risk * (1 - 1e-10));
      }
    }
  }
}

TEST(Verdict, MetOpenNotMet) {
  using study::Answer;
  const study::Demand demand{0.9973, 0.1};
  EXPECT_EQ(study::answer(0, 852, demand), Answer::met);
  EXPECT_EQ(study::answer(0, 851, demand), Answer::open);
  EXPECT_EQ(study::answer(1, 1439, demand), Answer::open);
  EXPECT_EQ(study::answer(1, 1440, demand), Answer::met);
  EXPECT_EQ(study::answer(20, 1440, demand), Answer::not_met);
}

// The upper bound is the probability asked for, where the verdict changes.
TEST(Verdict, BoundsAgreeWithIt) {
  const auto bounds = study::failure_bounds(0, 1705, 0.1);
  EXPECT_EQ(bounds.low, 0);
  EXPECT_NEAR(bounds.high, 1 - std::pow(0.1, 1. / 1705), 1e-14);
  for (const std::size_t k : {1, 5, 40}) {
    const auto [low, high] = study::failure_bounds(k, 1000, 0.05);
    // Clopper and Pearson's definition, by the distribution itself.
    using boost::math::binomial;
    EXPECT_NEAR(cdf(binomial(1000, high), double(k)), 0.05, 1e-10);
    EXPECT_NEAR(cdf(complement(binomial(1000, low), double(k) - 1)), 0.05,
                1e-10);
  }
}

// Bounds from many studies of 200 runs are wrong as often as the risk says, but
// for the effect of whole numbers, and not more often.
TEST(Percentile, BoundsHoldAsOftenAsTheySay) {
  constexpr int studies = 4000;
  constexpr std::size_t runs = 200;
  const double share = 0.95;
  int above = 0;
  int below = 0;
  int too_small = 0;
  for (int s = 0; s < studies; ++s) {
    const Stream stream(static_cast<std::uint64_t>(s), "x");
    std::vector<double> sorted;
    for (std::size_t i = 0; i < runs; ++i) sorted.push_back(stream.uniform(i));
    std::ranges::sort(sorted);
    const auto p = study::percentile(sorted, share, 0.1);
    ASSERT_TRUE(p.low && p.high);
    below += *p.high < share;
    above += *p.low > share;
    too_small += p.value < share;
    EXPECT_LE(*p.low, p.value);
    EXPECT_GE(*p.high, p.value);
  }
  EXPECT_NEAR(too_small, 0.5 * studies, 4 * std::sqrt(0.25 * studies));
  // The exact shares follow the binomial; 4 deviations of the counts.
  const double most = 0.1 * studies + 4 * std::sqrt(0.09 * studies);
  EXPECT_LT(below, most);
  EXPECT_LT(above, most);
  EXPECT_GT(below, 0.05 * studies);
  EXPECT_GT(above, 0.05 * studies);
}

// 1705 runs without a failure make the largest a bound of 99.865 %.
TEST(Percentile, TheLargestIsABoundWhereTheVerdictIsMet) {
  std::vector<double> sorted(1704);
  std::iota(sorted.begin(), sorted.end(), 1.0);
  EXPECT_FALSE(study::percentile(sorted, 0.99865, 0.1).high);
  sorted.push_back(1705);
  EXPECT_EQ(study::percentile(sorted, 0.99865, 0.1).high, 1705);
  EXPECT_EQ(study::percentile(sorted, 1 - 0.99865, 0.1).low, 1);
}

// Far beyond what so few runs can tell the estimate is no further out.
TEST(Percentile, EstimatesStayWithinTheirBounds) {
  const std::vector<double> few = {1, 2, 4, 8};
  EXPECT_EQ(study::percentile(few, 0.00135, 0.1).value, 1);
  EXPECT_EQ(study::percentile(few, 0.99865, 0.1).value, 8);
  EXPECT_EQ(study::percentile(few, 0.5, 0.1).value, 3);
  EXPECT_EQ(study::percentile({few.data(), 1}, 0.3, 0.1).value, 1);
}

TEST(Drivers, RanksAndCorrelation) {
  const double nan = std::nan("");
  const std::vector<double> values = {3, 1, nan, 3, -2};
  const auto r = study::ranks(values);
  EXPECT_EQ(r[0], 3.5);
  EXPECT_EQ(r[1], 2);
  EXPECT_TRUE(std::isnan(r[2]));
  EXPECT_EQ(r[3], 3.5);
  EXPECT_EQ(r[4], 1);
  // 1 - 6 sum d^2/(n (n^2 - 1)) without ties.
  const std::vector<double> a = {1, 2, 3, 4, 5};
  const std::vector<double> b = {10, 30, 20, 50, 40};
  EXPECT_NEAR(study::correlation(study::ranks(a), study::ranks(b)), 0.8, 1e-15);
  const std::vector<double> flat(5, 1.0);
  EXPECT_TRUE(std::isnan(study::correlation(a, flat)));
}

// y = 3 a - 4 b with independent unit scatter: 0.6, -0.8; a far origin and an
// input that does not vary change nothing.
TEST(Drivers, RegressionOfALinearFunction) {
  study::Regression regression(3);
  for (int i = 0; i < 400; ++i) {
    // All pairs of 20 x 20, so exactly uncorrelated.
    const double a = 1e6 + i % 20;
    const double b = i / 20;
    regression.add(std::vector<double>{a, b, 7}, 3 * a - 4 * b);
  }
  regression.add(std::vector<double>{std::nan(""), 1, 7}, 5);
  const auto answer = regression.solve();
  EXPECT_NEAR(answer.standardised[0], 0.6, 1e-9);
  EXPECT_NEAR(answer.standardised[1], -0.8, 1e-9);
  EXPECT_EQ(answer.standardised[2], 0);
  EXPECT_NEAR(answer.explained, 1, 1e-9);
}

// A plane fits as many rows as it has numbers, whatever they say: no answer.
TEST(Drivers, RegressionNeedsMoreRowsThanItFits) {
  study::Regression regression(2);
  const auto add = [&](double a, double b) {
    regression.add(std::vector<double>{a, b}, 2 * a + b);
  };
  add(0, 0);
  add(1, 0);
  add(0, 1);
  EXPECT_TRUE(std::isnan(regression.solve().explained));
  EXPECT_TRUE(std::isnan(regression.solve().standardised[0]));
  add(1, 1);
  EXPECT_NEAR(regression.solve().explained, 1, 1e-12);
}

study::Plan plan_of(study::Sampling sampling, std::uint64_t runs,
                    std::size_t keys) {
  const TomlTable table = TomlTable::from_text("", "s.toml", {});
  study::Plan plan{.name = "test",
                   .case_file = {},
                   .joint_file = {},
                   .runs = runs,
                   .seed = 5,
                   .sampling = sampling,
                   .factors = {},
                   .dispersions = {},
                   .requirements = {},
                   .quantities = {},
                   .path = {},
                   .file = table};
  for (std::size_t i = 0; i < keys; ++i) {
    plan.dispersions.push_back({.key = std::string(1, char('a' + i)),
                                .relative = false,
                                .each = false,
                                .quantile = [](double u) { return u; },
                                .distribution = {},
                                .shares = {},
                                .content = {},
                                .table = table});
  }
  return plan;
}

// A function of three uniform numbers with its indices in closed form.
struct Known {
  const char* name;
  double (*f)(const std::vector<double>& u);
  double first[3];
  double total[3];
};

// Saltelli et al. (2010), with a = 7, b = 0.1.
double ishigami(const std::vector<double>& u) {
  const auto x = [&](int i) { return (2 * u[i] - 1) * std::numbers::pi; };
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) +
         0.1 * std::pow(x(2), 4) * std::sin(x(0));
}
// The variances of a sum add up; the variance of a product of independent
// numbers with means m, n and variances V, W is V n^2 + W m^2 + V W.
double sum_and_product(const std::vector<double>& u) {
  return 3 * u[0] + (u[1] + 0.5) * (4 * u[2] + 1);
}
double mostly_the_first(const std::vector<double>& u) {
  return 10 * u[0] + 0.5 * u[1] + 0.1 * u[2] + 0.2 * u[0] * u[1];
}

// The variances of each input alone, and its interactions.
Known known(const char* name, double (*f)(const std::vector<double>&),
            const std::array<double, 3>& alone,
            const std::array<double, 3>& shared) {
  const double sum =
      alone[0] + alone[1] + alone[2] + (shared[0] + shared[1] + shared[2]) / 2;
  Known result{name, f, {}, {}};
  for (int i = 0; i < 3; ++i) {
    result.first[i] = alone[i] / sum;
    result.total[i] = (alone[i] + shared[i]) / sum;
  }
  return result;
}
std::vector<Known> known_functions() {
  const double pi4 = std::pow(std::numbers::pi, 4);
  const double v13 = 0.01 * pi4 * pi4 * (1. / 18 - 1. / 50);
  return {
      known("Ishigami", ishigami,
            {std::pow(1 + 0.1 * pi4 / 5, 2) / 2, 49. / 8, 0}, {v13, 0, v13}),
      known("sum and product", sum_and_product, {9. / 12, 9. / 12, 16. / 12},
            {0, 1. / 9, 1. / 9}),
      known("mostly the first", mostly_the_first,
            {10.1 * 10.1 / 12, 0.36 / 12, 0.01 / 12},
            {0.04 / 144, 0.04 / 144, 0})};
}

std::vector<study::SobolIndex> indices_of(const Known& known,
                                          std::uint64_t seed,
                                          std::uint64_t points) {
  constexpr std::uint64_t shifts = study::Design::shifts;
  auto plan = plan_of(study::Sampling::saltelli, points * shifts * 5, 3);
  plan.seed = seed;
  const study::Design design(plan, {{}, {}, {}});
  std::vector<double> outputs;
  for (std::uint64_t run = 1; run <= plan.runs; ++run) {
    outputs.push_back(known.f(design.numbers(run)));
  }
  return study::sobol_indices(outputs, 3, shifts);
}

TEST(Drivers, SobolIndicesOfKnownFunctions) {
  for (const Known& known : known_functions()) {
    const auto indices = indices_of(known, 5, 512);
    for (int i = 0; i < 3; ++i) {
      // Three times the largest true error of 200 seeds, Ishigami's.
      EXPECT_NEAR(indices[i].first, known.first[i], 0.018) << known.name << i;
      EXPECT_NEAR(indices[i].total, known.total[i], 0.018) << known.name << i;
    }
  }
}

// Root mean squares over 100 seeds: what is said, and how far the indices are
// from the true ones. Both scatter by a tenth.
TEST(Drivers, SobolErrorsAreAsLargeAsTheySay) {
  constexpr int seeds = 100;
  for (const Known& known : known_functions()) {
    for (const std::uint64_t points : {4, 16, 32}) {
      std::array<double, 6> said{};
      std::array<double, 6> true_error{};
      for (int seed = 1; seed <= seeds; ++seed) {
        const auto indices =
            indices_of(known, static_cast<std::uint64_t>(seed), points);
        for (int i = 0; i < 3; ++i) {
          const study::SobolIndex& s = indices[i];
          said[i] += s.first_error * s.first_error;
          said[3 + i] += s.total_error * s.total_error;
          true_error[i] += std::pow(s.first - known.first[i], 2);
          true_error[3 + i] += std::pow(s.total - known.total[i], 2);
        }
      }
      for (int i = 0; i < 6; ++i) {
        const double ratio = std::sqrt(said[i] / true_error[i]);
        EXPECT_GT(ratio, 0.7) << known.name << ' ' << points << ' ' << i;
        EXPECT_LT(ratio, 1.4) << known.name << ' ' << points << ' ' << i;
      }
    }
  }
}

// Runs that failed take their group with them.
// Two shifts of a point each, by hand: the variances of the points are 25/16
// and 45/16, the squares of the changes half of 1 and of 25.
TEST(Drivers, SobolErrorsOfTwoShifts) {
  const std::vector<double> outputs = {1, 3, 2, 2, 5, 7};
  const auto index = study::sobol_indices(outputs, 1, 2)[0];
  EXPECT_NEAR(index.total, 104.0 / 35, 1e-14);
  EXPECT_NEAR(index.total_error, 58 / 30.625, 1e-14);
}

TEST(Drivers, SobolIndicesWithoutSomeGroups) {
  std::vector<double> outputs;
  for (int i = 0; i < 16 * 3; ++i) {
    outputs.push_back(Stream(1, "f").uniform(static_cast<std::uint64_t>(i)));
  }
  // All of shift 2, and one group of shift 5.
  std::vector<double> some = outputs;
  for (const int group : {2, 10, 13}) some[group * 3 + 1] = std::nan("");
  EXPECT_GT(study::sobol_indices(some, 1, 8)[0].first_error, 0);
  // One shift has no spread.
  for (int group = 0; group < 16; ++group) {
    if (group % 8 != 3) some[group * 3] = std::nan("");
  }
  EXPECT_TRUE(std::isnan(study::sobol_indices(some, 1, 8)[0].first));
}

TEST(Design, ALatinHypercubeHasOneRunInEachCell) {
  constexpr std::uint64_t runs = 97;
  const auto plan = plan_of(study::Sampling::latin_hypercube, runs, 2);
  const study::Design design(plan, {{}, {}});
  std::set<int> cells[2];
  for (std::uint64_t run = 1; run <= runs; ++run) {
    const auto u = design.uniforms(run);
    for (int i = 0; i < 2; ++i) cells[i].insert(int(u[i] * runs));
  }
  EXPECT_EQ(cells[0].size(), runs);
  EXPECT_EQ(cells[1].size(), runs);
}

// Any 2^k points of the sequence that begin at a multiple have one in each of
// 2^k strips: in any half of the digits, scrambled or not.
TEST(Design, SobolPointsFillTheSquareEvenly) {
  const auto plan = plan_of(study::Sampling::sobol, 4096, 2);
  const study::Design design(plan, {{}, {}});
  double sum = 0;
  for (std::uint64_t run = 1; run <= plan.runs; ++run) {
    const auto u = design.uniforms(run);
    sum += u[0] * u[1] / 4096;
  }
  // Random points: 0.25 +- 0.003.
  EXPECT_NEAR(sum, 0.25, 3e-4);
  // The origin of the sequence is one of them.
  for (const std::uint64_t points : {4, 16, 256}) {
    std::set<int> strips;
    for (std::uint64_t run = 1; run <= points; ++run) {
      strips.insert(int(design.uniforms(run)[1] * double(points)));
    }
    EXPECT_EQ(strips.size(), points);
  }
}

// More runs leave the first ones, and the rows of a journal are of one design.
TEST(Design, SaltellisRunsAreDealtOutToShifts) {
  const auto few = plan_of(study::Sampling::saltelli, 40, 3);
  const auto more = plan_of(study::Sampling::saltelli, 400, 3);
  const study::Design a(few, {{}, {}, {}});
  const study::Design b(more, {{}, {}, {}});
  std::set<double> first;
  for (std::uint64_t run = 1; run <= 40; ++run) {
    EXPECT_EQ(a.uniforms(run), b.uniforms(run));
    if (run % 5 == 1) first.insert(a.uniforms(run)[0]);
  }
  EXPECT_EQ(first.size(), study::Design::shifts);
  EXPECT_EQ(a.identity(), b.identity());
}

TEST(Design, IdentitiesDiffer) {
  std::set<std::string> identities;
  for (const auto sampling :
       {study::Sampling::random, study::Sampling::latin_hypercube,
        study::Sampling::sobol, study::Sampling::saltelli}) {
    auto plan = plan_of(sampling, 40, 3);
    identities.insert(study::Design(plan, {{}, {}, {}}).identity());
    plan.seed = 6;
    identities.insert(study::Design(plan, {{}, {}, {}}).identity());
  }
  EXPECT_EQ(identities.size(), 8u);
  // Cells of a Latin hypercube are as many as runs.
  const auto plan = plan_of(study::Sampling::latin_hypercube, 80, 3);
  EXPECT_TRUE(
      identities.insert(study::Design(plan, {{}, {}, {}}).identity()).second);
}

// Scores of factors and their own beyond all doubles below 1.
TEST(Design, FactorsLeaveNoDrawAtAnEnd) {
  auto plan = plan_of(study::Sampling::random, 1, 2);
  plan.factors = {"weather"};
  plan.dispersions[0].shares = {{0, 0.7}};
  const study::Design design(plan, {{}, {}});
  for (const double u : {study::lowest_uniform, study::highest_uniform}) {
    EXPECT_EQ(design.numbers_of({u, u, 0.5})[0], design.number(0, u));
  }
}

TEST(Design, FactorsCorrelateDraws) {
  auto plan = plan_of(study::Sampling::random, 20'000, 3);
  plan.factors = {"weather"};
  plan.dispersions[0].shares = {{0, 0.8}};
  plan.dispersions[1].shares = {{0, -0.6}};
  const study::Design design(plan, {{}, {}, {}});
  const boost::math::normal normal;
  std::vector<double> scores[3];
  for (std::uint64_t run = 1; run <= plan.runs; ++run) {
    const auto u = design.numbers(run);
    for (int i = 0; i < 3; ++i) scores[i].push_back(quantile(normal, u[i]));
  }
  // Four deviations of a correlation coefficient.
  const double tolerance = 4 / std::sqrt(20'000);
  EXPECT_NEAR(study::correlation(scores[0], scores[1]), -0.48, tolerance);
  EXPECT_NEAR(study::correlation(scores[0], scores[2]), 0, tolerance);
  // The scatter of each alone stays as it was.
  const Moments m = moments([&, i = std::size_t{0}](double) mutable {
    return scores[0][i++ % scores[0].size()];
  });
  EXPECT_NEAR(m.mean, 0, tolerance);
  EXPECT_NEAR(m.deviation, 1, tolerance);
}

// Another key leaves the draws of the others, and copies have draws of their
// own.
TEST(Design, DrawsAreOfSeedRunAndKeyAlone) {
  const auto two = plan_of(study::Sampling::random, 10, 2);
  const auto three = plan_of(study::Sampling::random, 1000, 3);
  const study::Design a(two, {{}, {}});
  const study::Design b(three, {{}, {}, {"c 1", "c 2", "c 3", "c 4"}});
  EXPECT_EQ(b.draws().size(), 6u);
  EXPECT_EQ(b.draws()[3].name, "c@2");
  EXPECT_EQ(b.source_label(3), "c, c 2");
  for (std::uint64_t run = 1; run <= 10; ++run) {
    const auto x = a.numbers(run);
    const auto y = b.numbers(run);
    EXPECT_EQ(x[0], y[0]);
    EXPECT_EQ(x[1], y[1]);
    EXPECT_NE(y[2], y[3]);
  }
}

TEST(Design, SaltellisRunsComeInGroups) {
  const auto plan = plan_of(study::Sampling::saltelli, 21, 3);
  EXPECT_ERROR(
      study::Design(plan, {{}, {}, {}}),
      "runs = 21 with sampling = \"saltelli\" must be a multiple of 40: 8 "
      "shifts of 2 runs and one for each of 3 inputs");
}

}  // namespace
}  // namespace contact::test::statistics_test
