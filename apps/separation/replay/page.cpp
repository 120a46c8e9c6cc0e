#include "separation/replay/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/file_text.hpp"
#include "cli/refuse.hpp"
#include "libcontact/version.hpp"
#include "separation/output/file_name.hpp"
#include "separation/output/summary.hpp"
#include "separation/replay/page_files.hpp"
#include "separation/replay/scene.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::HingeKind;
using nlohmann::ordered_json;

std::string find_script(const std::string& wanted, const std::string& name) {
  const char* folders = std::getenv("XDG_DATA_DIRS");
  std::istringstream list(folders != nullptr && *folders != '\0'
                              ? folders
                              : "/usr/local/share:/usr/share");
  for (std::string folder; std::getline(list, folder, ':');) {
    const std::filesystem::path path =
        std::filesystem::path(folder) / "javascript" / name;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
      return cli::file_text(path.string());
    }
  }
  cli::refuse_without(wanted, "three.js and dygraphs (" + name +
                                  " is missing): apt install libjs-three "
                                  "libjs-dygraphs");
}

// Every {{name}} of a text; what is put in is not looked at again.
std::string fill(std::string_view text,
                 const std::function<std::string_view(std::string_view)>& of) {
  std::string result;
  for (;;) {
    const std::size_t open = text.find("{{");
    result += text.substr(0, open);
    if (open == std::string_view::npos) return result;
    const std::size_t close = text.find("}}", open);
    result += of(text.substr(open + 2, close - open - 2));
    text.remove_prefix(close + 2);
  }
}

// Of the content, so that the same run gives the same page: whoever wants to
// put a script into a case's text would have to know it.
std::string nonce_of(const std::string& content) {
  return fmt::format("{:016x}", std::hash<std::string>{}(content));
}

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

ordered_json numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

ordered_json body_json(const Case& c, int i) {
  ordered_json j = {{"name", c.rigid_body(i).name},
                    {"column", column_name(c.rigid_body(i).name)},
                    {"colour", colour_of(i)}};
  if (i == 0) return j;
  const Body& body = c.bodies[i - 1];
  if (body.hinge.kind == HingeKind::none) return j;
  j["hinge"] = {{"point", numbers(body.hinge.body_point)}};
  if (body.hinge.kind == HingeKind::axis) {
    j["hinge"]["axis"] = numbers(body.hinge.axis);
  }
  if (!body.hinge.joints.empty()) {
    const auto inner =
        body.hinge.joints.front().contact.geometry().inner_body();
    j["hinge"]["inner"] =
        inner == contact::JointBody::carrier ? "carrier" : "body";
  }
  j["lock"] = body.lock.has_value();
  return j;
}

