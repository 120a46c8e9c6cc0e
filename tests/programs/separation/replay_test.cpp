// Content of replays: solids, poses between rows, key frames, nearest points,
// pages of few rows. The files as others read them: tests/browser.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "programs/separation/replay/mesh.hpp"
#include "programs/separation/replay/page.hpp"
#include "programs/separation/replay/page_data.hpp"
#include "programs/separation/replay/scene.hpp"
#include "programs/separation/replay/shown_forces.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/clearance/clearance.hpp"
#include "support/program.hpp"
#include "support/toml_text.hpp"

namespace contact::test::replay_test {
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

// Volume of the solid within, by its triangles, which face outwards.
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
    // A circle of 40 sides has 0.4 % less area, a ball 1 % less volume.
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

// Largest error of the rows of `coarse`, at the times of `fine` in between.
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
                            {{&c, "", false, &fine.memory.rows,
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
name = "spin"; run = { end_time_s = 10, output_step_s = 1 }
carrier = { name = "a", mass_kg = 1, principal_inertia_kg_m2 = [1, 1, 1] }
[[body]]; name = "wheel"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1, 1]
hinge = { kind = "axis", axis = [0, 0, 1] }; start = { rate_deg_per_s = 3600 }
[[body]]; name = "top"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1, 1]
start = { angular_velocity_deg_per_s = [0, 90, 0] }
)"_toml;
  const Case c = separation::parse_case(text, "spin.toml");
  const Outcome outcome = separation::run_case(c);
  const auto faults = separation::replay_faults({c, {{"", &outcome}}, {}, ""});
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0],
            "bodies without shapes are shown as axes: a, wheel, top");
  EXPECT_EQ(faults[1],
            "top turns by up to 1.6 rad between two rows, too far to "
            "interpolate the replay: use a shorter output_step");
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
  for (const std::size_t pair : {0U, 1U}) {
    const auto points = clearance.nearest_points(bodies, pair);
    ASSERT_TRUE(points);
    const double distance = clearance.distance(pair, bodies);
    EXPECT_NEAR((points->first - points->second).norm(), distance,
                1e-12 * distance);
  }
  bodies[1].position = bodies[0].position;
  EXPECT_FALSE(clearance.nearest_points(bodies, 0));
}

// A body that tumbles through 0.6 rad between two rows, by the terms of its
// rates that the cubic has: the next one is left.
TEST(Replay, TumblingBodiesAreRightBetweenRows) {
  Case c = separation::parse_case(R"(
name = "tumble"
run = { end_time_s = 8, output_step_s = 0.2, relative_tolerance = 1e-11, absolute_tolerance = 1e-11 }
carrier = { name = "a", mass_kg = 1, principal_inertia_kg_m2 = [1, 1, 1] }
[[body]]; name = "top"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1.4, 2]
start = { angular_velocity_deg_per_s = [20, 170, 60] }
)"_toml,
                                  "tumble.toml");
  const Outcome coarse = separation::run_case(c);
  c.output_step /= 4;
  const Outcome fine = separation::run_case(c);
  const auto path = [&c](const Outcome& outcome) {
    const Rows& rows = outcome.memory.rows;
    return BodyPath(c, rows, separation::replay_rows(rows, 1), 1);
  };
  const BodyPath between = path(coarse);
  const BodyPath want = path(fine);
  double worst = 0;
  for (std::size_t i = 0; i < want.size(); ++i) {
    const auto place = static_cast<double>(i);
    worst = std::max(worst, between.pose(place / 4).rotation.angularDistance(
                                want.pose(place).rotation));
  }
  std::printf("between rows: %.2e rad\n", worst);
  EXPECT_LT(worst, 8e-5);
}

// However few rows are shown, those on both sides of an event are.
TEST(Replay, RowsAboutEventsAreKept) {
  const Rows rows{{"time_s"}, {0, 1, 2, 3, 4, 5, 5, 6, 7, 8, 9}};
  EXPECT_EQ(separation::replay_rows(rows, 4),
            (std::vector<std::size_t>{0, 4, 5, 6, 8, 10}));
  EXPECT_EQ(separation::replay_rows(rows, 100),
            (std::vector<std::size_t>{0, 5, 6, 10}));
  EXPECT_EQ(separation::replay_rows(rows, 1).size(), rows.size());
}

