#include "separation/case/case_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace separation {
namespace {

using contact::TomlTable;

[[noreturn]] void refuse(const TomlTable& table, std::string_view key,
                         const std::vector<std::string>& names) {
  table.fail(key, fmt::format("allowed: {}", fmt::join(names, ", ")));
}

std::vector<std::string> body_names(const Case& c, bool with_carrier) {
  std::vector<std::string> names;
  if (with_carrier) names.push_back(c.carrier.name);
  for (const Load& load : c.loads) {
    if (names.empty() || names.back() != load.group) {
      names.push_back(load.group);
    }
  }
  for (const Load& load : c.loads) {
    if (load.body.name != load.group) names.push_back(load.body.name);
  }
  return names;
}

}  // namespace

std::vector<int> CaseNames::bodies(std::string_view name) const {
  std::vector<int> found;
  if (of.carrier.name == name) found.push_back(0);
  for (std::size_t i = 0; i < of.loads.size(); ++i) {
    if (of.loads[i].group == name || of.loads[i].body.name == name) {
      found.push_back(static_cast<int>(i) + 1);
    }
  }
  return found;
}

std::vector<int> CaseNames::bodies_of(const TomlTable& table,
                                      std::string_view key) const {
  auto found = bodies(table.text(key));
  if (found.empty()) refuse(table, key, body_names(of, true));
  return found;
}

std::vector<int> CaseNames::loads_of(const TomlTable& table,
                                     std::string_view key) const {
  std::vector<int> loads;
  for (const std::string& name : table.texts(key)) {
    const auto found = bodies(name);
    if (found.empty() || found.front() == 0) {
      refuse(table, key, body_names(of, false));
    }
    for (const int body : found) {
      if (std::find(loads.begin(), loads.end(), body - 1) == loads.end()) {
        loads.push_back(body - 1);
      }
    }
  }
  if (loads.empty()) {
    for (std::size_t i = 0; i < of.loads.size(); ++i) {
      loads.push_back(static_cast<int>(i));
    }
  }
  return loads;
}

int CaseNames::event_of(const TomlTable& table, std::string_view key,
                        std::string_view except) const {
  const auto name = table.optional_text(key);
  if (!name) return -1;
  const auto found = std::find(events.begin(), events.end(), *name);
  if (found == events.end() || *found == except) {
    std::vector<std::string> allowed = events;
    std::erase(allowed, except);
    if (allowed.empty()) {
      table.fail(key, except.empty() ? "there are no events"
                                     : "there is no other event");
    }
    refuse(table, key, allowed);
  }
  return static_cast<int>(found - events.begin());
}

}  // namespace separation
