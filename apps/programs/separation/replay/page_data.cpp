#include "programs/separation/replay/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "libcontact/base/units.hpp"
#include "libcontact/pressure/law.hpp"
#include "libcontact/version.hpp"
#include "programs/separation/replay/motion.hpp"
#include "programs/separation/replay/scene.hpp"
#include "programs/separation/replay/shown_forces.hpp"
#include "separation/case/force_law.hpp"
#include "separation/clearance/clearance.hpp"
#include "separation/results/summary.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::HingeKind;
using nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned block = 0;
    for (std::size_t j = i; j < i + 3; ++j) {
      block = block << 8 |
              (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    }
    for (const int shift : {18, 12, 6, 0}) {
      result += digits[block >> shift & 63U];
    }
  }
  for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) {
    result[result.size() - 1 - i] = '=';
  }
  return result;
}

template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  return base64({reinterpret_cast<const char*>(numbers.data()),
                 numbers.size() * sizeof(Number)});
}

ordered_json xyz(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// Pressures relative to the peak, from the centre of the contact to its edge,
// for several half-angles.
ordered_json contact_json(const contact::PressureLaw& law) {
  ordered_json j;
  constexpr int places = 12;
  for (int degrees = 10; degrees <= 180; degrees += 10) {
    const double theta0 = degrees * contact::degree;
    if (theta0 > law.largest_half_angle()) break;
    j["half_angles_deg"].push_back(degrees);
    ordered_json shares;
    for (int i = 0; i <= places; ++i) {
      const double share =
          law.pressure(theta0 * i / places, theta0) / law.peak(theta0);
      shares.push_back(std::round(1e3 * share) / 1e3);
    }
    j["shares"].push_back(std::move(shares));
  }
  return j;
}

ordered_json body_json(const Case& c, int i) {
  ordered_json j = {{"name", c.rigid_body(i).name},
                    {"column", column_name(c.rigid_body(i).name)},
                    {"colour", colour_of(i)}};
  if (i == 0) return j;
  const Body& body = c.bodies[i - 1];
  if (body.hinge.kind == HingeKind::none) return j;
  j["hinge"] = {{"on", body.hinge.on}, {"point", xyz(body.hinge.body_point)}};
  if (body.hinge.kind == HingeKind::axis) {
    j["hinge"]["axis"] = xyz(body.hinge.axis);
  }
  if (!body.hinge.joints.empty()) {
    const auto inner =
        body.hinge.joints.front().contact().geometry().inner_body();
    j["hinge"]["inner"] =
        inner == contact::JointBody::carrier ? "carrier" : "body";
    j["hinge"]["contact"] =
        contact_json(body.hinge.joints.front().contact().pressure_law());
  }
  if (body.lock) j["lock"] = {{"point", xyz(body.lock->body_point)}};
  return j;
}

ordered_json force_json(const Case& c, const Force& force) {
  const ForceEnds ends = force.law->where(c, force.body);
  ordered_json j = {
      {"name", force.name}, {"body", force.body}, {"point", xyz(ends.point)}};
  if (ends.other >= 0) {
    j["other"] = ends.other;
    j["other_point"] = xyz(ends.other_point);
  }
  if (!ends.exhaust.isZero()) j["exhaust"] = xyz(ends.exhaust);
  return j;
}

// True for columns that the page draws; the glTF has the motion. Components of
// a lock's reaction are 0 without a lock.
bool is_shown(const Case& c, const std::string& column) {
  const auto point = column.rfind('.');
  const auto quantity = column.substr(point + 1);
  if (quantity.starts_with("lock_reaction_") && quantity != "lock_reaction_N") {
    return std::ranges::any_of(c.bodies, [&](const Body& body) {
      return body.lock &&
             column_name(body.rigid.name) == column.substr(0, point);
    });
  }
  for (const char* start :
       {"qw", "qx", "qy", "qz", "x_m", "y_m", "z_m", "vx_", "vy_", "vz_", "wx_",
        "wy_", "wz_", "time_", "acceleration_"}) {
    if (quantity.starts_with(start)) return false;
  }
  return true;
}

std::vector<float> column_of(const Take& take, std::size_t column) {
  std::vector<float> values;
  for (const std::size_t row : take.kept) {
    values.push_back(static_cast<float>(take.rows->at(row, column)));
  }
  return values;
}

// Nearest points of the nearest two bodies, for each row: the number of the
// pair, and the points in the axes of the two.
std::string nearest_points(const Case& c, const Take& take) {
  std::vector<std::size_t> columns;
  for (const Case::Pair& pair : c.clearance) {
    columns.push_back(take.rows->column(clearance_column(c, pair) + "_m"));
  }
  std::vector<BodyPath> paths;
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    paths.emplace_back(c, *take.rows, take.kept, i);
  }
  const Clearance clearance = clearance_of(c);
  std::vector<multibody::BodyMotion> bodies(paths.size());
  std::vector<float> result;
  std::size_t place = 0;
  for (const std::size_t row : take.kept) {
    if (take.rows->at(row, 0) > paths[0].time(static_cast<double>(place))) {
      ++place;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      const double least = take.rows->at(row, columns[nearest]);
      if (std::isnan(least) || take.rows->at(row, columns[i]) < least) {
        nearest = i;
      }
    }
    // A clearance is not watched outside its time window.
    const bool known = !std::isnan(take.rows->at(row, columns[nearest]));
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Pose pose = paths[i].pose(static_cast<double>(place));
      bodies[i].position = pose.position;
      bodies[i].rotation = pose.rotation.toRotationMatrix();
    }
    const auto points =
        known ? clearance.nearest_points(bodies, nearest) : std::nullopt;
    const Clearance::Pair& pair = clearance.pairs()[nearest];
    result.push_back(points ? static_cast<float>(nearest) : -1);
    for (const bool first : {true, false}) {
      const auto& body = bodies[first ? pair.a : pair.b];
      const Vector3d point =
          !points ? Vector3d::Zero()
                  : Vector3d(body.rotation.transpose() *
                             ((first ? points->first : points->second) -
                              body.position));
      for (const double x : point) result.push_back(static_cast<float>(x));
    }
  }
  return base64(result);
}

