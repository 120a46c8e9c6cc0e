#include "programs/study/findings/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "separation/results/run.hpp"

namespace study {
namespace {

using separation::Rows;

using contact::detail::nan;
// Numbers of a row that contribute to an envelope.
using Numbers = std::function<std::vector<double>(const Rows&, std::size_t)>;

std::vector<double> smallest_clearance(const Rows& rows, std::size_t row) {
  double smallest = nan;
  for (std::size_t j = 0; j < rows.columns.size(); ++j) {
    if (!rows.columns[j].starts_with("clearance.")) continue;
    smallest = std::fmin(smallest, rows.at(row, j));
  }
  return {smallest};
}

std::vector<double> angles(const Rows& rows, std::size_t row) {
  std::vector<double> all;
  const auto released = static_cast<double>(multibody::HingeMode::released);
  for (std::size_t j = 0; j < rows.columns.size(); ++j) {
    if (!rows.columns[j].ends_with(".mode")) continue;
    // The angle's column comes next.
    all.push_back(rows.at(row, j) == released ? nan : rows.at(row, j + 1));
  }
  return all;
}

// Numbers at output times of the case, not more than a picture can show.
class Samples {
 public:
  Samples(const separation::Case& c, Numbers numbers)
      : step_(c.output_step), numbers_(std::move(numbers)) {
    constexpr double most = 300;
    step_ *= std::ceil(c.end_time / step_ / most);
    values_.resize(static_cast<std::size_t>(c.end_time / step_) + 1);
    counts_.resize(values_.size());
  }

  void add(const Rows& rows) {
    special_.assign(values_.size(), nan);
    std::size_t row = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto is_before = [&](std::size_t k) {
        return rows.at(k, 0) <= time(i) + rounding * step_;
      };
      while (row + 1 < rows.size() && is_before(row + 1)) ++row;
      // A failed run ends earlier.
      if (row + 1 == rows.size() && rows.at(row, 0) < time(i) - step_) break;
      const std::size_t before = values_[i].size();
      for (const double x : numbers_(rows, row)) {
        if (!std::isnan(x)) values_[i].push_back(x);
        special_[i] = std::fmax(special_[i], x);
      }
      if (values_[i].size() > before) ++counts_[i];
    }
  }
  Envelope envelope() {
    Envelope result{};
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i].empty()) continue;
      std::ranges::sort(values_[i]);
      result.times.push_back(time(i));
      result.counts.push_back(counts_[i]);
      auto& shares = result.shares.emplace_back();
      std::size_t k = 0;
      for (const double p : {0.0, 0.05, 0.5, 0.95, 1.0}) {
        shares[k++] = percentile(values_[i], p, 0.5).value;
      }
      shares[k] = special_[i];
    }
    return result;
  }

 private:
  static constexpr double rounding = 1e-6;
  double time(std::size_t i) const { return static_cast<double>(i) * step_; }

  double step_;
  Numbers numbers_;
  std::vector<std::vector<double>> values_;  // at each time
  std::vector<std::size_t> counts_;          // runs with a value
  std::vector<double> special_;              // the special run
};

// Draws that make no valid case together have no history.
bool has_case(const Study& study, std::uint64_t run) {
  try {
    study.case_of(run);
  } catch (const contact::Error&) {
    return false;
  }
  return true;
}

// The worst run, or the nominal one, comes last.
std::vector<std::uint64_t> runs_of(const Study& study,
                                   const Findings& findings) {
  constexpr std::uint64_t first = 100;
  std::set<std::uint64_t> runs;
  for (std::uint64_t i = 1; i <= std::min(first, study.runs()); ++i) {
    runs.insert(i);
  }
  for (const Judgement& judgement : findings.requirements) {
    for (const RunValue& worst : judgement.worst) runs.insert(worst.run);
  }
  std::uint64_t last = 0;
  if (!findings.requirements.empty()) {
    last = findings.requirements[0].worst[0].run;
  }
  std::erase_if(runs, [&](std::uint64_t run) { return !has_case(study, run); });
  if (!has_case(study, last)) last = 0;
  runs.erase(last);
  std::vector<std::uint64_t> result(runs.begin(), runs.end());
  result.push_back(last);
  return result;
}

}  // namespace

bool Envelope::is_wide() const {
  constexpr double wide = 50;
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const auto& at_time : shares) {
    low = std::min(low, at_time.front());
    high = std::max(high, at_time[4]);
  }
  return low > 0 && high > wide * low;
}

std::vector<Envelope> envelopes(const Study& study, const Findings& findings) {
  const separation::Case nominal = study.case_of(0);
  struct Kind {
    const char* name;
    const char* label;
    const char* quantity;
    Samples samples;
  };
  std::vector<Kind> kinds;
  if (!nominal.clearance.empty()) {
    kinds.push_back({envelope_names[0], "smallest clearance, m",
                     "clearance.smallest_m",
                     Samples(nominal, smallest_clearance)});
  }
  if (nominal.has_hinges()) {
    kinds.push_back({envelope_names[1], "angles of the hinges, deg", "",
                     Samples(nominal, angles)});
  }
  const auto runs = runs_of(study, findings);
  for (const std::uint64_t run : runs) {
    const separation::Outcome outcome =
        separation::run_case(study.case_of(run));
    for (Kind& kind : kinds) kind.samples.add(outcome.memory.rows);
  }
  std::vector<Envelope> result;
  for (Kind& kind : kinds) {
    result.push_back(kind.samples.envelope());
    result.back().name = kind.name;
    result.back().label = kind.label;
    result.back().quantity = kind.quantity;
    result.back().runs = runs.size();
    result.back().special =
        runs.back() == 0 ? "nominal" : fmt::format("run {}", runs.back());
  }
  return result;
}

}  // namespace study
