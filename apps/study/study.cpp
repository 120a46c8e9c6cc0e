#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/repeated_setting.hpp"
#include "study/model/joint_model.hpp"
#include "study/model/separation_model.hpp"

namespace study {
namespace {

using contact::Error;

using contact::detail::nan;

// `*` stands for any characters.
bool matches(std::string_view pattern, std::string_view text) {
  const auto star = pattern.find('*');
  if (star == pattern.npos) return pattern == text;
  if (!text.starts_with(pattern.substr(0, star))) return false;
  pattern.remove_prefix(star + 1);
  for (std::size_t i = star; i <= text.size(); ++i) {
    if (matches(pattern, text.substr(i))) return true;
  }
  return false;
}

std::unique_ptr<Model> make_model(const Plan& plan) {
  const bool is_case = plan.joint_file.empty();
  try {
    contact::detail::file_text(is_case ? plan.case_file : plan.joint_file);
  } catch (const Error& error) {
    plan.file.fail(is_case ? "case" : "joint", error.what());
  }
  if (is_case) return std::make_unique<SeparationModel>(plan);
  return std::make_unique<JointModel>(plan);
}

// Avoids the ends of a distribution, which rounding would exceed.
double rounded(double x) { return std::stod(fmt::format("{:.12g}", x)); }

// True for numbers that are found only during the motion.
bool is_peak(const std::string& quantity) {
  return quantity.find(".peak_") != quantity.npos ||
         quantity.find(".largest_") != quantity.npos || quantity == over_limit;
}
bool is_clearance(const std::string& quantity) {
  return quantity.starts_with("clearance.");
}
bool is_margin(const std::string& quantity) {
  return quantity.find(".torque_margin") != quantity.npos;
}
// Energies with a driven carrier include its work.
bool is_energy(const std::string& quantity) {
  return quantity.starts_with("energy.");
}

// "velocity_m_per_s" for BODY.at_release.velocity_m_per_s[2].
std::string_view kind_of(std::string_view quantity) {
  quantity.remove_prefix(quantity.rfind('.') + 1);
  return quantity.substr(0, quantity.find('['));
}

// Why the nominal run lacks numbers that a name with or without `*` may mean.
std::vector<std::string> reasons(const std::vector<Unreached>& unreached,
                                 std::string_view pattern) {
  std::vector<std::string> result;
  for (const auto& [name, why] : unreached) {
    std::string whole = name;
    if (name.ends_with('.')) {
      // BODY.at_release. and the rest of the pattern.
      const std::string_view part =
          std::string_view(name).substr(name.rfind('.', name.size() - 2));
      const auto at = pattern.rfind(part);
      if (at == pattern.npos) continue;
      whole += pattern.substr(at + part.size());
    }
    if (matches(pattern, whole)) result.push_back(why);
  }
  return result;
}

// Parts of a name between its dots, sorted alphabetically; for vectors without
// the component's index.
std::vector<std::string> parts_of(std::string_view name) {
  std::vector<std::string> parts(1);
  for (const char c : name.substr(0, name.find_last_of('['))) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  std::ranges::sort(parts);
  return parts;
}

// The name that was probably meant: with typing errors, the same parts in
// another order, or one part more.
std::string nearest_quantity(std::string_view word,
                             const std::vector<std::string>& all) {
  std::string near = contact::detail::nearest(word, all);
  const auto parts = parts_of(word);
  for (std::size_t more : {0, 1}) {
    for (const std::string& name : all) {
      const auto others = parts_of(name);
      if (near.empty() && others.size() == parts.size() + more &&
          std::ranges::includes(others, parts)) {
        near = name;
      }
    }
  }
  return near;
}

}  // namespace

Study::Study(const std::filesystem::path& file, const PlanChanges& changes)
    : plan_(read_plan(file, changes)), model_(make_model(plan_)) {
  std::vector<std::vector<std::string>> copies;
  for (const Dispersion& dispersion : plan_.dispersions) {
    copies.push_back(model_->copies(dispersion));
  }
  design_ = std::make_unique<Design>(plan_, copies);
  check_draws();
  refuse_repeated_keys();
  nominal_ = model_->run(contact::KeySettings{}, {.remarks = true}, {});
  if (!nominal_.failure.empty()) {
    throw Error("the nominal run failed: " + nominal_.failure);
  }
  find_quantities();
  constexpr std::uint64_t looked_at = 200;
  std::vector<std::vector<double>> first;
  for (std::uint64_t run = 1; run <= std::min(runs(), looked_at); ++run) {
    first.push_back(design_->numbers(run));
  }
  model_->prepare(first, runs());
}

// Checks that the files allow all that the distributions allow.
void Study::check_draws() const {
  for (const Dispersion& dispersion : plan_.dispersions) {
    for (const double u : {lowest_uniform, 0.5, highest_uniform}) {
      try {
        model_->check({dispersion.setting(rounded(dispersion.quantile(u)))});
      } catch (const Error& error) {
        dispersion.table.fail("key", error.what());
      }
    }
  }
}

// Setting both detects a key under two names.
void Study::refuse_repeated_keys() const {
  const auto is_repeated = [this](const contact::KeySettings& settings) {
    try {
      model_->check(settings);
    } catch (const contact::RepeatedSetting&) {
      return true;
    } catch (const Error&) {
      // Draws that make no valid case together count as the failure of a run.
    }
    return false;
  };
  const std::size_t count = plan_.dispersions.size();
  contact::KeySettings all;
  for (const Dispersion& dispersion : plan_.dispersions) {
    all.push_back(dispersion.setting(rounded(dispersion.quantile(0.5))));
  }
  if (!is_repeated(all)) return;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      if (!is_repeated({all[other], all[i]})) continue;
      plan_.dispersions[i].table.must_be(
          "key",
          fmt::format("another key than \"{}\": both names are of one key",
                      plan_.dispersions[other].key));
    }
  }
}

