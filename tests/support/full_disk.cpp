// Preloaded into a program: a disk with room for CONTACT_TEST_ROOM more bytes.
// What is written to a file beyond them fails as on a full disk; pipes, files
// in memory and the standard streams have room. With CONTACT_TEST_LATE set a
// disk that has room for all, and says only when it is to keep it that it has
// none, as one over a network may.
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace {

std::size_t& room() {
  static std::size_t bytes = [] {
    const char* const text = std::getenv("CONTACT_TEST_ROOM");
    return text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
  }();
  return bytes;
}

bool is_late() { return std::getenv("CONTACT_TEST_LATE") != nullptr; }

bool on_disk(int descriptor) {
  struct stat status = {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 &&
         S_ISREG(status.st_mode) && status.st_nlink > 0;
}

// As much of a write as there is room for.
template <class Write>
ssize_t limited(int descriptor, std::size_t size, const Write& write) {
  if (!on_disk(descriptor) || is_late()) return write(size);
  if (room() == 0 && size > 0) {
    errno = ENOSPC;
    return -1;
  }
  const ssize_t count = write(std::min(size, room()));
  if (count > 0) room() -= static_cast<std::size_t>(count);
  return count;
}

template <class Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* data, std::size_t size) {
  static auto* const next = original<decltype(::write)>("write");
  return limited(descriptor, size, [&](std::size_t count) {
    return next(descriptor, data, count);
  });
}

ssize_t pwrite(int descriptor, const void* data, std::size_t size, off_t at) {
  static auto* const next = original<decltype(::pwrite)>("pwrite");
  return limited(descriptor, size, [&](std::size_t count) {
    return next(descriptor, data, count, at);
  });
}

ssize_t pwrite64(int descriptor, const void* data, std::size_t size,
                 off64_t at) {
  static auto* const next = original<decltype(::pwrite64)>("pwrite64");
  return limited(descriptor, size, [&](std::size_t count) {
    return next(descriptor, data, count, at);
  });
}

// All or nothing: of two pieces.
ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static auto* const next = original<decltype(::writev)>("writev");
  std::size_t size = 0;
  for (int i = 0; i < count; ++i) size += pieces[i].iov_len;
  if (on_disk(descriptor) && !is_late() && size > room()) {
    errno = ENOSPC;
    return -1;
  }
  return limited(descriptor, size,
                 [&](std::size_t) { return next(descriptor, pieces, count); });
}

int fsync(int descriptor) {
  static auto* const next = original<decltype(::fsync)>("fsync");
  if (!on_disk(descriptor) || !is_late()) return next(descriptor);
  errno = ENOSPC;
  return -1;
}

}  // extern "C"
