#include "study/rows/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <set>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/file_text.hpp"
#include "study/plan/draws.hpp"

namespace study {
namespace {

using cli::Database;
using contact::detail::must_be;

// Application id in SQLite's header for this kind of file.
constexpr int application = 0x686a6e6c;
// Version of the rows; increase it when the same study gives other numbers.
constexpr int version = 3;
constexpr const char* study_table = "CREATE TABLE study (identity)";
// SQLite's default limit.
constexpr std::size_t most_columns = 2000;
// Columns before and after the numbers of a row.
constexpr std::size_t other_columns = 3;

std::int64_t as_integer(std::uint64_t run) {
  return static_cast<std::int64_t>(run);
}

// Name of a column in SQL; names must differ in more than case.
std::string column(std::string name, std::set<std::string>& taken) {
  const auto lower = [](std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
      return static_cast<char>(std::tolower(c));
    });
    return text;
  };
  while (!taken.insert(lower(name)).second) name += '_';
  std::string quoted;
  for (const char c : name) quoted.append(c == '"' ? 2 : 1, c);
  return '"' + quoted + '"';
}

// Columns without a type keep every bit of a number.
std::string table_of(const std::vector<std::string>& names) {
  std::set<std::string> taken = {"run", "status", "check_sum"};
  std::string sql = "CREATE TABLE rows (run INTEGER PRIMARY KEY";
  for (const std::string& name : names) sql += ", " + column(name, taken);
  return sql + ", status, check_sum)";
}

// All NaNs are equal in SQLite.
std::int64_t check_sum(const Row& row) {
  boost::crc_32_type crc;
  crc.process_bytes(&row.run, sizeof row.run);
  for (const double number : row.numbers) {
    const double some_nan = std::nan("");
    crc.process_bytes(std::isnan(number) ? &some_nan : &number, sizeof number);
  }
  crc.process_bytes(row.failure.data(), row.failure.size());
  return crc.checksum();
}

// Up to version 2 journals were text and bytes.
bool is_old(const std::string& path) {
  constexpr std::string_view beginning = "hinge-study journal ";
  std::array<char, beginning.size()> bytes = {};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  return std::string_view(bytes.data(), bytes.size()) == beginning;
}

std::string ask_text(const Database& database, const char* sql) {
  cli::Statement statement(database, sql);
  return statement.run() ? statement.text(0) : "";
}

}  // namespace

Journal::Journal(const std::string& path, const std::string& identity,
                 const std::vector<std::string>& names, Use use)
    : database_(path,
                use == Use::write ? Database::Use::write : Database::Use::read),
      use_(use),
      numbers_(names.size()) {
  if (use == Use::read) contact::detail::tell_reading(path);
  const std::string hash = fmt::format("{:016x}", hash_of(identity));
  try {
    if (use == Use::write) make(hash, names);
    check(hash, names);
  } catch (const cli::DatabaseError& error) {
    if (!error.is_stranger()) throw;
    fail(is_old(path) ? must_be("a journal of another version",
                                "removed, or another one named with --journal")
                      : must_be("the file", "a journal of hinge-study"));
  }
  has_.emplace(database_, "SELECT 1 FROM rows WHERE run = ?");
  at_.emplace(database_, "SELECT * FROM rows WHERE run = ?");
  if (use == Use::read) return;
  std::string places = "?";
  for (std::size_t i = 1; i < numbers_ + other_columns; ++i) places += ", ?";
  append_.emplace(database_,
                  "INSERT OR IGNORE INTO rows VALUES (" + places + ")");
}

// Open statements would keep SQLite from closing the file.
Journal::~Journal() {
  append_.reset();
  has_.reset();
  at_.reset();
  if (use_ == Use::write) database_.write_back();
}

void Journal::fail(const std::string& why) const {
  throw contact::Error(fmt::format("{}: {}", database_.name(), why));
}

// The first of several programs that open a new journal creates it.
void Journal::make(const std::string& hash,
                   const std::vector<std::string>& names) {
  if (numbers_ + other_columns > most_columns) {
    fail(must_be(fmt::format("{} inputs and quantities of a row", numbers_),
                 fmt::format("{} at most", most_columns - other_columns)));
  }
  if (database_.ask("SELECT count(*) FROM sqlite_master") == 0) {
    cli::Transaction transaction(database_);
    if (database_.ask("SELECT count(*) FROM sqlite_master") > 0) return;
    database_.run(fmt::format("PRAGMA application_id = {}", application));
    database_.run(fmt::format("PRAGMA user_version = {}", version));
    database_.run(study_table);
    cli::Statement(database_, "INSERT INTO study VALUES (?)").run(hash);
    database_.run(table_of(names));
    transaction.commit();
  }
}

// Another study has different columns.
void Journal::check(const std::string& hash,
                    const std::vector<std::string>& names) const {
  if (database_.ask("PRAGMA application_id") != application) {
    fail(must_be("the file", "a journal of hinge-study"));
  }
  if (database_.ask("PRAGMA user_version") == version &&
      database_.has_only({study_table, table_of(names)}) &&
      ask_text(database_, "SELECT identity FROM study") == hash) {
    if (use_ == Use::write) database_.write_ahead();
    return;
  }
  fail(must_be("the study of this journal",
               "the same, with the same files, seed and version; remove it or "
               "name another one with --journal"));
}

bool Journal::has(std::uint64_t run) const {
  const bool found = has_->run(as_integer(run));
  has_->begin();
  return found;
}

std::size_t Journal::size() const {
  return static_cast<std::size_t>(database_.ask("SELECT count(*) FROM rows"));
}

std::vector<std::uint64_t> Journal::missing(std::uint64_t first,
                                            std::uint64_t last) const {
  cli::Statement there(
      database_, "SELECT run FROM rows WHERE run BETWEEN ? AND ? ORDER BY run");
  std::vector<std::uint64_t> missing;
  std::uint64_t next = first;
  for (bool more = there.run(as_integer(first), as_integer(last)); more;
       more = there.next()) {
    const auto run = static_cast<std::uint64_t>(there.integer(0));
    for (; next < run; ++next) missing.push_back(next);
    next = run + 1;
  }
  for (; next <= last; ++next) missing.push_back(next);
  return missing;
}

void Journal::hold() const { database_.run("BEGIN"); }

void Journal::append(const Row& row) {
  append_->begin();
  int place = 0;
  append_->bind(++place, as_integer(row.run));
  for (const double number : row.numbers) append_->bind(++place, number);
  append_->bind(++place, row.failure.empty() ? "ok" : row.failure);
  append_->bind(++place, check_sum(row));
  append_->next();
}

void Journal::take(const Journal& from, std::uint64_t last) {
  cli::Transaction transaction(database_);
  for (std::uint64_t run = 0; run <= last; ++run) {
    if (from.has(run)) append(from.at(run));
  }
  transaction.commit();
}

Row Journal::at(std::uint64_t run) const {
  if (!at_->run(as_integer(run))) fail(fmt::format("run {} is missing", run));
  Row row{run, {}, std::vector<double>(numbers_)};
  int place = 0;
  for (double& number : row.numbers) number = at_->number(++place);
  row.failure = at_->text(++place);
  if (row.failure == "ok") row.failure.clear();
  const bool whole = at_->integer(++place) == check_sum(row);
  at_->begin();
  if (!whole) {
    fail(
        fmt::format("run {} is damaged: remove this journal, or bring it back "
                    "from a copy",
                    run));
  }
  return row;
}

}  // namespace study
