#pragma once

#include <string>

#include "separation/record.hpp"
#include "separation/simulation.hpp"

namespace separation {

/// A run in the middle.
struct Checkpoint {
  std::string identity;  ///< of the run: case file and options
  long next_output;
  SimulationState simulation;
  Recorder::Memory memory;
};

/// Writes a checkpoint (CBOR): whole or not at all.
/// @throws contact::Error if it cannot be written
void write_checkpoint(const std::string& file, const Checkpoint& checkpoint);

/// @throws contact::Error if the file cannot be read, is no checkpoint, or is
///   one of another run
Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity);

}  // namespace separation