ordered_json take_json(const ShownRun& run, const Take& take) {
  const Case& c = *take.of;
  const auto& names = take.rows->columns;
  std::vector<double> times;
  for (const std::size_t row : take.kept)
    times.push_back(take.rows->at(row, 0));
  ordered_json j = {{"name", run.name},
                    {"friction", to_string(run.outcome->friction)},
                    {"time", base64(times)}};
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (is_shown(c, names[i]))
      j["columns"][names[i]] = base64(column_of(take, i));
  }
  const bool has_distances = std::ranges::any_of(
      names, [](const auto& name) { return name.starts_with("clearance."); });
  if (has_distances) j["nearest"] = nearest_points(c, take);
  // Only forces of the first take are drawn.
  if (!take.faint && !c.forces.empty()) {
    j["forces"] = base64(shown_forces(take, run.outcome->history));
  }
  j["summary"] = summary(c, *run.outcome);
  return j;
}

}  // namespace

std::string page_data(const Replay& replay, int every) {
  const Case& c = replay.c;
  const std::vector<Take> takes = takes_of(replay, every);
  const Scene scene = make_scene(takes, every);
  ordered_json j = {{"program", fmt::format("hinge-separation (libcontact) {}",
                                            contact::version)},
                    {"size", scene.size},
                    {"every", every}};
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    j["bodies"].push_back(body_json(c, i));
  }
  j["gravity"] = xyz(c.options.gravity);
  j["forces"] = ordered_json::array();
  for (const Force& force : c.forces)
    j["forces"].push_back(force_json(c, force));
  j["pairs"] = ordered_json::array();
  for (const WatchedPair& p : c.clearance) j["pairs"].push_back({p.a, p.b});
  for (std::size_t i = 0; i < takes.size(); ++i) {
    j["takes"].push_back(take_json(replay.runs[i], takes[i]));
  }
  j["warnings"] = replay.warnings;
  j["case"] = replay.case_text;
  j["nodes"] = scene.nodes;
  j["glb"] = base64(scene.glb);
  const std::string text =
      j.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
  std::string result;
  for (const char character : text) {
    if (character == '<') {
      result += "\\u003c";  // cannot end an element
    } else {
      result += character;
    }
  }
  return result;
}

}  // namespace separation
