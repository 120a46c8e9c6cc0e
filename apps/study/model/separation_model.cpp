#include "study/model/separation_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/identity.hpp"
#include "separation/results/notes.hpp"
#include "separation/results/quantities.hpp"
#include "separation/results/summary.hpp"

namespace study {
namespace {

using separation::Case;
using separation::column_name;

// The WHICH in "body[WHICH]." of a key; "" for another key.
std::string which_of(const std::string& key, const std::string& table) {
  if (!key.starts_with(table + '[')) return {};
  const auto from = table.size() + 1;
  return key.substr(from, key.find(']') - from);
}

// Labels of the items with the name or the number `which`.
template <class Items, class Name, class Label>
std::vector<std::string> labels_of(const Items& items, const std::string& which,
                                   const Name& name, const Label& label) {
  std::string wanted = which;
  std::size_t number = 0;
  const char* end = which.data() + which.size();
  if (std::from_chars(which.data(), end, number).ptr == end) {
    std::vector<std::string> names;
    for (const auto& item : items) {
      if (std::ranges::find(names, name(item)) == names.end()) {
        names.push_back(name(item));
      }
    }
    if (number >= 1 && number <= names.size()) wanted = names[number - 1];
  }
  std::vector<std::string> labels;
  for (const auto& item : items) {
    if (name(item) == wanted) labels.push_back(label(item));
  }
  return labels;
}

using Numbers = std::map<std::string, double>;

// PREFIX.NAME; for vectors PREFIX.NAME[1] to [3].
template <class T>
void add(std::span<const contact::Quantity<T>> quantities, const T& of,
         const std::string& prefix, Numbers& to) {
  for (const auto& q : quantities) {
    if (q.exists && !q.exists(of)) continue;
    const std::string name = prefix + '.' + separation::summary_name(q);
    separation::for_numbers(q, of, [&](double number, int k) {
      to.emplace(k == 0 ? name : fmt::format("{}[{}]", name, k), number);
    });
  }
}

void add_body(const Case& c, const separation::Outcome& outcome, bool margins,
              int number, Numbers& to) {
  const separation::Body& body = c.bodies[number];
  const separation::BodyRecord& record = outcome.memory.bodies[number];
  if (body.hinge.kind == multibody::HingeKind::none) return;
  const std::string name = column_name(body.rigid.name);
  add(separation::hinge_quantities(), record, name, to);
  if (body.lock) add(separation::lock_quantities(), record, name, to);
  if (!body.hinge.stops.empty()) {
    add(separation::stop_quantities(), record, name, to);
  }
  if (c.has_latch(number)) {
    add(separation::latch_quantities(), record, name, to);
  }
  add(separation::body_quantities(), record, name, to);
  if (body.hinge.margin && margins) {
    add(separation::margin_quantities(),
        outcome.margins->of(c, number, outcome.friction), name, to);
  }
  if (record.release.time != separation::History::not_yet) {
    add(separation::release_quantities(), record.release, name + ".at_release",
        to);
  }
  for (std::size_t i = 0; i < record.joints.size(); ++i) {
    add(separation::joint_quantities(), record.joints[i],
        fmt::format("{}.joint[{}]", name, i + 1), to);
  }
}

std::string event_time(const std::string& event, const std::string& body) {
  return fmt::format("event.{}.{}.time_s", column_name(event),
                     column_name(body));
}

void add_events(const Case& c, const separation::Outcome& outcome,
                std::map<std::string, double>& to) {
  for (std::size_t e = 0; e < c.events.size(); ++e) {
    for (const int body : c.events[e].bodies) {
      const double time = outcome.history.events[e][body];
      if (time == separation::History::not_yet) continue;
      to.emplace(event_time(c.events[e].name, c.bodies[body].rigid.name), time);
    }
  }
}

void add_clearance(const Case& c, const separation::Outcome& outcome,
                   std::map<std::string, double>& to) {
  // The smallest of all clearances, and of those with a name.
  std::map<std::string, double> smallest;
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const separation::PairRecord& pair = outcome.memory.pairs[i];
    if (pair.smallest == separation::History::not_yet) continue;
    const std::string name = clearance_column(c, c.clearance[i]) + ".";
    to.emplace(name + "smallest_m", pair.smallest);
    to.emplace(name + "time_s", pair.time);
    for (const std::string& of : {std::string(), c.clearance[i].name}) {
      const std::string all =
          of.empty() ? "clearance" : "clearance." + column_name(of);
      const auto found = smallest.emplace(all, pair.smallest).first;
      found->second = std::min(found->second, pair.smallest);
    }
  }
  for (const auto& [all, distance] : smallest) {
    to.emplace(all + ".smallest_m", distance);
  }
}

// NAME.at[EVENT] or NAME.at_end.
std::string tip_off_name(const Case& c, const separation::TipOff& of) {
  const std::string name = column_name(c.rigid_body(of.body).name);
  return of.event < 0 ? name + ".at_end"
                      : fmt::format("{}.at[{}]", name,
                                    column_name(c.events[of.event].name));
}

std::vector<Unreached> unreached(const Case& c,
                                 const separation::Outcome& outcome) {
  std::vector<Unreached> result;
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    const std::string& name = c.bodies[b].rigid.name;
    if (c.bodies[b].hinge.kind == multibody::HingeKind::none ||
        outcome.memory.bodies[b].release.time != separation::History::not_yet) {
      continue;
    }
    result.push_back({column_name(name) + ".at_release.",
                      fmt::format("{} is not released", name)});
  }
  for (std::size_t i = 0; i < c.clearance.size(); ++i) {
    const separation::WatchedPair& pair = c.clearance[i];
    if (pair.is_plain() ||
        outcome.memory.pairs[i].smallest != separation::History::not_yet) {
      continue;
    }
    const std::string reason = "the times at which it is watched do not come";
    result.push_back({clearance_column(c, pair) + ".", reason});
    if (!pair.name.empty()) {  // also among all its pairs
      result.push_back({"clearance." + column_name(pair.name) + ".", reason});
    }
  }
  for (std::size_t i = 0; i < c.tip_offs.size(); ++i) {
    if (outcome.memory.tip_offs[i].time != separation::History::not_yet) {
      continue;
    }
    result.push_back({tip_off_name(c, c.tip_offs[i]) + ".",
                      fmt::format("event \"{}\" does not occur",
                                  c.events[c.tip_offs[i].event].name)});
  }
  for (const auto& [event, bodies] : separation::missed_events(c, outcome)) {
    for (const std::string& body : bodies) {
      result.push_back(
          {event_time(event, body),
           fmt::format("event \"{}\" does not occur for {}", event, body)});
    }
  }
  return result;
}

