#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/base/error.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace cli {

/// Error of SQLite, with its primary result code.
class DatabaseError : public contact::Error {
 public:
  DatabaseError(const std::string& message, int code)
      : contact::Error(message), code_(code) {}
  int code() const { return code_; }
  /// Whether the file is none of SQLite's.
  bool is_stranger() const;

 private:
  int code_;
};

class Database;

/// One SQL statement, compiled once and run with values as often as wanted.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);

  /// The values of the parameters from left to right, then the first row.
  /// @returns whether there is one
  template <class... Values>
  bool run(const Values&... values) {
    begin();
    int place = 0;
    (bind(++place, values), ...);
    return next();
  }
  void begin();
  /// NaN is NULL, as SQLite has none.
  void bind(int place, double value);
  void bind(int place, std::int64_t value);
  void bind(int place, std::string_view text);
  void bind_bytes(int place, std::string_view bytes);
  /// @returns whether there is another row
  bool next();

  double number(int column) const;
  std::int64_t integer(int column) const;
  std::string text(int column) const;

 private:
  void check(int code) const;

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  sqlite3* database_;
  std::string name_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A file of SQLite, used by one thread at a time. Other programs may read and
/// write it meanwhile; a statement waits for theirs. A file may contain SQL of
/// any origin: check has_only() before reading its tables.
class Database {
 public:
  enum class Use { write, read };

  /// @throws DatabaseError if the file cannot be opened, or made to be written
  Database(const std::string& name, Use use);

  const std::string& name() const { return name_; }
  sqlite3* handle() const { return database_.get(); }
  /// Statements without parameters and results.
  void run(const std::string& sql) const;
  /// Whether it has the tables of these CREATE statements and nothing else: no
  /// view in the place of one, and no trigger.
  bool has_only(std::vector<std::string> tables) const;
  /// The first number of a statement's first row.
  std::int64_t ask(const std::string& sql) const;

  /// Commits cost one write each and readers go on meanwhile: as long as it is
  /// open, the database keeps what is new in NAME-wal. Where a file system has
  /// no memory shared by programs it stays as it is.
  void write_ahead() const;
  /// Brings all of it back into the one file if no other program has it open.
  void write_back() const noexcept;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// Changes that commit() keeps; without it they are undone.
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_(database) {
    database_.run("BEGIN IMMEDIATE");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace cli
