#pragma once

#include <array>
#include <string>

#include "cli/sqlite/database.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// State in the middle of a run.
struct Checkpoint {
  double every;  ///< simulated seconds between checkpoints
  RunState state;
};

/// Names of a checkpoint and of the file that SQLite writes beside it.
std::array<std::string, 2> checkpoint_files(const std::string& file);

/// Locks a file for one program at a time; makes the file if needed.
class FileLock {
 public:
  /// @throws contact::Error if it cannot be made or another program holds it
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_empty() const;

 private:
  int file_;
};

/// Writes the checkpoints of a run into an SQLite database: the state from
/// which the run resumes, and all rows and events so far. Each write() appends
/// only new ones, so a checkpoint late in a run costs no more than an early
/// one. A complete checkpoint always exists: the previous run's until the first
/// one of this run is written.
class CheckpointWriter {
 public:
  /// @param identity  of the run: its case file, joints and options
  /// @throws contact::Error if the file cannot be made, exists and is no
  ///   checkpoint, or is in use by another program
  CheckpointWriter(const std::string& file, std::string identity, double every);
  /// Removes the file if it is empty.
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// @param memory  the recorder's memory; extends the one of the last call
  /// @throws contact::Error if it cannot be written
  void write(const SimulationState& simulation, const Recorder::Memory& memory);

 private:
  FileLock lock_;
  cli::Database database_;
  std::string identity_;
  double every_;
  // Number of values, notes and blocks written so far.
  std::size_t numbers_ = 0;
  std::size_t notes_ = 0;
  std::size_t blocks_ = 0;
};

/// @throws contact::Error if the file cannot be read, is no checkpoint, is
///   damaged, or belongs to another run
Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity);

}  // namespace separation
