#include "study/rows/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "study/plan/draws.hpp"

namespace study {
namespace {

constexpr std::string_view kind = "hinge-study journal ";
// Of the rows: another one where the same study has other numbers.
constexpr int version = 2;

}  // namespace

Journal::Journal(std::string path, const std::string& identity,
                 std::size_t numbers, Use use)
    : path_(std::move(path)), numbers_(numbers) {
  open(use);
  try {
    begin(fmt::format("{}{} {:016x} {}\n", kind, version, hash_of(identity),
                      numbers),
          use);
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() { close(file_); }

void Journal::fail(const std::string& why) const {
  throw contact::Error(fmt::format("{}: {}", path_, why));
}

void Journal::fail_errno(const char* what) const {
  fail(fmt::format("{}: {}", what, std::strerror(errno)));
}

void Journal::open(Use use) {
  if (use == Use::read) contact::detail::tell_reading(path_);
  const int flags = use == Use::write ? O_RDWR | O_CREAT : O_RDONLY;
  file_ = ::open(path_.c_str(), flags | O_CLOEXEC, 0666);
  if (file_ < 0) fail_errno("cannot open");
  if (use == Use::write && flock(file_, LOCK_EX | LOCK_NB) != 0) {
    close(file_);
    fail("another program writes to this journal");
  }
}

// A file that ends within its header or within a row was cut short when its
// writer was killed: the next row takes that place.
void Journal::begin(const std::string& header, Use use) {
  struct stat status = {};
  if (fstat(file_, &status) != 0) fail_errno("cannot read");
  end_ = static_cast<std::uint64_t>(status.st_size);
  const std::string text = read(0, header.size());
  first_ = header.size();
  if (text != header) {
    if (use == Use::write && header.starts_with(text)) {
      if (pwrite(file_, header.data(), header.size(), 0) !=
          static_cast<ssize_t>(header.size())) {
        fail_errno("cannot write");
      }
      end_ = first_;
      return;
    }
    fail(contact::detail::must_be(
        text.starts_with(kind) ? "the study of this journal" : "the file",
        text.starts_with(kind) ? "the same, with the same files, seed and "
                                 "version; remove it or name "
                                 "another one with --journal"
                               : "a journal of hinge-study"));
  }
  end_ = scan([this](std::uint64_t place, const Row& row) {
    places_[row.run] = place;
  });
  if (use == Use::write && ftruncate(file_, static_cast<off_t>(end_)) != 0) {
    fail_errno("cannot write");
  }
}

// But for size and checksum, for which there is room too.
std::size_t Journal::longest_row() const {
  return (numbers_ + 4) * sizeof(double) + longest_failure;
}

std::string Journal::read(std::uint64_t from, std::size_t size) const {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = pread(file_, bytes.data() + done, size - done,
                                static_cast<off_t>(from + done));
    if (count < 0 && errno != EINTR) fail_errno("cannot read");
    if (count == 0) break;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

// Goes through the file by parts; the end of the last whole row.
template <class Look>
std::uint64_t Journal::scan(const Look& look) const {
  constexpr std::size_t part = 1 << 18;
  std::uint64_t place = first_;
  for (;;) {
    const std::string bytes = read(place, part + longest_row());
    std::string_view rest = bytes;
    const auto at = [&] { return place + (bytes.size() - rest.size()); };
    try {
      while (has_whole_row(rest, numbers_)) {
        const std::uint64_t row = at();
        look(row, take_row(rest, numbers_));
      }
    } catch (const contact::Error& error) {
      fail(
          fmt::format("{} near byte {}: remove this journal, or bring it back "
                      "from a copy",
                      error.what(), at()));
    }
    if (rest.size() == bytes.size()) return place;
    place = at();
  }
}

void Journal::append(const Row& row) {
  const std::string bytes = to_bytes(row);
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const ssize_t count =
        pwrite(file_, rest.data(), rest.size(),
               static_cast<off_t>(end_ + bytes.size() - rest.size()));
    if (count < 0 && errno != EINTR) fail_errno("cannot write");
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  places_[row.run] = end_;
  end_ += bytes.size();
}

Row Journal::at(std::uint64_t run) const {
  const std::string bytes = read(places_.at(run), longest_row());
  std::string_view rest = bytes;
  return take_row(rest, numbers_);
}

}  // namespace study
