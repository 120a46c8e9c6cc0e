#include "study/model/joint_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "cli/progress.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/toml_form.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"
#include "study/model/joint_load.hpp"

namespace study {

using contact::KeySettings;
using contact::TomlTable;

struct JointModel::Loaded {
  contact::JointSpec spec;  ///< under the load
  contact::Joint joint;
  Load load;
};

/// The files with the drawn keys.
struct JointModel::Form {
  contact::TomlForm joint, study;
};

/// Contacts at the rims of a seat, estimated from the first draws.
struct JointModel::Rims {
  double share = 0;           ///< share of the runs that reach a rim
  std::vector<double> draws;  ///< draws of a run that reaches one
  double least_load = std::numeric_limits<double>::infinity();  ///< N
  double most_load = 0;                                         ///< N
  bool are_tabulated = false;  ///< read from a table
  std::once_flag once = {};
  std::optional<contact::Joint> table = {};
};

namespace {

bool is_of_load(const std::string& key) { return key.starts_with("load."); }

/// True if the contact would extend beyond a rim.
bool reaches_rim(const contact::Joint& endless, const Load& load) {
  for (const double angle : {-load.swing, 0.0, load.swing}) {
    const contact::JointSolution s =
        endless.solve({load.swung(angle), load.angular_velocity()});
    if (contact::rim_overlap(endless.contact(), s) > 0) return true;
  }
  return false;
}

/// Adds numbers by name.
template <class T>
void add(const std::vector<contact::Column<T>>& columns, const T& of,
         Result& to) {
  for (const auto& column : columns) {
    to.numbers.emplace(column.name, column(of));
  }
}

/// Adds the numbers of rims and of finite-length pins.
void add_ends(const contact::Joint& joint, const contact::JointSolution& s,
              Result& to) {
  static const auto of_rims = columns_of(contact::rim_quantities());
  static const auto of_pin = columns_of(contact::lie_quantities());
  if (const auto rims = joint.rims(s)) {
    add(of_rims, *rims, to);
    to.numbers.emplace("p_nominal_Pa", s.reaction.norm() / rims->nominal_area);
  }
  if (const auto lie = joint.lie(s)) add(of_pin, *lie, to);
}

/// Adds sums and largest values over the cycle of a load that swings.
void add_swing(const contact::Joint& joint, const Load& load, Result& to) {
  const contact::JointCycle cycle(swinging(load, joint.contact().geometry()),
                                  joint);
  for (const auto& row : cycle.rows()) {
    if (row.solution.status == contact::Status::ok) continue;
    to.failure = joint.notes(row.solution).front();
    return;
  }
  static const auto sums = columns_of(contact::cycle_quantities());
  static const auto largest = columns_of(contact::worst_quantities());
  add(sums, cycle, to);
  add(largest, cycle, to);
  to.warnings = cycle.notes();
  to.numbers[over_limit] = cycle.largest_peak().solution.peak_pressure /
                           joint.contact().limits().peak_pressure();
}

}  // namespace

JointModel::JointModel(const Plan& plan)
    : plan_(plan), columns_(columns_of(contact::solution_quantities())) {
  const contact::JointSpec nominal = contact::read_joint(plan.joint_file);
  patch_columns_ = columns_of(nominal.geometry.radial_clearance() > 0
                                  ? contact::presliding_quantities()
                                  : contact::preload_quantities());
  const TomlTable table = plan.file.table("load");
  const Load load = read_load(table, nominal.geometry);
  try {
    joint_.emplace(load.without_seat ? nominal.without_seat() : nominal, laws_);
  } catch (const contact::Error& error) {
    plan.file.fail("joint", error.what());
  }
  // A joint whose clearance scatters about 0 may be unloaded in some runs.
  if (load.reaction.isZero(0) && !joint_->contact().has_interference()) {
    table.must_be("reaction",
                  "above 0, as a joint without interference has no friction "
                  "without load");
  }
  const auto is_fixed = [](const Dispersion& d) { return is_of_load(d.key); };
  if (!std::ranges::all_of(plan.dispersions, is_fixed)) joint_.reset();
}

JointModel::~JointModel() = default;

std::vector<std::string> JointModel::copies(
    const Dispersion& dispersion) const {
  if (dispersion.each) {
    dispersion.table.needs("each", "a case with bodies that have a pattern");
  }
  return {};
}

JointModel::Loaded JointModel::loaded(const TomlTable& joint,
                                      const TomlTable& study) const {
  const contact::JointSpec given = contact::joint_of_file(joint);
  const Load load = read_load(study.table("load"), given.geometry);
  const contact::JointSpec spec =
      load.without_seat ? given.without_seat() : given;
  if (joint_) return {spec, *joint_, load};
  contact::SharedLaws laws = laws_;
  return {spec, contact::Joint(spec, laws), load};
}

JointModel::Loaded JointModel::read(const KeySettings& settings) const {
  KeySettings of_joint;
  KeySettings of_study;
  for (const contact::KeySetting& setting : settings) {
    (is_of_load(setting.key) ? of_study : of_joint).push_back(setting);
  }
  return loaded(files_.open(plan_.joint_file, contact::joint_keys, of_joint),
                files_.open(plan_.path, study_keys, of_study));
}

// Draws that make no valid joint are read as settings, so that messages name
// them.
JointModel::Loaded JointModel::read(const std::vector<double>& draws) const {
  KeySettings of_joint;
  KeySettings of_study;
  for (const Dispersion& d : plan_.dispersions) {
    (is_of_load(d.key) ? of_study : of_joint).push_back(d.setting(1));
  }
  const auto form = [&] {
    return Form{{files_, plan_.joint_file, contact::joint_keys, of_joint},
                {files_, plan_.path, study_keys, of_study}};
  };
  try {
    return forms_.with_one(form, [&](Form& one) {
      std::size_t joint = 0;
      std::size_t study = 0;
      for (std::size_t i = 0; i < draws.size(); ++i) {
        if (is_of_load(plan_.dispersions[i].key)) {
          one.study.set(study++, draws[i]);
        } else {
          one.joint.set(joint++, draws[i]);
        }
      }
      return loaded(one.joint.table(), one.study.table());
    });
  } catch (const contact::Error&) {
    KeySettings settings;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      settings.push_back(plan_.dispersions[i].setting(draws[i]));
    }
    return read(settings);
  }
}

