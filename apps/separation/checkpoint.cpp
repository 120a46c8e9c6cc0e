#include "separation/checkpoint.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "libcontact/error.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* format_name = "hinge-separation checkpoint 1";

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
  const auto& [time, numbers, modes, directions, friction, straight_from,
               hinge_angles, step] = s;
  json words = json::array();
  for (const auto mode : modes) words.push_back(static_cast<int>(mode));
  return {{"time", time},
          {"numbers", numbers},
          {"modes", words},
          {"directions", vectors_json(directions)},
          {"friction", vectors_json(friction)},
          {"straight_from", straight_from},
          {"hinge_angles", hinge_angles},
          {"step", step}};
}
multibody::MotionState motion_from(const json& j) {
  multibody::MotionState s;
  auto& [time, numbers, modes, directions, friction, straight_from,
         hinge_angles, step] = s;
  time = j.at("time");
  numbers = j.at("numbers").get<std::vector<double>>();
  for (const int mode : j.at("modes")) {
    modes.push_back(static_cast<multibody::HingeMode>(mode));
  }
  directions = vectors_from(j.at("directions"));
  friction = vectors_from(j.at("friction"));
  straight_from = j.at("straight_from").get<std::vector<double>>();
  hinge_angles = j.at("hinge_angles").get<std::vector<double>>();
  step = j.at("step");
  return s;
}

json loads_json(const std::vector<LoadRecord>& loads) {
  json result = json::array();
  for (const LoadRecord& r : loads) {
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
std::vector<LoadRecord> loads_from(const json& j) {
  std::vector<LoadRecord> loads;
  for (const json& item : j) {
    LoadRecord& r = loads.emplace_back();
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
  return loads;
}

json memory_json(const Recorder::Memory& m) {
  json notes = json::array();
  for (const Note& note : m.notes) {
    notes.push_back({note.time, note.load, note.what});
  }
  json pairs = json::array();
  for (const PairRecord& p : m.pairs) {
    pairs.push_back({p.smallest, p.time, p.overlap_from, p.overlap_to});
  }
  return {{"columns", m.rows.columns},
          {"numbers", m.rows.numbers},
          {"loads", loads_json(m.loads)},
          {"notes", notes},
          {"pairs", pairs},
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
  m.rows.numbers = j.at("numbers").get<std::vector<double>>();
  m.loads = loads_from(j.at("loads"));
  for (const json& note : j.at("notes")) {
    m.notes.push_back({note.at(0), note.at(1), note.at(2)});
  }
  for (const json& item : j.at("pairs")) {
    const auto p = item.get<std::vector<double>>();
    m.pairs.push_back({p.at(0), p.at(1), p.at(2), p.at(3)});
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

}  // namespace

void write_checkpoint(const std::string& file, const Checkpoint& checkpoint) {
  const json j = {{"format", format_name},
                  {"identity", checkpoint.identity},
                  {"next_output", checkpoint.next_output},
                  {"motion", motion_json(checkpoint.simulation.motion)},
                  {"history", history_json(checkpoint.simulation.history)},
                  {"memory", memory_json(checkpoint.memory)}};
  const auto bytes = json::to_cbor(j);
  cli::Output output(file);
  output.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  output.commit();
}

Checkpoint read_checkpoint(const std::string& file,
                           const std::string& identity) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw contact::Error(file + ": cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  try {
    const json j = json::from_cbor(bytes);
    if (j.at("format") != format_name) throw contact::Error("of another kind");
    if (j.at("identity") != identity) {
      throw contact::Error(
          "of a run of another case file or with other options");
    }
    return {identity,
            j.at("next_output").get<long>(),
            {motion_from(j.at("motion")), history_from(j.at("history"))},
            memory_from(j.at("memory"))};
  } catch (const json::exception&) {
    throw contact::Error(file + ": not a checkpoint of hinge-separation");
  } catch (const contact::Error& error) {
    throw contact::Error(
        fmt::format("{}: a checkpoint {}", file, error.what()));
  }
}

}  // namespace separation
