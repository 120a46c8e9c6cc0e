#include "separation/record/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/file_text.hpp"
#include "cli/output.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

// What goes into a checkpoint, there and back.
template <>
struct nlohmann::adl_serializer<Eigen::Vector3d> {
  static void to_json(json& j, const Eigen::Vector3d& v) {
    j = {v.x(), v.y(), v.z()};
  }
  static void from_json(const json& j, Eigen::Vector3d& v) {
    v = Eigen::Vector3d(j.at(0), j.at(1), j.at(2));
  }
};

namespace multibody {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionState, time, numbers, modes,
                                   directions, friction, straight_from, paces,
                                   hinge_angles, step)
}  // namespace multibody

namespace separation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(History, events, spent)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SimulationState, motion, history)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointPeaks, reaction, reaction_time,
                                   pressure, half_angle, moment)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyRecord::Release, time, angle, rate,
                                   rates, velocity)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyRecord, peak_reaction,
                                   peak_reaction_time, peak_lock,
                                   peak_lock_time, work, rest_time, joints,
                                   release)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Note, time, body, what)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PairRecord, smallest, time, overlap_from,
                                   overlap_to, not_found)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ForceRecord, on, acted, fault, fault_time)
// Without rows and notes, which have a file of their own.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Recorder::Memory, bodies, pairs, forces,
                                   modes, last_time, first_balance,
                                   largest_drift, largest_energy, begun)

namespace {

using nlohmann::json;

constexpr const char* program_format = "hinge-separation checkpoint ";
constexpr const char* format_name = "hinge-separation checkpoint 8";

using Notes = std::vector<Note>;

void add(const json& from, Notes& notes) {
  for (const Note& note : from.get<Notes>()) notes.push_back(note);
}

constexpr std::size_t sum_size = 8;  // in hexadecimal digits

bool contains(std::string_view bytes, std::string_view text) {
  return bytes.find(text) != bytes.npos;
}

std::string check_sum(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("{:08x}", sum.checksum());
}

// The format's name is there twice, as the first line and in the header: a
// damaged file is still told from one that is something else.
std::string file_of(json header) {
  header["format"] = format_name;
  std::string bytes = fmt::format("{}\n", format_name);
  json::to_cbor(header, bytes);
  return bytes + check_sum(bytes);
}

// A checkpoint without its rows.
json header_of(const std::string& file) {
  const std::string bytes = cli::file_text(file);
  if (!contains(bytes, program_format)) {
    throw contact::Error(file + ": not a checkpoint of hinge-separation");
  }
  if (!contains(bytes, format_name)) {
    throw contact::Error(contact::detail::must_be(
        file + ": a checkpoint of another version of hinge-separation",
        fmt::format("\"{}\"", format_name)));
  }
  const std::size_t size = bytes.size() - sum_size;
  const std::string sum = check_sum(std::string_view(bytes).substr(0, size));
  const std::string written = bytes.substr(size);
  if (sum != written) {
    throw contact::Error(
        fmt::format("{}: damaged: check sum {}, the file says {}", file, sum,
                    contact::detail::printable(written)));
  }
  const std::size_t begin = bytes.find('\n') + 1;
  return json::from_cbor(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                         bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

// The file of a checkpoint's rows has the checkpoint's own name, so that both
// may be renamed.
std::string rows_name(const std::string& file, int number) {
  return fmt::format("{}.rows{}", file, number);
}

// What the checkpoint of an earlier run keeps its rows in; "" for none.
std::string rows_of(const std::string& file) {
  if (!std::filesystem::exists(file)) return {};
  return rows_name(file, header_of(file).at("rows").at("number"));
}

std::string text_of_rows(const std::string& name, const std::string& file) {
  try {
    return cli::file_text(name);
  } catch (const contact::Error& error) {
    throw contact::Error(fmt::format(
        "{}; it has the rows of {}: the two are copied and renamed together",
        error.what(), file));
  }
}

// Adds the rows and notes of a file that a checkpoint refers to.
void add_rows(const std::string& file, const json& header,
              Recorder::Memory& memory) {
  const json& rows = header.at("rows");
  const std::string name = rows_name(file, rows.at("number"));
  std::string bytes = text_of_rows(name, file);
  const std::size_t size = rows.at("bytes");
  bytes.resize(std::min(bytes.size(), size));
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  if (bytes.size() != size || sum.checksum() != rows.at("sum")) {
    throw contact::Error(
        fmt::format("{}: damaged, or not the rows of {}", name, file));
  }
  std::istringstream stream(bytes);
  for (long block = rows.at("blocks"); block > 0; --block) {
    const json j = json::from_cbor(stream, false);
    const auto numbers = j.at("numbers").get<std::vector<double>>();
    memory.rows.numbers.insert(memory.rows.numbers.end(), numbers.begin(),
                               numbers.end());
    add(j.at("notes"), memory.notes);
  }
}

}  // namespace

CheckpointWriter::CheckpointWriter(std::string file, std::string identity,
                                   double every)
    : file_(std::move(file)),
      identity_(std::move(identity)),
      every_(every),
      old_rows_(rows_of(file_)),
      number_(old_rows_ == rows_name(file_, 1) ? 2 : 1),
      rows_(rows_name(file_, number_)) {
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
  cli::Output output(file_);
  output.write(file_of(j));
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
    if (j.at("identity") != identity) {
      throw contact::Error(
          file +
          ": a checkpoint of a run of another case file, other "
          "joints or other options");
    }
    Checkpoint result{j.at("every"), {j.at("simulation"), j.at("memory")}};
    Recorder::Memory& memory = result.state.memory;
    memory.rows.columns = j.at("columns");
    add_rows(file, j, memory);
    add(j.at("notes"), memory.notes);
    return result;
  } catch (const json::exception&) {
    throw contact::Error(file + ": not a checkpoint of hinge-separation");
  }
}

}  // namespace separation
