// What replays show: solids, poses between rows, key frames, nearest points,
// pages of few rows. The files as others read them: tests/browser.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "programs/separation/replay/mesh.hpp"
#include "programs/separation/replay/page.hpp"
#include "programs/separation/replay/scene.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/clearance/clearance.hpp"
#include "support/program.hpp"

namespace contact::test {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using separation::BodyPath;
using separation::Case;
using separation::KeyFrames;
using separation::Mesh;
using separation::Outcome;
using separation::Pose;
using separation::Rows;
using separation::Shape;
using separation::ShapeKind;

Case case_of(const std::string& name) {
  return separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
}

Shape cube(double half) {
  std::vector<Vector3d> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) corners.emplace_back(x, y, z + 3);
    }
  }
  return separation::convex_hull(corners);
}

// Of the solid within, by its triangles, which look outwards.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const auto corner = [&](std::size_t j) {
      return Vector3d(mesh.positions[mesh.corners[i + j]].cast<double>());
    };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

TEST(Replay, MeshesAreTheSolids) {
  const Vector3d from(1, -2, 0.5);
  const Vector3d to(2, 1, 3);
  const std::vector<Shape> shapes = {
      {.kind = ShapeKind::capsule, .from = from, .to = to, .radius = 0.8},
      {.kind = ShapeKind::capsule, .from = from, .to = from, .radius = 0.8},
      {.kind = ShapeKind::cylinder, .from = from, .to = to, .radius = 0.8},
      {.kind = ShapeKind::cone, .from = from, .to = to, .radius = 0.8},
      cube(0.7),
      separation::box(
          from, {1, 2, 0.5},
          Eigen::AngleAxisd(0.7, Vector3d(1, -2, 2) / 3).toRotationMatrix())};
  for (const Shape& shape : shapes) {
    Mesh mesh;
    mesh.add(shape);
    // Of 40 sides a circle has 0.4 % less area, a ball 1 % less volume.
    const double part =
        volume(mesh) / separation::solid_properties(shape).volume;
    EXPECT_GT(part, 0.9895);
    EXPECT_LT(part, 1 + 1e-6);
    for (const Eigen::Vector3f& normal : mesh.normals) {
      EXPECT_NEAR(normal.norm(), 1, 1e-6);
    }
    // Corners look where their triangles do.
    for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
      const auto at = [&](std::size_t j) {
        return mesh.positions[mesh.corners[i + j]];
      };
      const Eigen::Vector3f across = (at(1) - at(0)).cross(at(2) - at(0));
      EXPECT_GE(across.dot(mesh.normals[mesh.corners[i]]), -1e-6);
    }
  }
}

// Of the rows of `coarse`, at the times of `fine` in between.
double worst_error(const Case& c, const Rows& coarse, const Rows& fine,
                   double length, double angle) {
  double worst = 0;
  const auto kept = separation::replay_rows(coarse, 1);
  const auto all = separation::replay_rows(fine, 1);
  for (int body = 0; body <= static_cast<int>(c.bodies.size()); ++body) {
    const BodyPath path(c, coarse, kept, body);
    const BodyPath finer(c, fine, all, body);
    const KeyFrames keys = separation::key_frames(path, length, angle);
    EXPECT_TRUE(std::ranges::is_sorted(keys.times));
    std::size_t key = 0;
    for (std::size_t i = 0; i < finer.size(); ++i) {
      const auto place = static_cast<double>(i);
      const double time = finer.time(place);
      while (key + 2 < keys.times.size() && keys.times[key + 1] <= time) ++key;
      const double part =
          (time - keys.times[key]) / (keys.times[key + 1] - keys.times[key]);
      const Pose& a = keys.poses[key];
      const Pose& b = keys.poses[key + 1];
      const Pose want = finer.pose(place);
      const Vector3d position = a.position + part * (b.position - a.position);
      worst = std::max(
          {worst, (position - want.position).norm() / length,
           a.rotation.slerp(part, b.rotation).angularDistance(want.rotation) /
               angle});
    }
  }
  return worst;
}

// Against runs with 16 times as many rows: what the cubics between rows leave
// is within the tenth of the tolerance that key frames leave them.
TEST(Replay, KeyFramesKeepToTheMotion) {
  for (const char* name :
       {"soyuz", "platform", "flywheels", "slosh", "two_stage_turn"}) {
    Case c = case_of(name);
    const Outcome coarse = separation::run_case(c);
    c.output_step /= 16;
    const Outcome fine = separation::run_case(c);
    const double size = separation::make_scene(
                            c,
                            {{"", false, &fine.memory.rows,
                              separation::replay_rows(fine.memory.rows, 64)}},
                            64)
                            .size;
    const double error = worst_error(c, coarse.memory.rows, fine.memory.rows,
                                     0.9 * separation::shown_position * size,
                                     0.9 * separation::shown_turn);
    std::printf("%s: %.3f of the tolerance\n", name, error);
    EXPECT_LT(0.9 * error, 1) << name;
  }
}

