#include "cli/sqlite/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <limits>
#include <thread>
#include <utility>

namespace cli {
namespace {

// Longest time that a statement waits for another program, ms.
constexpr int patience = 60'000;

[[noreturn]] void fail(const std::string& name, sqlite3* database) {
  const int extended = sqlite3_extended_errcode(database);
  const int code = extended & 0xff;
  // SQLite discards the error code that tells that a disk is full.
  const int cause =
      code == SQLITE_FULL ? ENOSPC : sqlite3_system_errno(database);
  std::string what = sqlite3_errmsg(database);
  if (code == SQLITE_CANTOPEN) what = "cannot open";
  if (code == SQLITE_FULL || code == SQLITE_IOERR) {
    what = extended == SQLITE_IOERR_READ ? "cannot read" : "cannot write";
  }
  if (cause != 0 && code != SQLITE_NOTADB) {
    what += fmt::format(": {}", std::strerror(cause));
  }
  throw DatabaseError(fmt::format("{}: {}", name, what), code);
}

}  // namespace

bool DatabaseError::is_stranger() const { return code_ == SQLITE_NOTADB; }

Statement::Statement(const Database& database, const std::string& sql)
    : database_(database.handle()), name_(database.name()) {
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v2(database_, sql.c_str(),
                           static_cast<int>(sql.size()) + 1, &statement,
                           nullptr));
  statement_.reset(statement);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(name_, database_);
}

void Statement::begin() { sqlite3_reset(statement_.get()); }

void Statement::bind(int place, double value) {
  check(sqlite3_bind_double(statement_.get(), place, value));
}

void Statement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), place, value));
}

void Statement::bind(int place, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
}

void Statement::bind_bytes(int place, std::string_view bytes) {
  check(sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(),
                            SQLITE_TRANSIENT));
}

// Resets a finished statement at once, so that it holds no lock.
bool Statement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  check(sqlite3_reset(statement_.get()));
  return false;
}

double Statement::number(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return sqlite3_column_double(statement_.get(), column);
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (size == 0) return {};
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

// An absolute path has no special meaning, unlike ":memory:". A database whose
// writer was killed is recovered before it is read.
Database::Database(const std::string& name, Use use) : name_(name) {
  const int flags =
      SQLITE_OPEN_READWRITE | (use == Use::write ? SQLITE_OPEN_CREATE : 0);
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(std::filesystem::absolute(name).c_str(),
                                   &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) fail(name_, database);
  sqlite3_busy_timeout(database, patience);
  // As sqlite.org/security.html recommends for untrusted files.
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

void Database::run(const std::string& sql) const {
  if (sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr) !=
      SQLITE_OK) {
    fail(name_, handle());
  }
}

bool Database::has_only(std::vector<std::string> tables) const {
  Statement sql(*this, "SELECT sql FROM sqlite_master");
  for (bool more = sql.run(); more; more = sql.next()) {
    const auto table = std::ranges::find(tables, sql.text(0));
    if (table == tables.end()) return false;
    tables.erase(table);
  }
  return tables.empty();
}

std::int64_t Database::ask(const std::string& sql) const {
  Statement statement(*this, sql);
  return statement.run() ? statement.integer(0) : 0;
}

// SQLite itself does not wait while another program changes this mode.
void Database::write_ahead() const {
  using namespace std::chrono_literals;
  for (auto waited = 0ms; waited < std::chrono::milliseconds(patience);
       waited += 10ms) {
    const int code = sqlite3_exec(handle(), "PRAGMA journal_mode = WAL",
                                  nullptr, nullptr, nullptr);
    if ((code & 0xff) != SQLITE_BUSY) break;
    std::this_thread::sleep_for(10ms);
  }
  // Writes the log back every 16 MB.
  run("PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 4000");
}

void Database::write_back() const noexcept {
  if (sqlite3_get_autocommit(handle()) == 0) {
    sqlite3_exec(handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  sqlite3_busy_timeout(handle(), 0);
  sqlite3_exec(handle(), "PRAGMA journal_mode = DELETE", nullptr, nullptr,
               nullptr);
  sqlite3_busy_timeout(handle(), patience);
}

Transaction::~Transaction() {
  if (!open_) return;
  sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace cli
