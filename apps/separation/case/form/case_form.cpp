#include "separation/case/form/case_form.hpp"

#include <algorithm>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_names.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/event_reader.hpp"
#include "separation/case/force_reader.hpp"
#include "separation/case/form/case_parts.hpp"

namespace separation {

using contact::Error;
using contact::TomlTable;

CaseForm::CaseForm(const contact::TomlFiles& files,
                   const std::filesystem::path& file,
                   const contact::KeySettings& keys, const Case& nominal,
                   const contact::SharedLaws& made)
    : form_(files, file, case_keys, keys), nominal_(nominal), made_(made) {
  for (std::size_t key = 0; key < keys.size(); ++key) {
    const std::string& of = form_.place(key);
    if (!of.ends_with(".pattern.count")) continue;
    throw Error(
        contact::detail::needs(of, "no draws of other keys for each copy"));
  }
  const auto place = [](std::vector<Part>& parts, const auto& items,
                        const auto& name) {
    for (Part& part : parts) {
      const std::string wanted = part.table.text("name");
      const auto is_of = [&](const auto& item) { return name(item) == wanted; };
      const auto first = std::ranges::find_if(items, is_of);
      part.first = static_cast<int>(first - items.begin());
      part.count = static_cast<int>(std::ranges::count_if(items, is_of));
    }
  };
  const TomlTable& table = form_.table();
  place(bodies_ = parts(table, "body"), nominal.bodies,
        [](const Body& body) { return body.group; });
  place(forces_ = parts(table, "force"), nominal.forces,
        [](const Force& force) { return force.group; });
  place(events_ = parts(table, "event"), nominal.events,
        [](const Event& event) { return event.name; });
  for (const Event& event : nominal.events) event_names_.push_back(event.name);
  for (std::size_t key = 0; key < keys.size(); ++key) {
    keys_of(form_.place(key)).push_back(key);
  }
  // From here on parents come before their children.
  turns_.resize(nominal.bodies.size());
  std::ranges::stable_sort(bodies_, {}, [&](const Part& body) {
    return depth(nominal, 1 + body.first);
  });
  for (const Part& body : bodies_) {
    const Pattern pattern = read_pattern(body.table);
    for (int i = body.first; i < body.first + body.count; ++i) {
      const int on = nominal.bodies[i].hinge.on;
      turns_[i] = on > 0 ? turns_[on - 1] : pattern.turn(i - body.first);
    }
  }
}

int CaseForm::depth(const Case& of, int body) {
  return body == 0 ? 0 : 1 + depth(of, of.bodies[body - 1].hinge.on);
}

std::vector<CaseForm::Part> CaseForm::parts(const TomlTable& file,
                                            std::string_view key) {
  std::vector<Part> result;
  for (const TomlTable& table : file.tables(key)) {
    result.push_back({table, 0, 0});
  }
  return result;
}

// Keys of a body: the second one's for "body[2].com[1]".
CaseForm::Keys& CaseForm::keys_of(const std::string& place) {
  const std::string step = place.substr(0, place.find('.'));
  const auto bracket = std::min(step.find('['), step.size());
  const std::string table = step.substr(0, bracket);
  if (table == "run" || table == "gravity") return run_;
  if (table == "carrier") return carrier_;
  for (auto [name, parts] : {std::pair{"body", &bodies_},
                             {"force", &forces_},
                             {"event", &events_}}) {
    if (table != name) continue;
    return parts->at(std::stoul(step.substr(bracket + 1)) - 1).keys;
  }
  throw Error(contact::detail::must_be(
      place, "a key of the run, the carrier, a body, an event or a force"));
}

void CaseForm::set(const Keys& keys, const Numbers& numbers, int copy) {
  for (const std::size_t key : keys) {
    const auto& values = numbers[key];
    form_.set(key, values.size() == 1 ? values[0] : values[copy]);
  }
}

void CaseForm::read_bodies(const Part& part, const Numbers& numbers,
                           contact::SharedLaws& made, Case& c,
                           std::vector<Eigen::Matrix3d>& turns) {
  const bool is_each = std::ranges::any_of(
      part.keys, [&](std::size_t key) { return numbers[key].size() > 1; });
  Body body;
  Pattern pattern;
  for (int copy = 0; copy < part.count; ++copy) {
    const int place = part.first + copy;
    const int on = nominal_.bodies[place].hinge.on;
    const RigidBody& parent = c.rigid_body(on);
    if (copy == 0 || is_each || on > 0) {
      set(part.keys, numbers, copy);
      body = read_body(part.table, parent, {}, made);
      pattern = read_pattern(part.table);
    }
    body.hinge.on = on;
    c.bodies[place] = pattern.copy_of(body, copy, parent.com);
    c.bodies[place].rigid.name = nominal_.bodies[place].rigid.name;
    turns[place] = on > 0 ? turns[on - 1] : pattern.turn(copy);
  }
}

std::vector<Force> CaseForm::read_forces(const Numbers& numbers,
                                         const CaseNames& names) {
  std::vector<Force> forces;
  for (const Part& part : forces_) {
    for (int copy = 0; copy < part.count; ++copy) {
      set(part.keys, numbers, copy);
      forces.push_back(read_force(part.table, names, copy));
    }
  }
  return forces;
}

Case CaseForm::with(const Numbers& numbers) {
  Case c = nominal_;
  contact::SharedLaws made = made_;
  const TomlTable& file = form_.table();
  set(run_, numbers, 0);
  if (!run_.empty()) read_run_of(file, c);
  set(carrier_, numbers, 0);
  if (!carrier_.empty()) read_carrier_of(file, c);
  CaseNames names{c, turns_, event_names_};
  const auto has_keys = [](const Part& part) { return !part.keys.empty(); };
  const bool all = !carrier_.empty() ||
                   (c.is_tree() && std::ranges::any_of(bodies_, has_keys));
  bool read = all;
  for (const Part& body : bodies_) {
    if (!all && body.keys.empty()) continue;
    read_bodies(body, numbers, made, c, names.turns);
    read = true;
  }
  if (read) {  // directions may be others
    c.tip_offs.clear();
    read_tip_offs(file, names, c);
  }
  for (const Part& event : events_) {
    if (event.keys.empty()) continue;
    set(event.keys, numbers, 0);
    c.events[event.first] = read_event(event.table, names);
  }
  if (read || std::ranges::any_of(forces_, has_keys)) {
    c.forces = read_forces(numbers, names);
    check_propellant(file, c);
  }
  return c;
}

}  // namespace separation