// Thrust that decays after its event, a spring until its event, a pusher until
// its stroke is used up, air and a moment: by their definitions, from the rows.
TEST(Replay, ForcesAreThoseOfTheCase) {
  const Case c = separation::parse_case(R"(
name = "forces"; run = { end_time_s = 3, output_step_s = 0.05 }
carrier = { name = "a", mass_kg = 50, principal_inertia_kg_m2 = [9, 9, 9] }
[[body]]; name = "b"; mass_kg = 2; principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [0, 0, 1], angular_velocity_deg_per_s = [0, 40, 0] }
[[event]]; name = "cut"; time_s = 1; breaks = "hinge"; bodies = "c"
[[body]]; name = "c"; mass_kg = 3; principal_inertia_kg_m2 = [1, 1, 1]
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [4, 0, 0] }
[[force]]; name = "engine"; body = "b"; kind = "thrust"
point_m = [0, 0.1, -0.2]; direction = [0, 0, 1]; thrust_N = 5
cutoff_at_event = "cut"; decay_s = 0.5
[[force]]; name = "spring"; body = "b"; kind = "spring"; point_m = [0, 0, -0.2]
carrier_point_m = [0, 0, 0.2]; stiffness_N_per_m = 10; free_length_m = 2
ends_at_event = "cut"
[[force]]; name = "pusher"; body = "b"; kind = "pusher"; point_m = [0, 0, -0.2]
carrier_point_m = [0, 0, 0.6]; direction = [0, 0, 1]; first_force_N = 3
last_force_N = 3; stroke_m = 0.5
[[force]]; name = "motor"; body = "c"; kind = "motor"; moment_N_m = 0.3
)"_toml,
                                        "forces.toml");
  const Outcome outcome = separation::run_case(c);
  const Rows& rows = outcome.memory.rows;
  const separation::Take take{&c, "", false, &rows,
                              separation::replay_rows(rows, 1)};
  const auto numbers = separation::shown_forces(take, outcome.history);
  ASSERT_EQ(numbers.size(), 24 * rows.size());
  const auto vector = [&](std::size_t row, std::size_t force, bool moment) {
    const float* at = &numbers[24 * row + 6 * force + (moment ? 3 : 0)];
    return Vector3d(at[0], at[1], at[2]);
  };
  const BodyPath path(c, rows, take.kept, 1);
  const BodyPath carrier(c, rows, take.kept, 0);
  bool spent = false;
  std::size_t place = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double time = rows.at(i, 0);
    const bool before = i + 1 < rows.size() && rows.at(i + 1, 0) == time;
    if (time > path.time(static_cast<double>(place))) ++place;
    const Pose pose = path.pose(static_cast<double>(place));
    const Eigen::Quaterniond turn =
        carrier.pose(static_cast<double>(place)).rotation;
    const bool cut = time > 1 || (time == 1 && !before);
    const double thrust = cut ? 5 * std::exp(-(time - 1) / 0.5) : 5;
    EXPECT_LT(
        (vector(i, 0, false) - pose.rotation * Vector3d(0, 0, thrust)).norm(),
        1e-6);
    EXPECT_EQ(vector(i, 0, true), Vector3d::Zero());
    const Vector3d point = pose.position + pose.rotation * Vector3d(0, 0, -0.2);
    const Vector3d span = point - turn * Vector3d(0, 0, 0.2);
    if (cut) {
      EXPECT_TRUE(std::isnan(vector(i, 1, false).x())) << time;
    } else {
      EXPECT_LT(
          (vector(i, 1, false) - 10 * (2 - span.norm()) * span.normalized())
              .norm(),
          1e-5);
    }
    const double used =
        (point - turn * Vector3d(0, 0, 0.6)).dot(turn * Vector3d(0, 0, 1));
    spent = spent || (used > 0.5 - 1e-9 && !before);
    if (spent) {
      EXPECT_TRUE(std::isnan(vector(i, 2, false).x())) << time;
    } else {
      EXPECT_LT((vector(i, 2, false) - turn * Vector3d(0, 0, 3)).norm(), 1e-6);
    }
    if (cut) {
      EXPECT_TRUE(std::isnan(vector(i, 3, true).x())) << time;
    } else {
      EXPECT_LT((vector(i, 3, true) - turn * Vector3d(0, 0, 0.3)).norm(), 1e-6);
      EXPECT_EQ(vector(i, 3, false), Vector3d::Zero());
    }
  }
  EXPECT_TRUE(spent);
}

// Text of a case ends no element and begins none.
TEST(Replay, DataOfAPageHaveNoMarkup) {
  const std::string nasty = "</script><script>alert(1)</script><!--";
  Case c = case_of("two_stage_turn");
  c.name = nasty;
  c.bodies[0].hinge.name = nasty;
  const Outcome outcome = separation::run_case(c);
  const std::string data = separation::page_data(
      {c, {{"", &outcome}}, {nasty + " of " + nasty}, "# " + nasty}, 8);
  EXPECT_EQ(data.find('<'), data.npos);
  const json read = json::parse(data);
  EXPECT_EQ(read["warnings"][0], nasty + " of " + nasty);
  EXPECT_EQ(read["case"], "# " + nasty);
}

// The JSON in a page.
json data_of(const std::string& page) {
  const std::string begin = R"(<script type="application/json" id="data">)";
  const std::size_t at = page.find(begin) + begin.size();
  return json::parse(page.substr(at, page.find("</script>", at) - at));
}

TEST(Replay, PagesThatWouldBeTooLongHaveFewerRows) {
  if (!ProgramFolder().has_page_libraries()) GTEST_SKIP() << "libjs-three";
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
  folder.run_well(
      "XDG_DATA_DIRS=/nowhere hinge-separation "
      "data/cases/soyuz.toml --replay a.glb");
}

}  // namespace
}  // namespace contact::test::replay_test
