#include "programs/separation/output/checkpoint_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/files_in_use.hpp"
#include "libcontact/base/error.hpp"

namespace separation {
namespace {

// Whether a file is still there under its name.
bool has_name(int file, const std::string& name) {
  struct stat ours = {};
  struct stat named = {};
  return fstat(file, &ours) == 0 && stat(name.c_str(), &named) == 0 &&
         ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

}  // namespace

// All links to a checkpoint have one lock.
std::string CheckpointLock::file_of(const std::string& checkpoint) {
  return cli::destination(checkpoint).string() + ".lock";
}

CheckpointLock::CheckpointLock(const std::string& checkpoint)
    : name_(file_of(checkpoint)) {
  while (!lock(checkpoint)) close(file_);
}

// False if the file was removed by its last owner before it was locked here.
bool CheckpointLock::lock(const std::string& checkpoint) {
  constexpr int flags = O_RDWR | O_CREAT | O_CLOEXEC;
  file_ = open(name_.c_str(), flags | O_EXCL, 0666);
  made_ = file_ >= 0;
  if (!made_ && errno == EEXIST) file_ = open(name_.c_str(), flags, 0666);
  if (file_ < 0) {
    throw contact::Error(
        fmt::format("cannot create {}: {}", name_, std::strerror(errno)));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return has_name(file_, name_);
  close(file_);
  throw contact::Error(
      fmt::format("{}: another program writes to this checkpoint", checkpoint));
}

CheckpointLock::~CheckpointLock() {
  if (made_) unlink(name_.c_str());
  close(file_);
}

}  // namespace separation
