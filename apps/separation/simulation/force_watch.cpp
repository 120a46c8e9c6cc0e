#include "separation/simulation/force_watch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

#include "separation/case/force_law.hpp"

namespace separation {
namespace {

int find_fault(const Force& force, const Simulation& simulation, bool begins) {
  const auto& sample = simulation.sample();
  const bool released = force.body > 0 && sample.mode(force.body - 1) ==
                                              multibody::HingeMode::released;
  const double time = sample.time();
  return force.law->find_fault({simulation.of(), force.body, sample.motions(),
                                time, time, History::not_yet},
                               begins, released);
}

}  // namespace

void look_at_forces(const Simulation& simulation,
                    std::vector<ForceRecord>& records) {
  const auto& sample = simulation.sample();
  for (std::size_t f = 0; f < records.size(); ++f) {
    ForceRecord& record = records[f];
    const Force& force = simulation.of().forces[f];
    const bool watched = record.fault == 0 && force.law->is_watched();
    if (record.acted && !watched) continue;
    const auto now = simulation.force(static_cast<int>(f), sample.motions());
    if (!now) continue;
    record.acted |= !now->force.isZero(0) || !now->moment.isZero(0);
    const bool begins = !record.on;
    record.on = true;
    if (record.fault != 0) continue;
    record.fault = find_fault(force, simulation, begins);
    record.fault_time = sample.time();
  }
}

std::vector<std::string> force_faults(const Case& c,
                                      const std::vector<ForceRecord>& records) {
  std::vector<std::string> texts;
  for (std::size_t f = 0; f < records.size(); ++f) {
    const auto& [on, acted, fault, time] = records[f];
    if (fault == 0) continue;
    const Force& force = c.forces[f];
    texts.push_back(fmt::format("force \"{}\" ", force.name) +
                    fmt::format(fmt::runtime(force.law->faults()[fault - 1]),
                                fmt::arg("body", c.rigid_body(force.body).name),
                                fmt::arg("time", time)));
  }
  return texts;
}

std::vector<std::string> idle_forces(const Case& c, const History& history,
                                     const std::vector<ForceRecord>& records,
                                     double end_time) {
  // One sentence for all bodies of a force that nothing came of in one way.
  constexpr std::array<const char*, 3> ways = {
      "did not begin for {}", "never acted on {}",
      "never acted on {}: its stroke was used up when it started"};
  std::map<std::pair<std::string, std::size_t>, std::vector<std::string>> idle;
  for (std::size_t f = 0; f < records.size(); ++f) {
    if (records[f].acted) continue;
    const Force& force = c.forces[f];
    const bool began = history.time_of(force.begin, force.body, c) < end_time;
    const bool used_up = history.spent[f] && !records[f].on;
    const std::size_t way = !began ? 0 : used_up ? 2 : 1;
    idle[{force.name, way}].push_back(c.rigid_body(force.body).name);
  }
  std::vector<std::string> texts;
  for (const auto& [key, bodies] : idle) {
    texts.push_back(
        fmt::format("force \"{}\" ", key.first) +
        fmt::format(fmt::runtime(ways[key.second]), fmt::join(bodies, ", ")));
  }
  return texts;
}

}  // namespace separation
