#include "programs/separation/output/events_table.hpp"

#include <utility>

namespace separation {

std::string events_csv(const Outcome& outcome, cli::TableStyle style) {
  style.columns.clear();
  const cli::Table table(std::move(style), {"time_s", "body", "what"});
  cli::Text rows;
  cli::RowWriter row(table, rows);
  for (const Note& note : outcome.memory.notes) {
    row.number(note.time);
    row.text(note.body);
    row.text(note.what);
    row.end();
  }
  return table.header() + std::string(rows.view());
}

}  // namespace separation
