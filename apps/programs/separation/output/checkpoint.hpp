#pragma once

#include <boost/crc.hpp>
#include <fstream>
#include <string>
#include <vector>

#include "programs/separation/output/checkpoint_lock.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// A run in the middle.
struct Checkpoint {
  double every;  ///< s of the motion between checkpoints
  RunState state;
};

/// All files that a checkpoint may be made of while it is written.
std::vector<std::string> checkpoint_files(const std::string& file);

/// The checkpoint of a run, renewed on its way.
///
/// FILE has what the run needs to go on; it is replaced as a whole. Rows and
/// events so far are in FILE.rows1 or FILE.rows2, to which every write()
/// appends what is new: a checkpoint costs the same late in a run as early.
/// FILE says which of the two it is and how much of it counts, with a check
/// sum; another check sum is that of FILE. A new run takes the name that the
/// checkpoint of an earlier one does not use, so that there is a whole
/// checkpoint at any time. One program writes a checkpoint at a time.
class CheckpointWriter {
 public:
  /// @param identity  of the run: what the case file says, joints and options
  /// @throws contact::Error if the files cannot be made, if FILE is there and
  ///   is no checkpoint, of another version or damaged, if a file has the name
  ///   of its rows that is none, or if another program writes it
  CheckpointWriter(std::string file, std::string identity, double every);
  /// Removes its rows if nothing refers to them.
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// @param memory  that of the last call, with what is new
  /// @throws contact::Error if it cannot be written
  void write(const SimulationState& simulation, const Recorder::Memory& memory);

 private:
  void append(const Recorder::Memory& memory, double time);

  std::string file_;
  CheckpointLock lock_;
  std::string identity_;
  double every_;
  std::string old_rows_;  // of an earlier run, until the first write()
  int number_;            // of rows_
  std::string rows_;
  std::ofstream stream_;
  bool written_ = false;
  // In rows_ so far.
  std::size_t numbers_ = 0;
  std::size_t notes_ = 0;
  std::size_t blocks_ = 0;
  std::size_t bytes_ = 0;
  boost::crc_32_type sum_;
};

/// @throws contact::Error if the files cannot be read, are no checkpoint,
///   damaged, or of another run
Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity);

}  // namespace separation
