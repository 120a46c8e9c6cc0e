#include "cli/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <mutex>
#include <string_view>
#include <system_error>

#include "cli/files_in_use.hpp"
#include "cli/stream/quoting.hpp"
#include "libcontact/base/error.hpp"

namespace cli {
namespace {

// Files to remove when a signal ends the program; more than a program ever
// writes at once.
struct Unfinished {
  std::array<char, 4096> name;
  std::atomic<bool> used;
};
std::array<Unfinished, 8> unfinished;

extern "C" void remove_unfinished(int signal) {
  for (auto& file : unfinished) {
    if (file.used) unlink(file.name.data());
  }
  // The handler was reset on entry (SA_RESETHAND): end as the signal would.
  raise(signal);
}

void remember(const std::string& name) {
  static std::once_flag installed;
  std::call_once(installed, [] {
    struct sigaction action = {};
    action.sa_handler = remove_unfinished;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    // All signals by which others end a program; schedulers send the last ones
    // before the time limit.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ,
                             SIGALRM, SIGXCPU, SIGUSR1, SIGUSR2}) {
      struct sigaction before = {};
      sigaction(signal, nullptr, &before);
      if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
  });
  for (auto& file : unfinished) {
    if (file.used || name.size() >= file.name.size()) continue;
    std::memcpy(file.name.data(), name.c_str(), name.size() + 1);
    file.used = true;
    return;
  }
}

void forget(const std::string& name) {
  for (auto& file : unfinished) {
    if (file.used && name == file.name.data()) file.used = false;
  }
}

// Permissions that a new file gets here.
mode_t new_file_mode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

// errno gives the reason if not.
bool can_write(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags < 0) return false;
  errno = EBADF;
  return (flags & O_ACCMODE) != O_RDONLY;
}

// The descriptor of this process that a name refers to; -1 for other names. A
// file behind it must not be replaced, because others write to it too.
int descriptor_of(std::string_view name) {
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    const char* const end = name.data() + name.size();
    int number = -1;
    const auto [rest, error] =
        std::from_chars(name.data() + folder.size(), end, number);
    if (error == std::errc() && rest == end) return number;
  }
  return -1;
}

}  // namespace

Output::Output(const std::string& path) {
  if (const int open = descriptor_of(path); open >= 0) {
    path_ = path;
    check_unread(path_);
    descriptor_ = fcntl(open, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail("cannot open");
    if (!can_write(descriptor_)) fail("cannot write");
    return;
  }
  if (path.empty() || path == "-") {
    check_unread("/dev/stdout");
    descriptor_ = STDOUT_FILENO;
    if (!can_write(descriptor_)) fail("cannot write");
    return;
  }
  std::error_code ignored;
  // Through symbolic links, so that a link stays a link.
  path_ = std::filesystem::weakly_canonical(path, ignored);
  if (path_.empty()) path_ = path;
  const auto status = std::filesystem::status(path_, ignored);
  check_place(status);
  if (std::filesystem::exists(status) &&
      !std::filesystem::is_regular_file(status)) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot open");
    return;
  }
  check_unread(path_);
  std::string name = path_.parent_path() /
                     fmt::format(".{}.XXXXXX", path_.filename().string());
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot create");
  temporary_ = name;
  remember(name);
  // Keeps the mode of a replaced file, else the mode of a new file.
  fchmod(descriptor_, std::filesystem::exists(status)
                          ? static_cast<mode_t>(status.permissions())
                          : new_file_mode());
}

// Renaming requires write permission only for the folder. Tools that write in
// place would fail for a write-protected file, so this rejects it too.
void Output::check_place(const std::filesystem::file_status& status) const {
  std::error_code ignored;
  if (std::filesystem::is_symlink(
          std::filesystem::symlink_status(path_, ignored))) {
    errno = ENOENT;  // target of the link does not exist
    fail("cannot write");
  }
  constexpr auto any_write = std::filesystem::perms::owner_write |
                             std::filesystem::perms::group_write |
                             std::filesystem::perms::others_write;
  if (!std::filesystem::is_regular_file(status)) return;
  if ((status.permissions() & any_write) != std::filesystem::perms::none &&
      faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) == 0) {
    return;
  }
  errno = EACCES;
  fail("cannot write");
}

Output::~Output() { discard(); }

void Output::check(const std::string& path) {
  std::error_code ignored;
  // Do not open a pipe here: its reader would see the end.
  if (std::filesystem::is_fifo(path, ignored)) return;
  const Output possible(path);
}

void Output::discard() {
  if (!temporary_.empty()) {
    unlink(temporary_.c_str());
    forget(temporary_);
    temporary_.clear();
  }
  if (is_own()) close(descriptor_);
  descriptor_ = -1;
}

void Output::write(std::string_view text) {
  if (isatty(descriptor_) == 0) return write_all(text);
  write_all(terminal_text(text));
}

void Output::write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno != EINTR) fail("cannot write");
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Output::commit() {
  // Sync before renaming; otherwise after a power failure the file could exist
  // without its text. File systems that do not support it return EINVAL.
  if (!temporary_.empty() && fsync(descriptor_) != 0 && errno != EINVAL) {
    fail("cannot write");
  }
  if (is_own()) {
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail("cannot write");
  }
  if (temporary_.empty()) return;
  check_unread(path_);
  if (rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot rename to");
  forget(temporary_);
  temporary_.clear();
}

void Output::fail(std::string_view what) const {
  throw contact::Error(fmt::format(
      "{} {}: {}", what, path_.empty() ? "standard output" : path_.native(),
      std::strerror(errno)));
}

}  // namespace cli
