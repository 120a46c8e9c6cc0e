#include "programs/separation/output/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "cli/output.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "separation/results/cbor.hpp"
#include "separation/results/state_json.hpp"

namespace separation {
namespace {

using nlohmann::json;

using Notes = std::vector<Note>;

void add(const json& from, Notes& notes) {
  for (const Note& note : from.get<Notes>()) notes.push_back(note);
}

// A checkpoint without its rows.
json header_of(const std::string& file) {
  return unpacked(contact::detail::file_text(file), file);
}

// The file of a checkpoint's rows has the checkpoint's own name, so that both
// may be renamed.
std::string rows_name(const std::string& file, int number) {
  return fmt::format("{}.rows{}", file, number);
}

// The file that has the rows of a checkpoint.
std::string rows_in(const json& header, const std::string& file) {
  const int number = header.at("rows").at("number");
  if (number != 1 && number != 2) refuse_stranger(file);
  return rows_name(file, number);
}

// What the checkpoint of an earlier run keeps its rows in; "" for none.
std::string rows_of(const std::string& file) {
  if (!std::filesystem::exists(file)) return {};
  try {
    return rows_in(header_of(file), file);
  } catch (const json::exception&) {
    refuse_stranger(file);
  }
}

// Refuses a file of somebody else. What a run that was killed has left there
// may be replaced: of its first block perhaps the beginning alone.
void check_rows(const std::string& name) {
  namespace fs = std::filesystem;
  // An object of two in CBOR, of which "notes" comes first.
  constexpr std::string_view beginning = "\xa2\x65notes";
  std::error_code ignored;
  const fs::file_status status = fs::status(name, ignored);
  if (!fs::exists(status)) return;
  std::string there(beginning.size(), '\0');
  if (fs::is_regular_file(status)) {
    std::ifstream stream(name, std::ios::binary);
    stream.read(there.data(), static_cast<std::streamsize>(there.size()));
    there.resize(static_cast<std::size_t>(stream.gcount()));
  }
  if (beginning.starts_with(there)) return;
  throw contact::Error(fmt::format(
      "{}: not the rows of a checkpoint of hinge-separation", name));
}

std::string text_of_rows(const std::string& name, const std::string& file) {
  contact::detail::tell_reading(name);  // what it complains of is no bad copy
  try {
    return contact::detail::file_text(name);
  } catch (const contact::Error& error) {
    throw contact::Error(fmt::format(
        "{}; it has the rows of {}: the two are copied and renamed together",
        error.what(), file));
  }
}

// Adds the rows and notes of a file that a checkpoint refers to.
void add_rows(const std::string& file, const json& header,
              Recorder::Memory& memory) {
  const std::string name = rows_in(header, file);
  const json& rows = header.at("rows");
  std::string bytes = text_of_rows(name, file);
  const std::size_t size = rows.at("bytes");
  bytes.resize(std::min(bytes.size(), size));
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  if (bytes.size() != size || sum.checksum() != rows.at("sum")) {
    throw contact::Error(
        fmt::format("{}: damaged, or not the rows of {}", name, file));
  }
  std::string_view rest = bytes;
  long blocks = rows.at("blocks");
  for (; blocks > 0 && !rest.empty(); --blocks) {
    const auto block = take_cbor(rest);
    if (!block) refuse_stranger(name);
    const auto numbers = block->at("numbers").get<std::vector<double>>();
    memory.rows.numbers.insert(memory.rows.numbers.end(), numbers.begin(),
                               numbers.end());
    add(block->at("notes"), memory.notes);
  }
  if (blocks != 0 || !rest.empty()) refuse_stranger(name);
}

}  // namespace

std::vector<std::string> checkpoint_files(const std::string& file) {
  return {file, rows_name(file, 1), rows_name(file, 2),
          CheckpointLock::file_of(file)};
}

CheckpointWriter::CheckpointWriter(std::string file, std::string identity,
                                   double every)
    : file_(std::move(file)),
      lock_(file_),
      identity_(std::move(identity)),
      every_(every),
      old_rows_(rows_of(file_)),
      number_(old_rows_ == rows_name(file_, 1) ? 2 : 1),
      rows_(rows_name(file_, number_)) {
  check_rows(rows_);
  stream_.open(rows_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw contact::Error(
        fmt::format("cannot create {}: {}", rows_, std::strerror(errno)));
  }
}

CheckpointWriter::~CheckpointWriter() {
  std::error_code ignored;
  if (!written_) std::filesystem::remove(rows_, ignored);
}

// A hinge that turns back takes back a note of the same instant: those of now
// may still go.
void CheckpointWriter::append(const Recorder::Memory& memory, double time) {
  std::size_t notes = notes_;
  while (notes < memory.notes.size() && memory.notes[notes].time < time) {
    ++notes;
  }
  const auto& numbers = memory.rows.numbers;
  const auto note = memory.notes.begin();
  const auto bytes = json::to_cbor(
      {{"numbers", std::vector<double>(
                       numbers.begin() + static_cast<std::ptrdiff_t>(numbers_),
                       numbers.end())},
       {"notes", Notes(note + static_cast<std::ptrdiff_t>(notes_),
                       note + static_cast<std::ptrdiff_t>(notes))}});
  stream_.write(reinterpret_cast<const char*>(bytes.data()),
                static_cast<std::streamsize>(bytes.size()));
  stream_.flush();
  if (!stream_) {
    throw contact::Error(
        fmt::format("cannot write {}: {}", rows_, std::strerror(errno)));
  }
  sum_.process_bytes(bytes.data(), bytes.size());
  bytes_ += bytes.size();
  numbers_ = memory.rows.numbers.size();
  notes_ = notes;
  ++blocks_;
}

void CheckpointWriter::write(const SimulationState& simulation,
                             const Recorder::Memory& memory) {
  append(memory, simulation.motion.time);
  const json j = {{"identity", identity_},
                  {"every", every_},
                  {"simulation", simulation},
                  {"memory", memory},
                  {"columns", memory.rows.columns},
                  {"notes", Notes(memory.notes.begin() +
                                      static_cast<std::ptrdiff_t>(notes_),
                                  memory.notes.end())},
                  {"rows",
                   {{"number", number_},
                    {"blocks", blocks_},
                    {"bytes", bytes_},
                    {"sum", sum_.checksum()}}}};
  cli::Output output(file_, cli::Output::Renews::what_was_read);
  output.write(packed(j));
  output.commit();
  written_ = true;
  std::error_code ignored;
  if (!old_rows_.empty()) std::filesystem::remove(old_rows_, ignored);
  old_rows_.clear();
}

Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity) {
  try {
    const json j = header_of(file);
    check_identity(j, identity, file);
    Checkpoint result{j.at("every"), {j.at("simulation"), j.at("memory")}};
    Recorder::Memory& memory = result.state.memory;
    memory.rows.columns = j.at("columns");
    add_rows(file, j, memory);
    add(j.at("notes"), memory.notes);
    return result;
  } catch (const json::exception&) {
    refuse_stranger(file);
  }
}

}  // namespace separation
