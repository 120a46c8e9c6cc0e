#include "programs/separation/output/summary_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/stream/report.hpp"
#include "cli/stream/terminal_unit.hpp"

namespace separation {
namespace {

using cli::Cell;
using nlohmann::ordered_json;

std::string text_of(const ordered_json& of, const char* key) {
  return of.at(key).get<std::string>();
}

// "core and booster 1", or "passage (upper and lower)" of one with a name.
std::string pair_text(const ordered_json& pair) {
  const std::string bodies =
      fmt::format("{} and {}", text_of(pair, "a"), text_of(pair, "b"));
  const std::string name = pair.value("name", "");
  return name.empty() ? bodies : fmt::format("{} ({})", name, bodies);
}

std::string tip_off_text(const ordered_json& tip_off) {
  return fmt::format("{} at {}", text_of(tip_off, "body"),
                     text_of(tip_off, "at"));
}

// Every number, a row each.

void add_number(const std::string& name, const std::string& key, double number,
                cli::RowWriter& row) {
  row.text(name);
  row.text(key);
  row.number(number);
  row.end();
}

// The parts of a vector, or the ends of an interval.
void add_parts(const std::string& name, const std::string& key,
               const ordered_json& parts, cli::RowWriter& row) {
  constexpr const char* axes[] = {"_x", "_y", "_z"};
  constexpr const char* ends[] = {"_from", "_to"};
  const std::size_t stem = cli::shown_unit(key).stem.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string part = key;
    part.insert(stem, parts.size() == 2 ? ends[i] : axes[i]);
    add_number(name, part, parts[i].get<double>(), row);
  }
}

// Adds the numbers of a body or joint, and of its nested objects under their
// names.
void add_numbers(const std::string& name, const ordered_json& of,
                 cli::RowWriter& row) {
  for (const auto& [key, value] : of.items()) {
    if (value.is_number()) {
      add_number(name, key, value.get<double>(), row);
    } else if (value.is_object()) {
      add_numbers(name, value, row);
    } else if (value.is_array() && !value.empty() && value[0].is_number()) {
      add_parts(name, key, value, row);
    } else if (value.is_array()) {
      for (const ordered_json& part : value) {
        if (!part.is_object()) continue;
        add_numbers(name + ' ' + part.value("name", ""), part, row);
      }
    }
  }
}

void write_all(const ordered_json& summary, cli::Output& output,
               const cli::TableStyle& style) {
  cli::write_table(
      style.of_quantity({"value"}), {"body", "quantity", "value"}, output,
      [&](cli::RowWriter& row) {
        for (const ordered_json& event : summary.at("events")) {
          row.text(text_of(event, "body"));
          row.text(text_of(event, "what"));
          row.text(fmt::format("{:.4g} s", event.at("time_s").get<double>()));
          row.end();
        }
        for (const ordered_json& body : summary.at("bodies")) {
          add_numbers(text_of(body, "name"), body, row);
        }
        for (const ordered_json& of :
             summary.value("tip_off", ordered_json::array())) {
          add_numbers(tip_off_text(of), of, row);
        }
        for (const ordered_json& pair : summary.at("clearance")) {
          add_numbers(pair_text(pair), pair, row);
        }
        add_numbers("energy", summary.at("energy"), row);
      });
}

// What matters: a table of events, of bodies and of tip-offs, and lines on the
// whole run.

struct ReportTable {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows = {};
};

Cell number_at(const ordered_json& of, const std::string& key) {
  const auto found = of.find(key);
  if (found == of.end() || !found->is_number()) return {};
  return found->get<double>();
}

// Events of one kind are a row if there are many.
ReportTable events_of(const ordered_json& summary) {
  struct Kind {
    std::string what;
    double first;
    double last;
    std::size_t number = 0;
    std::vector<std::string> bodies = {};
  };
  constexpr std::size_t many = 9;
  const ordered_json& events = summary.at("events");
  std::vector<Kind> kinds;
  for (const ordered_json& event : events) {
    const std::string what = text_of(event, "what");
    const std::string body = text_of(event, "body");
    const double time = event.at("time_s").get<double>();
    auto kind = std::ranges::find(kinds, what, &Kind::what);
    if (kind == kinds.end() || events.size() < many) {
      kind = kinds.insert(kinds.end(),
                          {.what = what, .first = time, .last = time});
    }
    kind->last = time;
    ++kind->number;
    if (!std::ranges::count(kind->bodies, body)) kind->bodies.push_back(body);
  }
  ReportTable table{{"event", "time_s", "until_s", "number", "body"}};
  for (const Kind& kind : kinds) {
    const bool once = kind.number == 1;
    const std::size_t bodies = kind.bodies.size();
    table.rows.push_back(
        {kind.what, kind.first,
         once || kind.last == kind.first ? Cell() : Cell(kind.last),
         once ? Cell() : Cell(kind.number),
         bodies == 1 ? kind.bodies[0] : fmt::format("{} bodies", bodies)});
  }
  return table;
}

// A number of a body: of the body itself, of its release, or the largest of its
// joints.
struct BodyNumber {
  enum class Of { body, release, joints };
  const char* column;
  Of of;
  const char* key;
};
constexpr BodyNumber body_numbers[] = {
    {"release_s", BodyNumber::Of::release, "time_s"},
    {"angle_at_release_deg", BodyNumber::Of::release, "angle_deg"},
    {"rate_at_release_deg_per_s", BodyNumber::Of::release, "rate_deg_per_s"},
    {"peak_reaction_N", BodyNumber::Of::body, "peak_reaction_N"},
    {"largest_stop_impulse_N_m_s", BodyNumber::Of::body,
     "largest_stop_impulse_N_m_s"},
    {"peak_latch_moment_N_m", BodyNumber::Of::body, "peak_latch_moment_N_m"},
    {"torque_margin", BodyNumber::Of::body, "torque_margin"},
    {"work_of_friction_J", BodyNumber::Of::body, "work_of_friction_J"},
    {"time_at_rest_s", BodyNumber::Of::body, "time_at_rest_s"},
    {"peak_pressure_Pa", BodyNumber::Of::joints, "peak_pressure_Pa"},
    {"largest_theta0_deg", BodyNumber::Of::joints, "largest_theta0_deg"},
};

Cell cell_of(const BodyNumber& number, const ordered_json& body) {
  switch (number.of) {
    case BodyNumber::Of::body:
      return number_at(body, number.key);
    case BodyNumber::Of::release:
      return number_at(body.value("at_release", ordered_json()), number.key);
    case BodyNumber::Of::joints:
      break;
  }
  Cell largest;
  for (const ordered_json& joint :
       body.value("joints", ordered_json::array())) {
    const Cell cell = number_at(joint, number.key);
    // A joint whose peak is not known makes the body's unknown.
    if (!std::holds_alternative<double>(cell)) return {};
    if (largest < cell) largest = cell;
  }
  return largest;
}

ReportTable bodies_of(const ordered_json& summary) {
  ReportTable table{{"body"}};
  for (const BodyNumber& number : body_numbers) {
    table.columns.emplace_back(number.column);
  }
  for (const ordered_json& body : summary.at("bodies")) {
    if (!body.contains("hinge")) continue;
    std::vector<Cell>& row = table.rows.emplace_back(1, text_of(body, "name"));
    for (const BodyNumber& number : body_numbers) {
      row.push_back(cell_of(number, body));
    }
  }
  return table;
}

Cell length_at(const ordered_json& of, const char* key) {
  double square = 0;
  for (const ordered_json& part : of.at(key)) {
    if (!part.is_number()) return {};
    square += std::pow(part.get<double>(), 2);
  }
  return std::sqrt(square);
}

ReportTable tip_offs_of(const ordered_json& summary) {
  ReportTable table{{"tip_off", "angular_velocity_deg_per_s",
                     "velocity_m_per_s", "tip_off_rate_deg_per_s"}};
  for (const ordered_json& of :
       summary.value("tip_off", ordered_json::array())) {
    table.rows.push_back({tip_off_text(of),
                          length_at(of, "angular_velocity_deg_per_s"),
                          length_at(of, "velocity_m_per_s"),
                          number_at(of, "tip_off_rate_deg_per_s")});
  }
  return table;
}

// The smallest distance of all pairs, and the energy.
ReportTable run_of(const ordered_json& summary) {
  ReportTable table{{"smallest_distance_m", "distance_time_s", "pair",
                     "largest_energy_J", "energy_drift_J"},
                    {std::vector<Cell>(3)}};
  std::vector<Cell>& row = table.rows[0];
  const ordered_json& pairs = summary.at("clearance");
  const auto nearest =
      std::ranges::min_element(pairs, {}, [](const ordered_json& pair) {
        return pair.at("smallest_m").get<double>();
      });
  if (nearest != pairs.end()) {
    row = {number_at(*nearest, "smallest_m"), number_at(*nearest, "time_s"),
           pair_text(*nearest)};
  }
  row.push_back(number_at(summary.at("energy"), "largest_J"));
  row.push_back(number_at(summary.at("energy"), "largest_drift_J"));
  return table;
}

// Columns that have a value in some row other than 0.
ReportTable without_idle_columns(const ReportTable& table) {
  ReportTable used{{}, std::vector<std::vector<Cell>>(table.rows.size())};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool idle =
        std::ranges::all_of(table.rows, [&](const std::vector<Cell>& row) {
          return row[i] == Cell() || row[i] == Cell(0.0);
        });
    if (idle) continue;
    used.columns.push_back(table.columns[i]);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      used.rows[r].push_back(table.rows[r][i]);
    }
  }
  return used;
}

