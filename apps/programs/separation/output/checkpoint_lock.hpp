#pragma once

#include <string>

namespace separation {

/// The right to write a checkpoint, which one program has at a time. Its files
/// are replaced on the way and cannot be locked themselves: the lock is on an
/// empty file beside them, which is removed at the end. One that is left of a
/// program that was killed is nobody's lock.
class CheckpointLock {
 public:
  /// The name of the file beside a checkpoint.
  static std::string file_of(const std::string& checkpoint);
  /// @param checkpoint  its name
  /// @throws contact::Error if another program has it, or the file cannot be
  ///   made
  explicit CheckpointLock(const std::string& checkpoint);
  ~CheckpointLock();
  CheckpointLock(const CheckpointLock&) = delete;
  CheckpointLock& operator=(const CheckpointLock&) = delete;

 private:
  bool lock(const std::string& checkpoint);

  std::string name_;
  int file_ = -1;
  bool made_ = false;  ///< by this program
};

}  // namespace separation
