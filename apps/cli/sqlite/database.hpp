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

/// An error of SQLite with its primary result code.
class DatabaseError : public contact::Error {
 public:
  DatabaseError(const std::string& message, int code)
      : contact::Error(message), code_(code) {}
  int code() const { return code_; }
  /// True if the file is not an SQLite database.
  bool is_stranger() const;

 private:
  int code_;
};

class Database;

/// An SQL statement, compiled once and run with values any number of times.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);

  /// Binds the parameters from left to right and steps to the first row.
  /// @returns true if there is a row
  template <class... Values>
  bool run(const Values&... values) {
    begin();
    int place = 0;
    (bind(++place, values), ...);
    return next();
  }
  void begin();
  /// Binds NaN as NULL, because SQLite has no NaN.
  void bind(int place, double value);
  void bind(int place, std::int64_t value);
  void bind(int place, std::string_view text);
  void bind_bytes(int place, std::string_view bytes);
  /// @returns true if there is another row
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

/// An SQLite file, used by one thread at a time. Other programs may read and
/// write it at the same time; a statement waits for them. A file of foreign
/// origin may contain any SQL: call has_only() before reading its tables.
class Database {
 public:
  enum class Use { write, read };

  /// @throws DatabaseError if the file cannot be opened, or made for writing
  Database(const std::string& name, Use use);

  const std::string& name() const { return name_; }
  sqlite3* handle() const { return database_.get(); }
  /// Runs statements without parameters and results.
  void run(const std::string& sql) const;
  /// True if the file has exactly the tables of these CREATE statements: no
  /// view in place of a table, and no trigger.
  bool has_only(std::vector<std::string> tables) const;
  /// The first number of the first row of a statement's result.
  std::int64_t ask(const std::string& sql) const;

  /// Write-ahead logging: each commit costs one write, and readers are not
  /// blocked. While it is open, the database keeps new data in NAME-wal. No
  /// effect on a file system without memory shared by programs.
  void write_ahead() const;
  /// Merges the log into the database file if no other program has it open.
  void write_back() const noexcept;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// Changes that commit() makes permanent; without commit() they are undone.
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
