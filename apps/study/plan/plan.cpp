#include "study/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"

namespace study {
namespace {

using contact::integer_key;
using contact::Interval;
using contact::number_key;
using contact::table_key;
using contact::TomlTable;
using contact::word_key;

}  // namespace

contact::KnownKeys study_keys() {
  using std::numbers::pi;
  // A pin bends or jams long before these slopes.
  constexpr Interval slope{-10 * contact::degree, 10 * contact::degree};
  contact::KnownKeys dispersion = distribution_keys();
  for (const char* key : {"key", "relative", "each", "factors"}) {
    dispersion.push_back({key});
  }
  dispersion.push_back(number_key("loadings", {-1, 1}));
  constexpr Interval share{0, 1, true, true};
  return {
      {"name"},
      {"case"},
      {"joint"},
      table_key("load",
                {number_key("reaction", contact::Dimension::force,
                            Interval::non_negative()),
                 {"reaction_xyz", contact::Dimension::force},
                 number_key("beta", contact::Dimension::angle, {0, pi}),
                 number_key("rate", contact::Dimension::angular_velocity,
                            Interval::positive()),
                 {"in_seat"},
                 {"without_seat"},
                 number_key("swing", contact::Dimension::angle, {0, pi / 2}),
                 number_key("tilt", contact::Dimension::angle, slope),
                 number_key("twist", contact::Dimension::angle, slope),
                 {"load_at", contact::Dimension::length},
                 {"slide", contact::Dimension::velocity}}),
      integer_key("runs", 1, most_runs),
      integer_key("seed", 0, std::numeric_limits<std::int64_t>::max()),
      word_key("sampling", {sampling_names.begin(), sampling_names.end()}),
      {"quantities"},
      table_key("factor", {{"name"}}),
      table_key("dispersion", dispersion),
      table_key("requirement", {{"quantity"},
                                {"at_least"},
                                {"at_most"},
                                number_key("success", share),
                                number_key("risk", share)})};
}

namespace {

std::vector<std::string> read_factors(const TomlTable& file) {
  std::vector<std::string> names;
  for (const TomlTable& table : file.tables("factor")) {
    std::string name = table.text("name");
    if (std::ranges::find(names, name) != names.end()) {
      table.must_be("name", "a name that no other factor has");
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<Share> read_shares(const TomlTable& table,
                               const std::vector<std::string>& factors) {
  const auto names = table.texts("factors");
  if (names.empty()) {
    if (table.has("loadings")) table.needs("loadings", "factors");
    return {};
  }
  const auto loadings = table.numbers("loadings", {names.size()});
  std::vector<Share> shares;
  double sum = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = std::ranges::find(factors, names[i]);
    if (found == factors.end()) {
      table.fail("factors",
                 contact::detail::unknown("factor", names[i], factors));
    }
    const auto factor = static_cast<std::size_t>(found - factors.begin());
    if (std::ranges::count(shares, factor, &Share::factor) > 0) {
      table.must_be("factors", "names that differ");
    }
    shares.push_back({factor, loadings[i]});
    sum += loadings[i] * loadings[i];
  }
  if (sum > 1) {
    table.must_be("loadings", "numbers whose squares add up to 1 at most");
  }
  return shares;
}

Dispersion read_dispersion(const TomlTable& table, const Plan& plan) {
  const std::string key = table.text("key");
  for (const Dispersion& other : plan.dispersions) {
    if (other.key == key) {
      table.must_be("key", "a key that no other dispersion has");
    }
  }
  return {.key = key,
          .relative = table.flag("relative"),
          .each = table.flag("each"),
          .quantile = read_distribution(table),
          .distribution = distribution_text(table),
          .shares = read_shares(table, plan.factors),
          .content = table.canonical_text(),
          .table = table};
}

Requirement read_requirement(const TomlTable& table) {
  table.refuse_both("at_least", "at_most");
  const bool at_least = table.has("at_least");
  if (!at_least && !table.has("at_most")) table.needs("at_least or at_most");
  return {
      .quantity = table.text("quantity"),
      .at_least = at_least,
      .limit = table.number(at_least ? "at_least" : "at_most"),
      .demand = {.success = table.number("success"),
                 .risk = table.optional_number("risk").value_or(Demand{}.risk)},
      .table = table};
}

// Number of runs in the file; else the number that the requirements need if no
// run fails.
std::uint64_t read_runs(const TomlTable& file, const Plan& plan) {
  if (file.has("runs")) {
    return static_cast<std::uint64_t>(file.integer("runs"));
  }
  if (plan.requirements.empty()) file.needs("runs or [[requirement]]");
  std::uint64_t runs = 0;
  for (const Requirement& requirement : plan.requirements) {
    runs = std::max<std::uint64_t>(runs, runs_needed(0, requirement.demand));
  }
  return runs;
}

}  // namespace

contact::KeySetting Dispersion::setting(double number) const {
  return {key, fmt::format("{}{}", relative ? "*" : "", number)};
}

namespace {

Plan plan_of(const TomlTable& file, const std::filesystem::path& path,
             const PlanChanges& changes) {
  Plan plan{.name = file.text("name"),
            .case_file = {},
            .joint_file = {},
            .runs = 0,
            .seed = 1,
            .sampling = Sampling::random,
            .factors = read_factors(file),
            .dispersions = {},
            .requirements = {},
            .quantities = file.texts("quantities"),
            .path = path,
            .file = file};
  file.refuse_both("case", "joint");
  if (const auto name = file.optional_text("case")) {
    plan.case_file = file.folder() / *name;
  } else {
    plan.joint_file = file.folder() / file.text("joint");
  }
  if (const auto name = file.optional_choice("sampling")) {
    plan.sampling = static_cast<Sampling>(*name);
  }
  if (file.has("seed")) {
    plan.seed = static_cast<std::uint64_t>(file.integer("seed"));
  }
  for (const TomlTable& table : file.tables("dispersion")) {
    plan.dispersions.push_back(read_dispersion(table, plan));
  }
  if (plan.dispersions.empty()) file.needs("one or more [[dispersion]]");
  for (const TomlTable& table : file.tables("requirement")) {
    plan.requirements.push_back(read_requirement(table));
  }
  plan.runs = changes.runs.value_or(read_runs(file, plan));
  plan.seed = changes.seed.value_or(plan.seed);
  return plan;
}

}  // namespace

Plan read_plan(const std::filesystem::path& path, const PlanChanges& changes) {
  return plan_of(TomlTable::from_file(path, study_keys()), path, changes);
}

Plan parse_plan(std::string_view text, const std::string& source) {
  return plan_of(TomlTable::from_text(text, source, study_keys()), source, {});
}

}  // namespace study