std::vector<std::string> warnings_of(const Case& c,
                                     const separation::Outcome& outcome) {
  std::vector<std::string> texts = separation::joint_notes(c);
  for (std::string& note : run_notes(c, outcome)) {
    texts.push_back(std::move(note));
  }
  return texts;
}

}  // namespace

Numbers numbers_of(const Case& c, const separation::Outcome& outcome,
                   bool margins) {
  const auto& memory = outcome.memory;
  Numbers numbers;
  numbers.emplace("end_time_s", outcome.end_time);
  numbers.emplace("energy.largest_J", memory.largest_energy);
  if (!c.options.carrier_drive) {
    numbers.emplace("energy.largest_drift_J", memory.largest_drift);
    if (memory.largest_energy > 0) {
      numbers.emplace("energy.drift",
                      memory.largest_drift / memory.largest_energy);
    }
  }
  if (const auto share = separation::pressure_over_limit(c, memory)) {
    numbers.emplace(over_limit, *share);
  }
  for (std::size_t i = 0; i < c.bodies.size(); ++i) {
    add_body(c, outcome, margins, static_cast<int>(i), numbers);
  }
  add_events(c, outcome, numbers);
  add_clearance(c, outcome, numbers);
  for (std::size_t i = 0; i < c.tip_offs.size(); ++i) {
    if (memory.tip_offs[i].time == separation::History::not_yet) continue;
    add(separation::tip_off_quantities(), memory.tip_offs[i],
        tip_off_name(c, c.tip_offs[i]), numbers);
  }
  return numbers;
}

