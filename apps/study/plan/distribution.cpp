#include "study/plan/distribution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <numeric>
#include <vector>

namespace study {
namespace {

using contact::Interval;
using contact::TomlTable;

constexpr contact::ArrayShape one_or_more{.rows = 1, .or_more = true};

// Low and high of a range, both required.
std::pair<double, double> read_range(const TomlTable& table) {
  const double low = table.number("low");
  const double high = table.number("high");
  if (!(low < high)) table.must_be("high", "above low");
  // Draws are squared.
  constexpr double widest = 1e150;
  if (!(high - low <= widest)) table.must_be("high", "at most 1e150 above low");
  return {low, high};
}

// A distribution of Boost, truncated at low and high if they are given.
template <class Distribution>
Quantile truncated(const TomlTable& table, const Distribution& all) {
  const auto low = table.optional_number("low");
  const auto high = table.optional_number("high");
  if (low && high && !(*low < *high)) table.must_be("high", "above low");
  const auto below = [&all](double x) {
    return x <= range(all).first ? 0.0 : cdf(all, x);
  };
  const double from = low ? below(*low) : 0;
  const double to = high ? below(*high) : 1;
  // The remaining part is drawn from, and must keep more than its last digits.
  constexpr double least = 1e-6;
  if (!(to - from > least)) {
    table.must_be(low ? "low" : "high",
                  "a limit that leaves a millionth of the distribution");
  }
  const double bottom = low.value_or(-Interval::largest);
  const double top = high.value_or(Interval::largest);
  if (from >= 0.5) {
    // Uses the upper tail: doubles are sparse near 1, and 1 has no quantile.
    const double most = cdf(complement(all, *low));
    const double rest = high ? cdf(complement(all, *high)) : 0;
    return [all, most, rest, bottom, top](double u) {
      const double above = rest + (most - rest) * (1 - u);
      return std::clamp(quantile(complement(all, above)), bottom, top);
    };
  }
  return [all, from, to, bottom, top](double u) {
    return std::clamp(quantile(all, from + (to - from) * u), bottom, top);
  };
}

Quantile read_triangular(const TomlTable& table) {
  const auto [low, high] = read_range(table);
  const double mode = table.number("mode", {low, high});
  return [all = boost::math::triangular(low, mode, high)](double u) {
    return quantile(all, u);
  };
}

// Linear between the points of the cumulative probability.
Quantile read_table(const TomlTable& table) {
  auto values = table.numbers("values", {.rows = 2, .or_more = true});
  auto part = table.numbers("cumulative", {.rows = values.size()});
  const auto rises = [](const std::vector<double>& numbers) {
    return std::is_sorted(numbers.begin(), numbers.end(), std::less_equal<>());
  };
  if (!rises(values)) table.must_be("values", "numbers that grow");
  if (!rises(part) || part.front() != 0 || part.back() != 1) {
    table.must_be("cumulative", "numbers that grow from 0 to 1");
  }
  return [values, part](double u) {
    const auto above = std::upper_bound(part.begin() + 1, part.end() - 1, u);
    const auto i = static_cast<std::size_t>(above - part.begin());
    const double share = (u - part[i - 1]) / (part[i] - part[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  };
}

Quantile read_list(const TomlTable& table) {
  auto values = table.numbers("values", one_or_more);
  std::vector<double> until(values.size(), 1);
  if (const auto weights =
          table.optional_numbers("weights", {.rows = values.size()})) {
    until = *weights;
  }
  std::partial_sum(until.begin(), until.end(), until.begin());
  return [values, until](double u) {
    const auto place =
        std::upper_bound(until.begin(), until.end() - 1, u * until.back());
    return values[static_cast<std::size_t>(place - until.begin())];
  };
}

}  // namespace

Quantile read_distribution(const TomlTable& table) {
  using boost::math::lognormal;
  using boost::math::normal;
  switch (table.choice("kind")) {
    case 0:
      return truncated(table,
                       normal(table.number("mean"), table.number("deviation")));
    case 1:
      return truncated(table, lognormal(std::log(table.number("median")),
                                        table.number("log_deviation")));
    case 2:
      return [range = read_range(table)](double u) {
        return range.first + (range.second - range.first) * u;
      };
    case 3:
      return read_triangular(table);
    case 4:
      return read_table(table);
    default:
      return read_list(table);
  }
}

std::string distribution_text(const TomlTable& table) {
  const std::string kind = table.text("kind");
  std::string text = kind;
  for (const contact::KnownKey& key : distribution_keys()) {
    const bool is_of_kind =
        fmt::format(" {} ", key.kinds).find(' ' + kind + ' ') != kind.npos;
    if (!is_of_kind || !table.has(key.key)) continue;
    const bool is_list = kind == "table" || kind == "list";
    const auto numbers = is_list ? table.numbers(key.key, one_or_more)
                                 : std::vector{table.number(key.key)};
    text += fmt::format(", {} {}", key.key, fmt::join(numbers, " "));
  }
  return text;
}

contact::KnownKeys distribution_keys() {
  const auto key = [](std::string_view name, std::string_view kinds,
                      const Interval& range = Interval::any()) {
    contact::KnownKey known = contact::number_key(name, range);
    known.kinds = kinds;
    return known;
  };
  constexpr auto positive = Interval::positive();
  return {contact::word_key("kind", {"normal", "log_normal", "uniform",
                                     "triangular", "table", "list"}),
          key("mean", "normal"),
          key("deviation", "normal", positive),
          key("median", "log_normal", positive),
          key("log_deviation", "log_normal", positive),
          key("low", "normal log_normal uniform triangular"),
          key("high", "normal log_normal uniform triangular"),
          key("mode", "triangular"),
          key("values", "table list"),
          key("cumulative", "table", {0, 1}),
          key("weights", "list", positive)};
}

}  // namespace study