// What the page draws; the glTF has the motion.
bool is_shown(const std::string& column) {
  const auto quantity = column.substr(column.rfind('.') + 1);
  for (const char* start :
       {"qw", "qx", "qy", "qz", "x_m", "y_m", "z_m", "vx_", "vy_", "vz_", "wx_",
        "wy_", "wz_", "time_", "acceleration_", "lock_reaction_x",
        "lock_reaction_y", "lock_reaction_z"}) {
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

// Where the nearest two bodies are nearest to each other, of each row: the
// number of the pair, and the points in the axes of the two.
std::string nearest_points(const Case& c, const Take& take) {
  std::vector<std::size_t> columns;
  for (const auto& [a, b] : c.clearance) {
    columns.push_back(take.rows->column(
        fmt::format("clearance.{}.{}_m", column_name(c.rigid_body(a).name),
                    column_name(c.rigid_body(b).name))));
  }
  std::vector<std::vector<Shape>> shapes;
  std::vector<BodyPath> paths;
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    shapes.push_back(c.rigid_body(i).shapes);
    paths.emplace_back(c, *take.rows, take.kept, i);
  }
  std::vector<Clearance::Pair> pairs;
  for (const auto& [a, b] : c.clearance) pairs.push_back({a, b});
  Clearance clearance(shapes, pairs);
  std::vector<multibody::BodyMotion> bodies(paths.size());
  std::vector<float> result;
  std::size_t place = 0;
  for (const std::size_t row : take.kept) {
    if (take.rows->at(row, 0) > paths[0].time(static_cast<double>(place))) {
      ++place;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < columns.size(); ++i) {
      if (take.rows->at(row, columns[i]) < take.rows->at(row, columns[nearest]))
        nearest = i;
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const Pose pose = paths[i].pose(static_cast<double>(place));
      bodies[i].position = pose.position;
      bodies[i].rotation = pose.rotation.toRotationMatrix();
    }
    const auto points = clearance.nearest_points(bodies, nearest);
    result.push_back(points ? static_cast<float>(nearest) : -1);
    for (const bool first : {true, false}) {
      const auto& body = bodies[first ? pairs[nearest].a : pairs[nearest].b];
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

ordered_json take_json(const Replay& replay, const ShownRun& run,
                       const Take& take) {
  const Case& c = replay.c;
  const auto& names = take.rows->columns;
  std::vector<double> times;
  for (const std::size_t row : take.kept)
    times.push_back(take.rows->at(row, 0));
  ordered_json j = {{"name", to_string(run.outcome->friction)},
                    {"time", base64(times)}};
  for (std::size_t i = 1; i < names.size(); ++i) {
    if (is_shown(names[i])) j["columns"][names[i]] = base64(column_of(take, i));
  }
  if (!c.clearance.empty() &&
      names[names.size() - 6].starts_with("clearance.")) {
    j["nearest"] = nearest_points(c, take);
  }
  j["summary"] = summary(c, *run.outcome);
  return j;
}

std::vector<Take> takes_of(const Replay& replay, int every) {
  std::vector<Take> takes;
  for (const ShownRun& run : replay.runs) {
    const Rows& rows = run.outcome->memory.rows;
    takes.push_back(
        {run.name, !takes.empty(), &rows, replay_rows(rows, every)});
  }
  return takes;
}

// A text that a script element may hold.
std::string data_of(const Replay& replay, int every) {
  const Case& c = replay.c;
  const std::vector<Take> takes = takes_of(replay, every);
  const Scene scene = make_scene(c, takes, every);
  ordered_json j = {{"program", fmt::format("hinge-separation (libcontact) {}",
                                            contact::version)},
                    {"size", scene.size},
                    {"every", every}};
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    j["bodies"].push_back(body_json(c, i));
  }
  j["pairs"] = ordered_json::array();
  for (const auto& [a, b] : c.clearance) j["pairs"].push_back({a, b});
  for (std::size_t i = 0; i < takes.size(); ++i) {
    j["takes"].push_back(take_json(replay, replay.runs[i], takes[i]));
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
      result += "\\u003c";  // of no end of the element
    } else {
      result += character;
    }
  }
  return result;
}

}  // namespace

std::string in_markup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '&':
        result += "&amp;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string still_page(const std::string& title, const std::string& body) {
  const std::string nonce = nonce_of(body);
  const std::string safe_title = in_markup(title);
  return fill(page_head,
              [&](std::string_view name) -> std::string_view {
                if (name == "nonce") return nonce;
                if (name == "title") return safe_title;
                return page_style;
              }) +
         body + "</body>\n</html>\n";
}

PageParts::PageParts(const std::string& wanted) {
  for (const char* name :
       {"three/three.min.js", "three/examples/js/loaders/GLTFLoader.js",
        "three/examples/js/controls/OrbitControls.js",
        "dygraphs/dygraph.min.js"}) {
    scripts_ += find_script(wanted, name) + '\n';
  }
  scripts_ += page_script;
  style_ = find_script(wanted, "dygraphs/dygraph.min.css") + '\n';
  style_ += page_style;
}

std::string PageParts::page(const std::string& title,
                            const std::string& data) const {
  const std::string nonce = nonce_of(data);
  const std::string safe_title = in_markup(title);
  const auto part = [&](std::string_view name) -> std::string_view {
    if (name == "nonce") return nonce;
    if (name == "title") return safe_title;
    if (name == "style") return style_;
    if (name == "scripts") return scripts_;
    return data;
  };
  return fill(page_head, part) + fill(page_body, part);
}

std::string replay_glb(const Replay& replay) {
  return make_scene(replay.c, takes_of(replay, 1), 1).glb;
}

Page replay_page(const Replay& replay, const PageParts& parts,
                 std::size_t most) {
  for (int every = 1;; every *= 2) {
    std::string text = parts.page(replay.c.name, data_of(replay, every));
    const std::size_t rows = replay.runs.front().outcome->memory.rows.size();
    if (text.size() <= most || static_cast<std::size_t>(every) > rows) {
      return {std::move(text), every};
    }
  }
}

std::vector<std::string> replay_faults(const Replay& replay) {
  std::vector<std::string> faults;
  auto names = shapeless(replay.c);
  constexpr std::size_t most = 6;
  if (names.size() > most) {
    const std::size_t more = names.size() - most + 1;
    names.resize(most - 1);
    names.push_back(fmt::format("{} more", more));
  }
  if (!names.empty()) {
    faults.push_back(fmt::format("without shapes, shown as axes: {}",
                                 fmt::join(names, ", ")));
  }
  const Take take = takes_of(replay, 1).front();
  for (int i = 0; i <= static_cast<int>(replay.c.bodies.size()); ++i) {
    constexpr double far = 1;  // rad
    const double turn =
        BodyPath(replay.c, *take.rows, take.kept, i).largest_turn();
    if (!(turn > far)) continue;
    faults.push_back(
        fmt::format("{} turns by up to {:.2g} rad between two rows, which the "
                    "replay has to "
                    "guess: a shorter output_step",
                    replay.c.rigid_body(i).name, turn));
  }
  return faults;
}

}  // namespace separation