SeparationModel::SeparationModel(const Plan& plan)
    : plan_(plan),
      nominal_(
          separation::case_of_file(contact::TomlTable::from_file(
                                       plan.case_file, separation::case_keys()),
                                   {}, laws_)) {
  for (const Dispersion& dispersion : plan.dispersions) {
    if (!dispersion.each || copies(dispersion).size() > 1) continue;
    dispersion.table.needs(
        "each",
        "a key of a body or force with a pattern, or of a "
        "force on such a body: body[NAME].KEY or force[NAME].KEY");
  }
}

std::vector<std::string> SeparationModel::copies(
    const Dispersion& dispersion) const {
  if (!dispersion.each) return {};
  const std::string body = which_of(dispersion.key, "body");
  if (!body.empty()) {
    return labels_of(
        nominal_.bodies, body,
        [](const separation::Body& b) { return b.group; },
        [](const separation::Body& b) { return b.rigid.name; });
  }
  return labels_of(
      nominal_.forces, which_of(dispersion.key, "force"),
      [](const separation::Force& f) { return f.group; },
      [&](const separation::Force& f) {
        const std::string& on = nominal_.rigid_body(f.body).name;
        return f.name == f.group
                   ? on
                   : on + ", " + f.name.substr(f.group.size() + 1);
      });
}

Case SeparationModel::case_of(const contact::KeySettings& settings) const {
  contact::SharedLaws laws = laws_;
  return separation::case_of_file(
      files_.open(plan_.case_file, separation::case_keys, settings), {}, laws);
}

separation::CaseForm SeparationModel::form() const {
  contact::KeySettings keys;
  for (const Dispersion& d : plan_.dispersions) keys.push_back(d.setting(1));
  return {files_, plan_.case_file, keys, nominal_, laws_};
}

// Draws that make no valid case, or change the number of bodies, are read as
// settings, so that messages name them.
Case SeparationModel::case_of(const std::vector<double>& draws) const {
  std::vector<std::span<const double>> numbers;
  std::size_t readings = 1;
  std::span<const double> rest = draws;
  for (const Dispersion& dispersion : plan_.dispersions) {
    const std::size_t count = copies(dispersion).size();
    numbers.push_back(rest.first(std::max<std::size_t>(count, 1)));
    rest = rest.subspan(numbers.back().size());
    readings = std::max(readings, count);
  }
  try {
    return forms_.with_one(
        [this] { return form(); },
        [&](separation::CaseForm& form) { return form.with(numbers); });
  } catch (const contact::Error&) {
    for (std::size_t copy = 0; copy < readings; ++copy) {
      contact::KeySettings settings;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto& values = numbers[i];
        if (values.size() > 1 && copy >= values.size()) continue;
        settings.push_back(
            plan_.dispersions[i].setting(values[values.size() > 1 ? copy : 0]));
      }
      Case c = case_of(settings);
      if (readings == 1) return c;
    }
    throw;
  }
}

Result SeparationModel::run(Case c, const Effort& effort,
                            const std::function<std::string()>& stop) const {
  // The numbers do not depend on the times of a history's rows.
  c.output_step = c.end_time;
  separation::RunOptions options;
  options.rows = false;
  options.clearance = effort.clearance;
  options.only_events = !effort.peaks && !effort.clearance;
  if (stop) options.stop = [&stop](long) { return stop(); };
  const separation::Outcome outcome = separation::run_case(c, options);
  Result result{outcome.failure, numbers_of(c, outcome, effort.margins)};
  if (effort.remarks) {
    result.unreached = unreached(c, outcome);
    result.warnings = warnings_of(c, outcome);
  }
  return result;
}

std::string SeparationModel::identity() const {
  return separation::identity(nominal_) +
         files_.open(plan_.case_file, separation::case_keys).canonical_text();
}

}  // namespace study
