#pragma once

#include <array>
#include <string>

#include "cli/sqlite/database.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// A run in the middle.
struct Checkpoint {
  double every;  ///< s of the motion between checkpoints
  RunState state;
};

/// A checkpoint, and what SQLite has beside it while it is written.
std::array<std::string, 2> checkpoint_files(const std::string& file);

/// A file that one program at a time has, made if it is not there.
class FileLock {
 public:
  /// @throws contact::Error if it cannot be made or another program has it
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_empty() const;

 private:
  int file_;
};

/// The checkpoint of a run, renewed on its way: a database of SQLite with the
/// state that the run goes on from, and the rows and events so far, to which
/// each write() appends what is new. A checkpoint costs the same late in a run
/// as early, and there is a whole one at any time: that of an earlier run until
/// the first of this one is written.
class CheckpointWriter {
 public:
  /// @param identity  of the run: what the case file says, joints and options
  /// @throws contact::Error if the file cannot be made, is there and no
  ///   checkpoint, or if another program writes it
  CheckpointWriter(const std::string& file, std::string identity, double every);
  /// Removes the file if it is empty.
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// @param memory  that of the last call, with what is new
  /// @throws contact::Error if it cannot be written
  void write(const SimulationState& simulation, const Recorder::Memory& memory);

 private:
  FileLock lock_;
  cli::Database database_;
  std::string identity_;
  double every_;
  // Numbers, notes and blocks written.
  std::size_t numbers_ = 0;
  std::size_t notes_ = 0;
  std::size_t blocks_ = 0;
};

/// @throws contact::Error if the file cannot be read, is no checkpoint,
///   damaged, or of another run
Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity);

}  // namespace separation