void JointModel::check(const KeySettings& settings) const { read(settings); }

Result JointModel::run(const KeySettings& settings, const Effort& effort,
                       const std::function<std::string()>& /*stop*/) const {
  return run(read(settings), effort);
}

Result JointModel::run(const std::vector<double>& draws, const Effort& effort,
                       const std::function<std::string()>& /*stop*/) const {
  Loaded loaded = read(draws);
  if (rims_ && rims_->are_tabulated) loaded.joint = tabulated();
  return run(loaded, effort);
}

Result JointModel::run(const Loaded& loaded, const Effort& effort) const {
  const auto& [spec, joint, load] = loaded;
  const contact::JointSolution s = joint.solve(load.slip());
  if (s.status != contact::Status::ok) return {joint.notes(s).front(), {}};
  Result result;
  for (const auto& column : columns_) {
    result.numbers.emplace(column.name, column(s));
  }
  const contact::JointContact& contact = joint.contact();
  const contact::ContactPatch patch{contact, s.normal_force, s.half_angle};
  for (const auto& column : patch_columns_) {
    const double value = column(patch);
    if (!std::isnan(value)) result.numbers.emplace(column.name, value);
  }
  add_ends(joint, s, result);
  result.numbers[over_limit] =
      s.peak_pressure / contact.limits().peak_pressure();
  if (load.swing > 0) add_swing(joint, load, result);
  if (!effort.remarks) return result;
  contact::ContactNotes notes;
  notes.add(joint, s, load.direction);
  for (auto& more : {contact.validity_notes(), notes.notes(joint)}) {
    std::ranges::copy(more, std::back_inserter(result.warnings));
  }
  return result;
}

void JointModel::prepare(const std::vector<std::vector<double>>& first,
                         std::uint64_t runs) {
  // Few runs, if each joint may need laws of its own, which take time.
  const std::size_t count =
      std::min<std::size_t>(joint_ ? first.size() : 20, first.size());
  contact::SharedLaws laws = laws_;
  auto rims = std::make_unique<Rims>();
  for (std::size_t i = 0; i < count; ++i) {
    try {
      const Loaded loaded = read(first[i]);
      if (!loaded.spec.geometry.seat()) return;
      const contact::Joint endless(loaded.spec.without_seat(), laws);
      if (!reaches_rim(endless, loaded.load)) continue;
      const double load = loaded.load.reaction.norm();
      rims->least_load = std::min(rims->least_load, load);
      rims->most_load = std::max(rims->most_load, load);
      rims->draws = first[i];
      rims->share += 1 / static_cast<double>(count);
    } catch (const contact::Error&) {
      // This run will fail.
    }
  }
  if (rims->share == 0) return;
  // This many contacts take as long as the table.
  constexpr double many = 500;
  rims->are_tabulated =
      joint_ && rims->share * static_cast<double>(runs) >= many;
  rims_ = std::move(rims);
}

// The joint, with a table, if only the load scatters; built on first use.
const contact::Joint& JointModel::tabulated() const {
  std::call_once(rims_->once, [this] {
    cli::ShareDone done("a table of contacts");
    const double most = rims_->most_load;
    rims_->table = joint_->tabulated(
        {.least_load = std::max(0.9 * rims_->least_load, 0.01 * most),
         .most_load = 1.1 * most,
         .progress = [&](double share) { done.come_to(share); }});
  });
  return *rims_->table;
}

std::string JointModel::forecast(std::uint64_t runs, int jobs) const {
  if (!rims_) return {};
  if (rims_->are_tabulated) {
    const auto check = *tabulated().table_check();
    return fmt::format(
        "contacts at the rims of the seat are read from a table: loads are "
        "right to {:.1g} %, peak pressures to {:.1g} %",
        100 * check.error(), 100 * check.peak);
  }
  double each = 0;
  double seconds = 0;
  constexpr double long_time = 2;
  // The first run builds the laws that the others share.
  for (int i = 0; i < 2; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    run(read(rims_->draws), {});
    const std::chrono::duration<double> time =
        std::chrono::steady_clock::now() - begin;
    each = time.count();
    seconds = each * rims_->share * static_cast<double>(runs) / jobs;
    if (seconds < long_time) return {};
  }
  return fmt::format(
      "{:.0f} % of the runs reach a rim of the seat and take some {:.2g} s "
      "each: {} runs take some {}",
      100 * rims_->share, each, runs,
      seconds < 120 ? fmt::format("{:.0f} s", seconds)
                    : fmt::format("{:.0f} min", seconds / 60));
}

std::string JointModel::identity() const {
  std::string text =
      contact::read_joint(plan_.joint_file).canonical_text() +
      files_.open(plan_.path, study_keys).table("load").canonical_text();
  if (rims_ && rims_->are_tabulated) {
    text +=
        fmt::format("table of {} to {} N", rims_->least_load, rims_->most_load);
  }
  return text;
}

}  // namespace study