// A wheel turns ten times between two rows; a free body may not.
TEST(Replay, SaysWhatRowsCannotShow) {
  const std::string text = R"(
name = "spin"
run = { end_time_s = 10, output_step_s = 1 }
carrier = { name = "a", mass_kg = 1, principal_inertia_kg_m2 = [1, 1, 1] }
[[body]]
name = "wheel"
mass_kg = 1
principal_inertia_kg_m2 = [1, 1, 1]
hinge = { kind = "axis", axis = [0, 0, 1] }
start = { rate_deg_per_s = 3600 }
[[body]]
name = "top"
mass_kg = 1
principal_inertia_kg_m2 = [1, 1, 1]
start = { angular_velocity_deg_per_s = [0, 90, 0] }
)";
  const Case c = separation::parse_case(text, "spin.toml");
  const Outcome outcome = separation::run_case(c);
  const auto faults = separation::replay_faults({c, {{"", &outcome}}, {}, ""});
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0], "without shapes, shown as axes: a, wheel, top");
  EXPECT_EQ(faults[1],
            "top turns by up to 1.6 rad between two rows, which the replay has "
            "to guess: a shorter output_step");
  const auto kept = separation::replay_rows(outcome.memory.rows, 1);
  const BodyPath wheel(c, outcome.memory.rows, kept, 1);
  // 0.07 of 10 turns.
  const Eigen::Quaterniond want(
      Eigen::AngleAxisd(0.7 * 2 * std::numbers::pi, Vector3d::UnitZ()));
  EXPECT_LT(wheel.pose(3.07).rotation.angularDistance(want), 1e-7);
}

TEST(Replay, NearestPointsAreAsFarAsTheBodies) {
  const Case c = case_of("soyuz");
  std::vector<std::vector<Shape>> shapes;
  for (int i = 0; i <= 4; ++i) shapes.push_back(c.rigid_body(i).shapes);
  separation::Clearance clearance(shapes, {{0, 1}, {1, 3}});
  std::vector<multibody::BodyMotion> bodies(5);
  for (int i = 0; i <= 4; ++i) {
    bodies[i].position = Vector3d(1e6 + i, 20.0 * i, -3.0 * i);
    bodies[i].rotation = Eigen::Matrix3d(
        Eigen::AngleAxisd(0.3 * i, Vector3d(1, 2, 3).normalized()));
  }
  const auto distances = clearance.distances(bodies);
  for (const std::size_t pair : {0U, 1U}) {
    const auto points = clearance.nearest_points(bodies, pair);
    ASSERT_TRUE(points);
    EXPECT_NEAR((points->first - points->second).norm(), distances[pair],
                1e-12 * distances[pair]);
  }
  bodies[1].position = bodies[0].position;
  EXPECT_FALSE(clearance.nearest_points(bodies, 0));
}

// The JSON in a page.
json data_of(const std::string& page) {
  const std::string begin = R"(<script type="application/json" id="data">)";
  const std::size_t at = page.find(begin) + begin.size();
  return json::parse(page.substr(at, page.find("</script>", at) - at));
}

bool has_libraries() {
  return ProgramFolder()
             .run(
                 "ls /usr/share/javascript/three/three.min.js "
                 "/usr/share/javascript/dygraphs/dygraph.min.js")
             .status == 0;
}

TEST(Replay, PagesThatWouldBeTooLongHaveFewerRows) {
  if (!has_libraries()) GTEST_SKIP() << "libjs-three or libjs-dygraphs";
  const Case c = case_of("soyuz");
  const Outcome outcome = separation::run_case(c);
  const separation::PageParts parts("a.html");
  const separation::Replay replay{c, {{"", &outcome}}, {"a warning"}, "text"};
  const auto whole = separation::replay_page(replay, parts);
  EXPECT_EQ(whole.every, 1);
  const auto half =
      separation::replay_page(replay, parts, whole.text.size() - 60000);
  EXPECT_GT(half.every, 1);
  EXPECT_LT(half.text.size(), whole.text.size() - 60000);
  EXPECT_EQ(data_of(half.text)["every"], half.every);
  const auto rows = [](const std::string& page) {
    return data_of(page)["takes"][0]["time"].get<std::string>().size();
  };
  EXPECT_LT(rows(half.text), rows(whole.text));
  EXPECT_EQ(data_of(whole.text)["warnings"], json({"a warning"}));
  EXPECT_EQ(data_of(whole.text)["case"], "text");
  // The same run gives the same page.
  EXPECT_EQ(separation::replay_page(replay, parts).text, whole.text);
}

TEST(Replay, WithoutItsLibrariesAPageIsRefusedBeforeTheRun) {
  const ProgramFolder folder;
  const auto result = folder.run(
      "XDG_DATA_DIRS=/nowhere hinge-separation data/cases/soyuz.toml "
      "--replay a.html --replay a.glb");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err,
            "hinge-separation: --replay a.html requires three.js and dygraphs "
            "(three/three.min.js is missing): apt install libjs-three "
            "libjs-dygraphs\n");
  EXPECT_TRUE(folder.files().empty());
  EXPECT_EQ(folder
                .run("XDG_DATA_DIRS=/nowhere hinge-separation "
                     "data/cases/soyuz.toml --replay a.glb")
                .status,
            0);
}

}  // namespace
}  // namespace contact::test
