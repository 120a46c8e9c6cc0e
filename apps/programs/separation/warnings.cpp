#include "programs/separation/warnings.hpp"

#include <utility>

#include "cli/program.hpp"
#include "separation/results/notes.hpp"

namespace separation {

void Warnings::add(std::string text) {
  if (aloud_) cli::warn(program_name, text);
  texts_.push_back(std::move(text));
}

void Warnings::note(const std::string& text) const {
  if (aloud_) cli::note(program_name, text);
}

void warn_of_joints(const Case& c, Warnings& warnings) {
  for (const std::string& text : clearance_notes(c)) warnings.note(text);
  for (const std::string& note : joint_notes(c)) warnings.add(note);
}

void warn_of_run(const Case& c, const Outcome& outcome, Warnings& warnings) {
  for (const std::string& note : run_notes(c, outcome)) warnings.add(note);
}

void warn_of_replay(Replay& replay, Warnings& warnings) {
  for (const std::string& fault : replay_faults(replay)) warnings.add(fault);
  replay.warnings = warnings.texts();
}

}  // namespace separation
