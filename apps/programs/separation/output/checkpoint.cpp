#include "programs/separation/output/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "separation/results/cbor.hpp"
#include "separation/results/state_json.hpp"

namespace separation {
namespace {

using cli::Database;
using nlohmann::json;

using Notes = std::vector<Note>;

// Application id in SQLite's header for this kind of file.
constexpr int application = 0x6873636b;
constexpr const char* state_table = "CREATE TABLE state (state)";
constexpr const char* block_table =
    "CREATE TABLE blocks (number INTEGER PRIMARY KEY, block)";

void add(const json& from, Notes& notes) {
  for (const Note& note : from.get<Notes>()) notes.push_back(note);
}

// Rejects files of another program or another version, and modified ones.
void check_application(const Database& database) {
  try {
    if (database.ask("PRAGMA application_id") == application &&
        database.has_only({state_table, block_table})) {
      return;
    }
  } catch (const cli::DatabaseError& error) {
    if (!error.is_stranger()) throw;
    unpacked(contact::detail::file_text(database.name()), database.name());
  }
  refuse_stranger(database.name());
}

// Rows and notes from a place on that no longer change.
json block_of(const Recorder::Memory& memory, std::size_t numbers,
              std::size_t notes, std::size_t notes_end) {
  const auto place = [](const auto& of, std::size_t i) {
    return of.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto& all = memory.rows.numbers;
  return {{"numbers", std::vector<double>(place(all, numbers), all.end())},
          {"notes",
           Notes(place(memory.notes, notes), place(memory.notes, notes_end))}};
}

void add_blocks(const Database& database, std::int64_t count,
                Recorder::Memory& memory) {
  cli::Statement blocks(database, "SELECT block FROM blocks ORDER BY number");
  for (bool more = blocks.run(); more && count >= 0;
       more = blocks.next(), --count) {
    const json block = unpacked(blocks.text(0), database.name());
    const auto numbers = block.at("numbers").get<std::vector<double>>();
    memory.rows.numbers.insert(memory.rows.numbers.end(), numbers.begin(),
                               numbers.end());
    add(block.at("notes"), memory.notes);
  }
  if (count != 0) refuse_stranger(database.name());
}

}  // namespace

std::array<std::string, 2> checkpoint_files(const std::string& file) {
  return {file, file + "-journal"};
}

FileLock::FileLock(const std::string& file)
    : file_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) {
    throw contact::Error(
        fmt::format("cannot create {}: {}", file, std::strerror(errno)));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw contact::Error(
      fmt::format("{}: another program writes to this checkpoint", file));
}

FileLock::~FileLock() { close(file_); }

bool FileLock::is_empty() const {
  struct stat status = {};
  return fstat(file_, &status) == 0 && status.st_size == 0;
}

CheckpointWriter::CheckpointWriter(const std::string& file,
                                   std::string identity, double every)
    : lock_(file),
      database_(file, Database::Use::write),
      identity_(std::move(identity)),
      every_(every) {
  if (!lock_.is_empty()) check_application(database_);
  database_.run("PRAGMA synchronous = NORMAL");
}

CheckpointWriter::~CheckpointWriter() {
  std::error_code ignored;
  if (lock_.is_empty()) std::filesystem::remove(database_.name(), ignored);
}

// A hinge that reverses removes a note of the same instant, so that notes of
// the present time are not final.
void CheckpointWriter::write(const SimulationState& simulation,
                             const Recorder::Memory& memory) {
  std::size_t notes = notes_;
  while (notes < memory.notes.size() &&
         memory.notes[notes].time < simulation.motion.time) {
    ++notes;
  }
  cli::Transaction transaction(database_);
  if (blocks_ == 0) {
    database_.run(
        fmt::format("PRAGMA application_id = {}; DROP TABLE IF EXISTS state; "
                    "DROP TABLE IF EXISTS blocks; {}; {}",
                    application, state_table, block_table));
  }
  const auto put = [&](const char* sql, json content) {
    cli::Statement statement(database_, sql);
    statement.bind_bytes(1, packed(std::move(content)));
    statement.next();
  };
  put("INSERT INTO blocks (block) VALUES (?)",
      block_of(memory, numbers_, notes_, notes));
  database_.run("DELETE FROM state");
  put("INSERT INTO state VALUES (?)",
      {{"identity", identity_},
       {"every", every_},
       {"simulation", simulation},
       {"memory", memory},
       {"columns", memory.rows.columns},
       {"notes",
        Notes(memory.notes.begin() + static_cast<std::ptrdiff_t>(notes),
              memory.notes.end())},
       {"blocks", blocks_ + 1}});
  transaction.commit();
  numbers_ = memory.rows.numbers.size();
  notes_ = notes;
  ++blocks_;
}

Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity) {
  contact::detail::tell_reading(file);
  const Database database(file, Database::Use::read);
  check_application(database);
  try {
    cli::Statement state(database, "SELECT state FROM state");
    if (!state.run()) refuse_stranger(file);
    const json j = unpacked(state.text(0), file);
    check_identity(j, identity, file);
    Checkpoint result{j.at("every"), {j.at("simulation"), j.at("memory")}};
    Recorder::Memory& memory = result.state.memory;
    memory.rows.columns = j.at("columns");
    add_blocks(database, j.at("blocks"), memory);
    add(j.at("notes"), memory.notes);
    return result;
  } catch (const json::exception&) {
    refuse_stranger(file);
  }
}

}  // namespace separation
