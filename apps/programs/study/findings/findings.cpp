#include "programs/study/findings/findings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libcontact/base/constants.hpp"

namespace study {
namespace {

using contact::detail::infinity;
using contact::detail::nan;

std::vector<double> sorted_numbers(const std::vector<double>& values) {
  std::vector<double> result;
  std::ranges::copy_if(values, std::back_inserter(result),
                       [](double x) { return !std::isnan(x); });
  std::ranges::sort(result);
  return result;
}

// All numbers, with `missing` in place of NaN.
std::vector<double> sorted_with(double missing, std::vector<double> values) {
  std::ranges::replace_if(
      values, [](double x) { return std::isnan(x); }, missing);
  std::ranges::sort(values);
  return values;
}

// The worst run first; runs without a number are the worst.
std::vector<RunValue> worst_of(const std::vector<double>& values,
                               bool at_least) {
  constexpr std::size_t shown = 5;
  std::vector<RunValue> all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    all.push_back({i + 1, values[i]});
  }
  const auto end =
      all.begin() + static_cast<std::ptrdiff_t>(std::min(shown, all.size()));
  const auto badness = [at_least](const RunValue& v) {
    if (std::isnan(v.value)) return infinity;
    return at_least ? -v.value : v.value;
  };
  std::partial_sort(
      all.begin(), end, all.end(), [&](const RunValue& a, const RunValue& b) {
        return std::pair(-badness(a), a.run) < std::pair(-badness(b), b.run);
      });
  return {all.begin(), end};
}

Judgement judge(const Requirement& requirement,
                const std::vector<double>& values, Sampling sampling) {
  Judgement result{};
  const Demand& demand = requirement.demand;
  result.misses = static_cast<std::size_t>(std::ranges::count_if(
      values, [&](double x) { return !requirement.holds(x); }));
  if (sampling == Sampling::random) {
    result.answer = answer(result.misses, values.size(), demand);
    result.miss_probability =
        failure_bounds(result.misses, values.size(), demand.risk);
    result.needed = runs_needed(result.misses, demand);
  }
  result.share = requirement.at_least ? 1 - demand.success : demand.success;
  result.missing = static_cast<std::size_t>(
      std::ranges::count_if(values, [](double x) { return std::isnan(x); }));
  result.percentile = percentile(
      sorted_with(requirement.at_least ? -infinity : infinity, values),
      result.share, demand.risk);
  if (sampling != Sampling::random) {
    result.percentile.low = result.percentile.high = std::nullopt;
  }
  result.worst = worst_of(values, requirement.at_least);
  return result;
}

Scatter scatter(const std::string& name, double nominal,
                const std::vector<double>& values) {
  const auto sorted = sorted_numbers(values);
  const auto n = static_cast<double>(sorted.size());
  const auto lowest = sorted_with(-infinity, values);
  const auto highest = sorted_with(infinity, values);
  const auto at = [&](double p) -> Range {
    return {percentile(lowest, p, 0.5).value,
            percentile(highest, p, 0.5).value};
  };
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / n;
  double squares = 0;
  for (const double x : sorted) squares += (x - mean) * (x - mean);
  return {.quantity = name,
          .nominal = nominal,
          .mean = mean,
          .deviation = n > 1 ? std::sqrt(squares / (n - 1)) : nan,
          .low = sorted.empty() ? nan : sorted.front(),
          .p5 = at(0.05),
          .median = at(0.5),
          .p95 = at(0.95),
          .high = sorted.empty() ? nan : sorted.back(),
          .missing = values.size() - sorted.size()};
}

// A number whose drivers are sought.
struct Output {
  std::string name;
  std::function<double(const Row&)> of;
};

// Requirements and further quantities.
std::vector<Output> outputs_of(const Study& study) {
  std::vector<Output> result;
  const auto add = [&result](const std::string& name, const auto& of) {
    if (std::ranges::count(result, name, &Output::name) > 0) return;
    result.push_back({name, of});
  };
  const auto& requirements = study.plan().requirements;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    add(requirements[i].quantity,
        [&study, i](const Row& row) { return study.value_of(i, row); });
  }
  for (std::size_t i = study.required(); i < study.quantities().size(); ++i) {
    const std::string& name = study.quantities()[i];
    if (name == energy_drift || name == over_limit) continue;
    add(name, [place = study.inputs() + i](const Row& row) {
      return row.numbers[place];
    });
  }
  return result;
}

