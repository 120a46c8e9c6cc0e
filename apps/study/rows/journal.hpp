#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/sqlite/database.hpp"
#include "study/rows/row.hpp"

namespace study {

/// The rows of a study that are done, in a database of SQLite: a table `rows`
/// of run, inputs and quantities by their names, status ("ok" or the failure)
/// and a check sum. A row is there whole or not at all whenever its writer is
/// killed; several programs may write one journal. One thread at a time uses
/// an object.
class Journal {
 public:
  enum class Use { write, read };
  /// Opens a journal, or makes it.
  /// @param identity  whatever makes the rows of two studies different
  /// @param names     of a row's numbers
  /// @throws contact::Error if it cannot be opened, is of another study or
  ///   version, or if SQLite has no room for as many columns
  Journal(const std::string& path, const std::string& identity,
          const std::vector<std::string>& names, Use use);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::uint64_t run) const;
  std::size_t size() const;
  /// Runs from `first` to `last` that are not there.
  std::vector<std::uint64_t> missing(std::uint64_t first,
                                     std::uint64_t last) const;
  /// From now on nothing is appended here: rows are read in less time, and rows
  /// of other programs are not seen.
  void hold() const;
  /// Does nothing if the row is there.
  /// @throws contact::Error if it cannot be written
  void append(const Row& row);
  /// Takes the rows of another journal of the study up to `last`.
  void take(const Journal& from, std::uint64_t last);
  /// @throws contact::Error if it is not there, cannot be read or is damaged
  Row at(std::uint64_t run) const;

 private:
  [[noreturn]] void fail(const std::string& why) const;
  void make(const std::string& identity, const std::vector<std::string>& names);
  void check(const std::string& identity,
             const std::vector<std::string>& names) const;

  cli::Database database_;
  Use use_;
  std::size_t numbers_;
  std::optional<cli::Statement> append_;
  mutable std::optional<cli::Statement> has_;
  mutable std::optional<cli::Statement> at_;
};

}  // namespace study
