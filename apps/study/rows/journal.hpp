#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/sqlite/database.hpp"
#include "study/rows/row.hpp"

namespace study {

/// Stores completed rows of a study in an SQLite database: a table `rows` of
/// run, inputs and quantities by name, status ("ok" or the failure) and a
/// checksum. If the writer is killed, each row is either complete or absent.
/// Several programs may write one journal; each object is for one thread.
class Journal {
 public:
  enum class Use { write, read };
  /// Opens or creates a journal.
  /// @param identity  differs between any two different studies
  /// @param names     names of a row's numbers
  /// @throws contact::Error if it cannot be opened, belongs to another study or
  ///   version, or has more columns than SQLite allows
  Journal(const std::string& path, const std::string& identity,
          const std::vector<std::string>& names, Use use);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool has(std::uint64_t run) const;
  std::size_t size() const;
  /// Runs from `first` to `last` that are not in the journal.
  std::vector<std::uint64_t> missing(std::uint64_t first,
                                     std::uint64_t last) const;
  /// Promises that nothing more is appended through this object: rows are read
  /// faster, and later rows of other programs are not seen.
  void hold() const;
  /// Appends a row unless it exists.
  /// @throws contact::Error if it cannot be written
  void append(const Row& row);
  /// Copies the rows up to `last` from another journal of the same study.
  void take(const Journal& from, std::uint64_t last);
  /// @throws contact::Error if the row does not exist, cannot be read or is
  ///   damaged
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