std::vector<std::string> Study::matching(const std::string& pattern,
                                         const contact::TomlTable& table,
                                         const char* key) {
  std::vector<std::string> found;
  std::vector<std::string> all;
  std::string infinite;
  for (const auto& [name, value] : nominal_.numbers) {
    all.push_back(name);
    if (!matches(pattern, name)) continue;
    if (std::isinf(value)) {
      infinite = name;
      continue;
    }
    found.push_back(name);
    if (std::isnan(value) && name == pattern) {
      nominal_.warnings.push_back(fmt::format(
          "\"{}\" has no number: runs without it miss their requirement",
          name));
    }
  }
  const auto unreached = reasons(nominal_.unreached, pattern);
  if (found.empty() && !unreached.empty()) {
    table.fail(key, unreached[0] + " in the nominal run");
  }
  for (const std::string& why : unreached) {
    nominal_.warnings.push_back(fmt::format(
        "\"{}\" has no number in the nominal run: {}", pattern, why));
  }
  if (!found.empty()) return found;
  // As the distance to a rim that does not exist.
  if (!infinite.empty()) {
    table.fail(key, infinite + " is infinite in the nominal run");
  }
  // A list of all would fill a page.
  table.fail(key, contact::detail::unknown("quantity",
                                           contact::detail::printable(pattern),
                                           nearest_quantity(pattern, all), {}) +
                      "; --quantities lists those of the nominal run");
}

void Study::find_quantities() {
  const auto place = [this](const std::string& name) {
    const auto found = std::ranges::find(quantities_, name);
    const auto at = static_cast<std::size_t>(found - quantities_.begin());
    if (found == quantities_.end()) quantities_.push_back(name);
    return at;
  };
  for (const Requirement& requirement : plan_.requirements) {
    std::vector<std::size_t>& places = required_.emplace_back();
    const auto names =
        matching(requirement.quantity, requirement.table, "quantity");
    for (const std::string& name : names) {
      if (requirement.quantity.ends_with('*') &&
          kind_of(name) != kind_of(names[0])) {
        requirement.table.must_be(
            "quantity", fmt::format("a name of one kind of number, not of {} "
                                    "and {}",
                                    names[0], name));
      }
      places.push_back(place(name));
    }
  }
  for_requirements_ = quantities_.size();
  for (const std::string& pattern : plan_.quantities) {
    for (const auto& name : matching(pattern, plan_.file, "quantities")) {
      place(name);
    }
  }
  effort_.peaks = std::ranges::any_of(quantities_, is_peak);
  effort_.clearance = std::ranges::any_of(quantities_, is_clearance);
  effort_.margins = std::ranges::any_of(quantities_, is_margin);
  for (const char* name : {energy_drift, over_limit}) {
    if (nominal_.numbers.contains(name)) place(name);
  }
}