std::vector<Driven> find_drivers(const Study& study, const Journal& journal) {
  const std::vector<Output> outputs = outputs_of(study);
  std::vector<std::vector<double>> output_ranks;
  std::vector<Regression> regressions(outputs.size(),
                                      Regression(study.inputs()));
  std::vector<Driven> result;
  for (std::size_t o = 0; o < outputs.size(); ++o) {
    const auto numbers = column(study, journal, [&](const Row& row) {
      const double y = outputs[o].of(row);
      regressions[o].add({row.numbers.data(), study.inputs()}, y);
      return y;
    });
    output_ranks.push_back(ranks(numbers));
    result.push_back({outputs[o].name, {}, regressions[o].solve(), {}});
    if (study.plan().sampling == Sampling::saltelli) {
      result.back().sobol = sobol_indices(
          numbers, study.design().sources().size(), Design::shifts);
    }
  }
  for (std::size_t i = 0; i < study.inputs(); ++i) {
    const auto of_input = ranks(
        column(study, journal, [i](const Row& row) { return row.numbers[i]; }));
    for (std::size_t o = 0; o < outputs.size(); ++o) {
      result[o].spearman.push_back(correlation(of_input, output_ranks[o]));
    }
  }
  return result;
}

}  // namespace

std::size_t count_driven(const Study& study) {
  return outputs_of(study).size();
}

std::vector<double> column(const Study& study, const Journal& journal,
                           const std::function<double(const Row&)>& number) {
  std::vector<double> values(study.runs(), nan);
  // Sums in the order of the runs, so that results are bit-identical for any
  // order of completion.
  for (std::uint64_t run = 1; run <= study.runs(); ++run) {
    values[run - 1] = number(journal.at(run));
  }
  return values;
}

namespace {

// Runs in which a contact exceeds the theory or the strength of its materials.
std::size_t count_above_limit(const Study& study, const Journal& journal) {
  const auto names = study.columns();
  const auto found = std::ranges::find(names, over_limit);
  if (found == names.end()) return 0;
  const auto place = static_cast<std::size_t>(found - names.begin());
  const auto shares = column(
      study, journal, [place](const Row& row) { return row.numbers[place]; });
  return static_cast<std::size_t>(
      std::ranges::count_if(shares, [](double x) { return x > 1; }));
}

}  // namespace

Findings find(const Study& study, const Journal& journal) {
  Findings findings{};
  for (std::uint64_t run = 1; run <= study.runs(); ++run) {
    const Row row = journal.at(run);
    if (row.failure.empty()) continue;
    if (findings.failed++ == 0) findings.first_failure = row.failure;
  }
  findings.above_limit = count_above_limit(study, journal);
  const auto& requirements = study.plan().requirements;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    findings.requirements.push_back(
        judge(requirements[i],
              column(study, journal,
                     [&](const Row& row) { return study.value_of(i, row); }),
              study.plan().sampling));
  }
  const Row nominal = journal.at(0);
  for (std::size_t i = 0; i < study.quantities().size(); ++i) {
    const std::size_t place = study.inputs() + i;
    findings.quantities.push_back(scatter(
        study.quantities()[i], nominal.numbers[place],
        column(study, journal,
               [place](const Row& row) { return row.numbers[place]; })));
  }
  findings.driven = find_drivers(study, journal);
  // Changed integrator steps move a number by less.
  constexpr double notable_share = 1e-4;
  std::vector<double> notable;
  for (const Scatter& s : findings.quantities) {
    notable.push_back(notable_share * s.deviation);
  }
  findings.idle = study.idle_keys(notable);
  return findings;
}

}  // namespace study
