// Runs of cases in tests, their events and numbers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "separation/results/saved_state.hpp"

namespace contact::test {

/// Outcome of a run that does not fail; a state may have each of its events.
inline separation::Outcome run_of(const separation::Case& c) {
  separation::Outcome outcome = separation::run_case(c, {});
  EXPECT_EQ(outcome.failure, "");
  for (const separation::Note& note : outcome.memory.notes) {
    EXPECT_TRUE(separation::can_be_noted(note, c)) << note.what;
  }
  return outcome;
}
inline separation::Outcome run_of(const std::string& text) {
  return run_of(separation::parse_case(text, "c.toml"));
}

inline std::vector<separation::Note> notes_of(
    const separation::Outcome& outcome, const std::string& what) {
  std::vector<separation::Note> found;
  for (const separation::Note& note : outcome.memory.notes) {
    if (note.what == what) found.push_back(note);
  }
  return found;
}

/// Number in the last row of the history.
inline double last(const separation::Outcome& outcome,
                   const std::string& column) {
  const separation::Rows& rows = outcome.memory.rows;
  return rows.at(rows.size() - 1, rows.column(column));
}

/// Head of a case of stops, with other keys in front of [run].
inline std::string run_for(double end, const std::string& more = "") {
  return "name = \"stops\"\n" + more +
         "[run]\nend_time_s = " + std::to_string(end) +
         "\nrelative_tolerance = 1e-12\nabsolute_tolerance = 1e-13\n";
}
inline std::string stop(const std::string& keys) {
  return "[[body.hinge.stop]]\n" + keys + "\n";
}

}  // namespace contact::test
