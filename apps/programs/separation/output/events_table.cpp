#include "programs/separation/output/events_table.hpp"

#include <cmath>
#include <utility>

#include "libcontact/base/units.hpp"

namespace separation {

std::string events_csv(const Case& c, const Outcome& outcome,
                       cli::TableStyle style) {
  style.columns.clear();
  std::vector<std::string> columns = {"time_s", "body", "what"};
  if (c.has_impacts()) {
    columns.insert(columns.end(),
                   {"rate_deg_per_s", "impulse_N_m_s", "energy_J"});
  }
  if (c.has_touches()) columns.push_back("approach_m_per_s");
  const cli::Table table(std::move(style), columns);
  cli::Text rows;
  cli::RowWriter row(table, rows);
  for (const Note& note : outcome.memory.notes) {
    row.number(note.time);
    row.text(note.body);
    row.text(note.what);
    if (c.has_impacts()) {
      const bool jumps = note.impulse > 0;
      row.number(note.rate != 0 ? note.rate / contact::degree : NAN);
      row.number(jumps ? note.impulse : NAN);
      row.number(jumps ? note.loss : NAN);
    }
    if (c.has_touches()) {
      row.number(note.approach != 0 ? note.approach : NAN);
    }
    row.end();
  }
  return table.header() + std::string(rows.view());
}

}  // namespace separation
