#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "study/rows/row.hpp"

namespace study {

/// The rows of a study that are done, in a file, in the order in which they
/// came. A row is there whole or not at all whenever its writer is killed. Of
/// the rows only their places are in memory.
class Journal {
 public:
  enum class Use { write, read };
  /// Opens a journal, or makes it.
  /// @param identity  whatever makes the rows of two studies different
  /// @param numbers   of a row
  /// @throws contact::Error if it cannot be opened, is of another study,
  ///   damaged, or written by another program right now
  Journal(std::string path, const std::string& identity, std::size_t numbers,
          Use use);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::uint64_t run) const { return places_.contains(run); }
  std::size_t size() const { return places_.size(); }
  /// By one thread at a time.
  /// @throws contact::Error if it cannot be written
  void append(const Row& row);
  /// @throws contact::Error if it cannot be read
  Row at(std::uint64_t run) const;

 private:
  [[noreturn]] void fail(const std::string& why) const;
  [[noreturn]] void fail_errno(const char* what) const;
  void open(Use use);
  void begin(const std::string& header, Use use);
  template <class Look>
  std::uint64_t scan(const Look& look) const;
  std::size_t longest_row() const;
  std::string read(std::uint64_t from, std::size_t size) const;

  std::string path_;
  std::size_t numbers_;
  int file_ = -1;
  std::uint64_t first_ = 0;  ///< place of the first row
  std::uint64_t end_ = 0;    ///< behind the last one
  std::unordered_map<std::uint64_t, std::uint64_t> places_;
};

}  // namespace study