void write_part(const ReportTable& table, cli::Output& output,
                const cli::TableStyle& style) {
  cli::write_table(style, table.columns, output, [&](cli::RowWriter& row) {
    for (const std::vector<Cell>& cells : table.rows) {
      for (const Cell& cell : cells) cli::write_cell(cell, row);
      row.end();
    }
  });
}

void write_short(const ordered_json& summary, cli::Output& output,
                 const cli::TableStyle& style) {
  cli::TableStyle part = style;
  part.report.more.clear();
  part.report.all = true;
  for (const ReportTable& rows :
       {events_of(summary), bodies_of(summary), tip_offs_of(summary)}) {
    const ReportTable table = without_idle_columns(rows);
    if (table.columns.size() < 2) continue;
    part.report.always_table = table.columns[0] != "body";
    write_part(table, output, part);
    output.write("\n");
    part.report.title.clear();
  }
  write_part(run_of(summary), output, style.titled(part.report.title));
}

}  // namespace

void write_report(const ordered_json& summary, cli::Output& output,
                  const cli::TableStyle& style) {
  cli::TableStyle shown = style.titled(text_of(summary, "case"));
  shown.columns.clear();  // --columns selects columns of histories
  if (shown.report.all) {
    write_all(summary, output, shown);
  } else {
    write_short(summary, output, shown);
  }
}

}  // namespace separation