std::vector<std::string> Study::columns() const {
  std::vector<std::string> names;
  for (const Draw& draw : design_->draws()) names.push_back(draw.name);
  names.insert(names.end(), quantities_.begin(), quantities_.end());
  return names;
}

double Study::value_of(std::size_t requirement, const Row& row) const {
  const bool at_least = plan_.requirements[requirement].at_least;
  double worst = nan;
  for (const std::size_t place : required_[requirement]) {
    const double value = row.numbers[inputs() + place];
    if (std::isnan(value)) return nan;
    worst = at_least ? std::fmin(worst, value) : std::fmax(worst, value);
  }
  return worst;
}

Row Study::row(std::uint64_t run,
               const std::function<std::string()>& stop) const {
  Row row{run, {}, {}};
  if (run == 0) {
    for (const Draw& draw : design_->draws()) {
      const bool relative = plan_.dispersions[draw.dispersion].relative;
      row.numbers.push_back(relative ? 1 : nan);
    }
  } else {
    row.numbers = design_->numbers(run);
  }
  Result result;
  try {
    result = run == 0 ? model_->run(contact::KeySettings{}, effort_, stop)
                      : model_->run(row.numbers, effort_, stop);
  } catch (const Error& error) {
    result.failure = error.what();
  }
  row.failure = result.failure;
  for (const std::string& quantity : quantities_) {
    const auto found = result.numbers.find(quantity);
    const bool has = row.failure.empty() && found != result.numbers.end() &&
                     !std::isinf(found->second);
    row.numbers.push_back(has ? found->second : nan);
  }
  return row;
}

separation::Case Study::case_of(std::uint64_t run) const {
  const auto* model = dynamic_cast<const SeparationModel*>(model_.get());
  if (model == nullptr) {
    throw Error(contact::detail::needs("a history", "the study of a case"));
  }
  return run == 0 ? model->case_of(contact::KeySettings{})
                  : model->case_of(design_->numbers(run));
}

bool Study::has_effect(std::size_t dispersion, double u,
                       const std::vector<double>& notable) const {
  const Dispersion& of = plan_.dispersions[dispersion];
  Result result;
  try {
    result =
        model_->run(contact::KeySettings{of.setting(of.quantile(u))}, {}, {});
  } catch (const Error&) {  // a rejected value
    return true;
  }
  if (!result.failure.empty()) return true;
  for (std::size_t i = 0; i < quantities_.size(); ++i) {
    const std::string& name = quantities_[i];
    if (is_energy(name)) continue;
    const auto found = result.numbers.find(name);
    if (found == result.numbers.end()) return true;
    const double change = found->second - nominal_.numbers.at(name);
    if (!(std::abs(change) <= notable[i])) return true;
  }
  return false;
}

std::vector<std::string> Study::idle_keys(
    const std::vector<double>& notable) const {
  std::vector<std::string> idle;
  // Without quantities other than energies every key would be idle.
  if (std::ranges::all_of(quantities_, is_energy)) return idle;
  // At least one of them differs from the nominal value.
  constexpr double probes[] = {0.8413, 0.25};
  for (std::size_t i = 0; i < plan_.dispersions.size(); ++i) {
    const bool acts = std::ranges::any_of(
        probes, [&](double u) { return has_effect(i, u, notable); });
    if (!acts) idle.push_back(plan_.dispersions[i].key);
  }
  return idle;
}

std::string Study::identity() const {
  std::string text = model_->identity();
  for (const Dispersion& dispersion : plan_.dispersions) {
    text += dispersion.content;
  }
  for (const std::string& name : columns()) text += name + '\n';
  return text + design_->identity();
}

}  // namespace study
