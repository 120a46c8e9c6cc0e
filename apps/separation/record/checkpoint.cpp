#include "separation/record/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/file_text.hpp"
#include "cli/output.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* program_format = "hinge-separation checkpoint ";
constexpr const char* format_name = "hinge-separation checkpoint 7";

json vectors_json(const std::vector<Vector3d>& vectors) {
  json numbers = json::array();
  for (const Vector3d& v : vectors) {
    for (const double x : v) numbers.push_back(x);
  }
  return numbers;
}
std::vector<Vector3d> vectors_from(const json& numbers) {
  std::vector<Vector3d> vectors;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    vectors.emplace_back(numbers[i].get<double>(), numbers[i + 1].get<double>(),
                         numbers[i + 2].get<double>());
  }
  return vectors;
}

// By structured bindings, so that what is new in the state is not forgotten.
json motion_json(const multibody::MotionState& s) {
  const auto& [time, numbers, modes, directions, friction, straight_from, paces,
               hinge_angles, step] = s;
  json words = json::array();
  for (const auto mode : modes) words.push_back(static_cast<int>(mode));
  return {{"time", time},
          {"numbers", numbers},
          {"modes", words},
          {"directions", vectors_json(directions)},
          {"friction", vectors_json(friction)},
          {"straight_from", straight_from},
          {"paces", paces},
          {"hinge_angles", hinge_angles},
          {"step", step}};
}
multibody::MotionState motion_from(const json& j) {
  multibody::MotionState s;
  auto& [time, numbers, modes, directions, friction, straight_from, paces,
         hinge_angles, step] = s;
  time = j.at("time");
  numbers = j.at("numbers").get<std::vector<double>>();
  for (const int mode : j.at("modes")) {
    modes.push_back(static_cast<multibody::HingeMode>(mode));
  }
  directions = vectors_from(j.at("directions"));
  friction = vectors_from(j.at("friction"));
  straight_from = j.at("straight_from").get<std::vector<double>>();
  paces = j.at("paces").get<std::vector<double>>();
  hinge_angles = j.at("hinge_angles").get<std::vector<double>>();
  step = j.at("step");
  return s;
}

json bodies_json(const std::vector<BodyRecord>& bodies) {
  json result = json::array();
  for (const BodyRecord& r : bodies) {
    json joints = json::array();
    for (const JointPeaks& p : r.joints) {
      joints.push_back(
          {p.reaction, p.reaction_time, p.pressure, p.half_angle, p.moment});
    }
    const auto& release = r.release;
    result.push_back(
        {{"peaks",
          {r.peak_reaction, r.peak_reaction_time, r.peak_lock, r.peak_lock_time,
           r.work, r.rest_time}},
         {"joints", joints},
         {"release", {release.time, release.angle, release.rate}},
         {"release_vectors", vectors_json({release.rates, release.velocity})}});
  }
  return result;
}
std::vector<BodyRecord> bodies_from(const json& j) {
  std::vector<BodyRecord> bodies;
  for (const json& item : j) {
    BodyRecord& r = bodies.emplace_back();
    const auto peaks = item.at("peaks").get<std::vector<double>>();
    r.peak_reaction = peaks.at(0);
    r.peak_reaction_time = peaks.at(1);
    r.peak_lock = peaks.at(2);
    r.peak_lock_time = peaks.at(3);
    r.work = peaks.at(4);
    r.rest_time = peaks.at(5);
    for (const json& joint : item.at("joints")) {
      const auto p = joint.get<std::vector<double>>();
      r.joints.push_back({p.at(0), p.at(1), p.at(2), p.at(3), p.at(4)});
    }
    const auto release = item.at("release").get<std::vector<double>>();
    const auto vectors = vectors_from(item.at("release_vectors"));
    r.release = {release.at(0), release.at(1), release.at(2), vectors.at(0),
                 vectors.at(1)};
  }
  return bodies;
}

json notes_json(std::span<const Note> notes) {
  json result = json::array();
  for (const Note& note : notes) {
    result.push_back({note.time, note.body, note.what});
  }
  return result;
}
void add_notes(const json& from, std::vector<Note>& notes) {
  for (const json& note : from) {
    notes.push_back({note.at(0), note.at(1), note.at(2)});
  }
}

// Without rows, and with the notes from `notes` on.
json memory_json(const Recorder::Memory& m, std::size_t notes) {
  json pairs = json::array();
  for (const PairRecord& p : m.pairs) {
    pairs.push_back(
        {p.smallest, p.time, p.overlap_from, p.overlap_to, p.not_found});
  }
  json forces = json::array();
  for (const ForceRecord& f : m.forces) {
    forces.push_back({f.on, f.acted, static_cast<int>(f.fault), f.fault_time});
  }
  return {{"columns", m.rows.columns},
          {"bodies", bodies_json(m.bodies)},
          {"notes", notes_json(std::span(m.notes).subspan(notes))},
          {"pairs", pairs},
          {"forces", forces},
          {"modes", m.modes},
          {"last_time", m.last_time},
          {"first_balance", m.first_balance},
          {"largest_drift", m.largest_drift},
          {"largest_energy", m.largest_energy},
          {"begun", m.begun}};
}
Recorder::Memory memory_from(const json& j) {
  Recorder::Memory m;
  m.rows.columns = j.at("columns").get<std::vector<std::string>>();
  m.bodies = bodies_from(j.at("bodies"));
  for (const json& item : j.at("pairs")) {
    const auto p = item.get<std::vector<double>>();
    m.pairs.push_back(
        {p.at(0), p.at(1), p.at(2), p.at(3), static_cast<long>(p.at(4))});
  }
  for (const json& f : j.at("forces")) {
    m.forces.push_back({f.at(0).get<bool>(), f.at(1).get<bool>(),
                        static_cast<ForceRecord::Fault>(f.at(2).get<int>()),
                        f.at(3).get<double>()});
  }
  m.modes = j.at("modes").get<std::vector<int>>();
  m.last_time = j.at("last_time");
  m.first_balance = j.at("first_balance");
  m.largest_drift = j.at("largest_drift");
  m.largest_energy = j.at("largest_energy");
  m.begun = j.at("begun");
  return m;
}

// The history begins as that of any case; only its numbers are in the file.
json history_json(const History& history) {
  return {
      {"events", history.events},
      {"spent", std::vector<int>(history.spent.begin(), history.spent.end())}};
}
History history_from(const json& j) {
  History history;
  history.events = j.at("events").get<std::vector<std::vector<double>>>();
  for (const int spent : j.at("spent")) {
    history.spent.push_back(static_cast<char>(spent));
  }
  return history;
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
    for (const json& number : j.at("numbers")) {
      memory.rows.numbers.push_back(number);
    }
    add_notes(j.at("notes"), memory.notes);
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
  json numbers = json::array();
  for (std::size_t i = numbers_; i < memory.rows.numbers.size(); ++i) {
    numbers.push_back(memory.rows.numbers[i]);
  }
  const auto bytes = json::to_cbor(
      {{"numbers", std::move(numbers)},
       {"notes",
        notes_json(std::span(memory.notes).subspan(notes_, notes - notes_))}});
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

void CheckpointWriter::write(long next_output,
                             const SimulationState& simulation,
                             const Recorder::Memory& memory) {
  append(memory, simulation.motion.time);
  const json j = {{"identity", identity_},
                  {"next_output", next_output},
                  {"every", every_},
                  {"motion", motion_json(simulation.motion)},
                  {"history", history_json(simulation.history)},
                  {"memory", memory_json(memory, notes_)},
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
    Checkpoint result{
        j.at("next_output").get<long>(),
        j.at("every").get<double>(),
        {motion_from(j.at("motion")), history_from(j.at("history"))},
        memory_from(j.at("memory"))};
    add_rows(file, j, result.memory);
    add_notes(j.at("memory").at("notes"), result.memory.notes);
    return result;
  } catch (const json::exception&) {
    throw contact::Error(file + ": not a checkpoint of hinge-separation");
  }
}

}  // namespace separation
