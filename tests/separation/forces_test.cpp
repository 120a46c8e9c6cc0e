// Forces of a case: each kind against hand calculations, and the properties
// common to all kinds.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "libcontact/base/file_text.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/force_kind.hpp"
#include "separation/case/force_law.hpp"
#include "separation/simulation/case_forces.hpp"
#include "separation/simulation/force_watch.hpp"
#include "separation/simulation/simulation.hpp"
#include "support/error_message.hpp"
#include "support/toml_text.hpp"

namespace contact::test::forces_test {
namespace {

using contact::test::error_message;
using contact::test::operator""_toml;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMotion;
using separation::force_kinds;
using separation::ForceKind;

// One force of a case on a body that is turned by 90 deg about z and moved to
// (10, 0, 0), with the carrier at the origin.
struct Forces {
  BodyForce carrier, body;
};
Forces forces_of(const std::string& force, double time,
                 const Vector3d& velocity = Vector3d::Zero()) {
  const separation::Case c = separation::parse_case(R"(
name = "forces"; run = { end_time_s = 1 }
[carrier]; name = "core"; mass_kg = 10; principal_inertia_kg_m2 = [1, 1, 1]
[[body]]; name = "tip"; mass_kg = 2; com_m = [1, 0, 0]
principal_inertia_kg_m2 = [1, 1, 1]
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [10, 0, 0] }
[[force]]; name = "f"; body = "tip"
)"_toml + force,
                                                    "forces.toml");
  BodyMotion carrier{Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Identity(),
                     Vector3d::Zero()};
  BodyMotion body = carrier;
  body.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  body.position = Vector3d(10, 0, 0);
  body.velocity = velocity;
  const std::vector<BodyMotion> bodies = {carrier, body};
  std::vector<BodyForce> result(2);
  const separation::CaseForces model(c, separation::History(c));
  model.add_forces(time, bodies, result);
  return {result[0], result[1]};
}

void expect_force(const BodyForce& f, const Vector3d& force,
                  const Vector3d& moment) {
  // Some roundings of numbers up to some tens.
  EXPECT_LE((f.force - force).norm(), 1e-13) << f.force.transpose();
  EXPECT_LE((f.moment - moment).norm(), 1e-13) << f.moment.transpose();
}

TEST(CaseForces, AppliedInBothAxes) {
  const Vector3d zero = Vector3d::Zero();
  // 2 m along the body's x from its centre of mass: inertial y.
  const std::string point = "kind = \"applied\"\npoint_m = [3, 0, 0]\n";
  expect_force(forces_of(point + "force_N = [0, 5, 0]\n", 0).body, {-5, 0, 0},
               {0, 0, 10});
  expect_force(
      forces_of(point + "axes = \"inertial\"\nforce_N = [0, 5, 0]\n", 0).body,
      {0, 5, 0}, zero);
  expect_force(
      forces_of("kind = \"applied\"\nmoment_N_m = [1, 0, 0]\n", 0).body, zero,
      {0, 1, 0});
  const std::string over_time =
      "kind = \"applied\"\nstarts_at_s = 1\nends_at_s = 4\n"
      "time_s = [0, 2]\nforce_N = [[0, 0, 1], [0, 0, 3]]\n";
  for (const auto& [time, force] :
       {std::pair{0.5, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {3.5, 3.0}, {4.5, 0.0}}) {
    expect_force(forces_of(over_time, time).body, {0, 0, force}, zero);
  }
  // The body has turned by 90 deg.
  expect_force(forces_of("kind = \"applied\"\nangle_deg = [0, 180]\n"
                         "force_N = [[0, 0, 0], [0, 0, 8]]\n",
                         0)
                   .body,
               {0, 0, 4}, zero);
}

// At a jump a table has its second value, and just before it its first,
// independent of rounding of the time since the force began.
TEST(CaseForces, JumpsOfTablesOverTime) {
  for (const double begin : {0.0, 0.1, 1 / 3.0, 0.7, 12.3}) {
    for (const double jump : {0.1, 0.2, 0.3, 0.7, 1 / 3.0}) {
      const auto force = [&](double time) {
        return forces_of(
                   fmt::format("kind = \"applied\"\nstarts_at_s = {}\n"
                               "time_s = [0, {}, {}, 9]\n"
                               "force_N = [[0, 0, 1], [0, 0, 2], [0, 0, -5], "
                               "[0, 0, -5]]\n",
                               begin, jump, jump),
                   time)
            .body.force.z();
      };
      EXPECT_EQ(force(begin), 1);
      EXPECT_NEAR(force(std::nextafter(begin + jump, 0)), 2, 1e-13);
      EXPECT_NEAR(force(begin + jump), -5, 1e-13);
    }
  }
}

TEST(CaseForces, ThrustEndsWithoutDecay) {
  const std::string thrust =
      "kind = \"thrust\"\npoint_m = [1, 1, 0]\ndirection = [2, 0, 0]\n"
      "thrust_N = 6\ncutoff_at_s = 3\n";
  const Vector3d zero = Vector3d::Zero();
  expect_force(forces_of(thrust, std::nextafter(3, 0)).body, {0, 6, 0},
               {0, 0, -6});
  expect_force(forces_of(thrust, 3).body, zero, zero);
}

TEST(CaseForces, ThrustDecays) {
  const std::string thrust =
      "kind = \"thrust\"\npoint_m = [1, 1, 0]\ndirection = [2, 0, 0]\n"
      "thrust_N = 6\ncutoff_at_s = 3\ndecay_s = 0.5\n";
  for (const double time : {0.0, 3.0, 3.25, 5.0}) {
    const double force = time <= 3 ? 6 : 6 * std::exp(-(time - 3) / 0.5);
    expect_force(forces_of(thrust, time).body, {0, force, 0}, {0, 0, -force});
  }
}

TEST(CaseForces, BetweenTheBodies) {
  // From (10, 4, 0) to the body's point at (10, 1, 0): 3 m long, pulls with
  // 5 N/m x 2 m and is damped with 2 N s/m x 3 m/s.
  const Forces spring = forces_of(
      "kind = \"spring\"\npoint_m = [2, 0, 0]\n"
      "carrier_point_m = [10, 4, 0]\nstiffness_N_per_m = 5\n"
      "free_length_m = 1\ndamping_N_s_per_m = 2\n",
      0, {7, -3, 0});
  expect_force(spring.body, {0, 16, 0}, {0, 0, 0});
  expect_force(spring.carrier, {0, -16, 0}, {0, 0, -160});
  // 0.25 of 0.5 m used: half way from 8 to 4 N.
  const Forces pusher = forces_of(
      "kind = \"pusher\"\npoint_m = [1, 1, 0]\n"
      "carrier_point_m = [9, -0.25, 0]\ndirection = [0, 1, 0]\n"
      "first_force_N = 8\nlast_force_N = 4\nstroke_m = 0.5\n",
      0);
  expect_force(pusher.body, {0, 6, 0}, {0, 0, -6});
  expect_force(pusher.carrier, {0, -6, 0}, {0, 0, -54});
  const Forces motor = forces_of("kind = \"motor\"\nmoment_N_m = 3\n", 0);
  expect_force(motor.body, {0, 0, 0}, {0, 0, 3});
  expect_force(motor.carrier, {0, 0, 0}, {0, 0, -3});
}

TEST(CaseForces, AirByAngleAndPressure) {
  // The nose points along inertial y, the air goes along (-0.6, -0.8, 0): the
  // angle of attack is 36.87 deg, across the nose it pushes along -x.
  const std::string air =
      "kind = \"aerodynamic\"\naxis = [1, 0, 0]\nreference_area_m2 = 2\n"
      "reference_length_m = 3\nangle_deg = [0, 73.73979529168804]\n";
  const std::string tables =
      "axial = [0, 2]\nnormal = [0, 4]\nmoment = [0, 1]\n";
  // Half way along the table; q S = 20.
  const Forces given = forces_of(
      air + tables + "flow = [-3, -4, 0]\ndynamic_pressure_Pa = 10\n", 0);
  // Nose away from the wind: from y towards -x, about +z.
  expect_force(given.body, {-40, -20, 0}, {0, 0, 30});
  // 0.4 kg/m^3 at 5 m/s through still air is 5 Pa.
  const Forces flying =
      forces_of(air + tables + "density_kg_per_m3 = 0.4\n", 0, {3, 4, 0});
  expect_force(flying.body, {-20, -10, 0}, {0, 0, 15});
  // Between two pressures: 3/4 of the way.
  const Forces between =
      forces_of(air +
                    "table_pressure_Pa = [4, 12]\nnormal = [[0, 0], [0, 4]]\n"
                    "flow = [-3, -4, 0]\ndynamic_pressure_Pa = 10\n",
                0);
  expect_force(between.body, {-20 * 0.75 * 2, 0, 0}, {0, 0, 0});
  // Beyond the tables the nearest table applies.
  for (const auto& [pressure, normal] : {std::pair(2, 1.0), {20, 2.0}}) {
    const Forces beyond = forces_of(
        air + "table_pressure_Pa = [4, 12]\nnormal = [[0, 2], [0, 4]]\n" +
            fmt::format("flow = [-3, -4, 0]\ndynamic_pressure_Pa = {}\n",
                        pressure),
        0);
    expect_force(beyond.body, {-2 * pressure * normal, 0, 0}, {0, 0, 0});
  }
}

// An event that comes for each of two bodies at its own time: for a third one,
// and for the carrier, when it comes first.
TEST(History, ClocksStrikeForEachBody) {
  separation::Case c;
  c.bodies.resize(3);
  c.events.resize(1);
  c.events[0].bodies = {0, 1};
  separation::History history(c);
  const separation::Clock clock{0, 0, 0.5};
  EXPECT_EQ(history.time_of(clock, 1, c), separation::History::not_yet);
  history.events[0] = {3, 2, separation::History::not_yet};
  EXPECT_EQ(history.time_of(clock, 1, c), 3.5);
  EXPECT_EQ(history.time_of(clock, 2, c), 2.5);
  EXPECT_EQ(history.time_of(clock, 3, c), 2.5);
  EXPECT_EQ(history.time_of(clock, 0, c), 2.5);
  EXPECT_EQ(history.time_of({7, -1, 0}, 1, c), 7);
}

// From (10, 4, 0) on the carrier to the body's point at (10, 1, 0): it comes
// nearer by 3 m/s, and 2 N s/m hold it back; what moves across the line does
// not count.
TEST(Damper, IsAgainstTheRateOfItsLength) {
  const Forces damper = forces_of(
      "kind = \"damper\"\npoint_m = [2, 0, 0]\n"
      "carrier_point_m = [10, 4, 0]\ndamping_N_s_per_m = 2\n",
      0, {7, 3, 0});
  expect_force(damper.body, {0, -6, 0}, {0, 0, 0});
  expect_force(damper.carrier, {0, 6, 0}, {0, 0, 60});
}

// Bodies of their own, given as "NAME", mass, x and velocity along x.
std::string ball_text(const char* name, double mass, double x, double speed) {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nmass_kg = {}\n"
      "principal_inertia_kg_m2 = [1, 1, 1]\nstart = {{ position_m = [{}, 0, "
      "0], velocity_m_per_s = [{}, 0, 0] }}\n",
      name, mass, x, speed);
}
const std::string ground =
    "name = \"d\"\nrun = { end_time_s = 2 }\n"
    "[carrier]\nname = \"ground\"\nfixed = true\n";

// A case with a simulation of it.
struct Simulated {
  explicit Simulated(const std::string& text)
      : of(separation::parse_case(ground + text, "d.toml")),
        motion(of, separation::FrictionChoice::full) {}
  double energy() const { return motion.sample().energy().balance(); }
  std::vector<separation::ForceRecord> records() const {
    std::vector<separation::ForceRecord> records(1);
    separation::look_at_forces(motion, records);
    return records;
  }

  separation::Case of;
  separation::Simulation motion;
};

// 0.3 m are used when it begins, at a time or with an event: of a shorter
// stroke nothing is left, and of a longer one 0.2 m push.
TEST(Pusher, DoesNotBeginBehindItsStroke) {
  for (const char* const begin :
       {"starts_at_s = 0.7\n", "starts_at_event = \"go\"\n"}) {
    for (const double stroke : {0.2, 0.5}) {
      Simulated run(ball_text("a", 2, 1, 0) + R"(
[[body]]; name = "b"; mass_kg = 1; principal_inertia_kg_m2 = [1, 1, 1]
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [0, 9, 0] }
[[event]]; name = "go"; time_s = 0.5; breaks = "hinge"; bodies = ["b"]
[[force]]; name = "pusher"; kind = "pusher"; body = "a"; point_m = [0, 0, 0]
carrier_point_m = [0.7, 0, 0]; direction = [1, 0, 0]; first_force_N = 40
)"_toml + begin + fmt::format("stroke_m = {}\n", stroke));
      separation::Simulation& motion = run.motion;
      while (motion.advance_to(2) == separation::Simulation::Stop::event) {
        ASSERT_TRUE(motion.apply());
      }
      ASSERT_EQ(motion.time(), 2);
      const double speed = motion.sample().body(0).velocity.x();
      if (stroke < 0.3) {
        EXPECT_EQ(speed, 0) << begin;
      } else {
        EXPECT_NEAR(speed, std::sqrt(2 * 40 * 0.2 / 2), 1e-7) << begin;
      }
    }
  }
}

// A thousandth of the stroke is the rounding of figures with a few digits.
TEST(Pusher, IsBehindByMoreThanAThousandthOfItsStroke) {
  for (const auto& [behind, fault] : {std::pair(0.9e-3, 0), {1.1e-3, 1}}) {
    const Simulated run(ball_text("a", 2, 1, 0) + R"(
[[force]]; name = "pusher"; kind = "pusher"; body = "a"; point_m = [0, 0, 0]
direction = [1, 0, 0]; first_force_N = 40; stroke_m = 0.5
)"_toml + fmt::format("carrier_point_m = [{}, 0, 0]\n", 1 + behind * 0.5));
    const separation::ForceInstant at{run.of, 1, run.motion.sample().motions(),
                                      0,      0, 0};
    EXPECT_EQ(run.of.forces[0].law->find_fault(at, true, true), fault)
        << behind;
  }
}

// A moment is an act too.
TEST(IdleForces, AreThoseWithoutForceAndMoment) {
  for (const int moment : {0, 3}) {
    const Simulated run(
        ball_text("a", 2, 1, 0) +
        fmt::format("[[force]]\nname = \"f\"\nkind = \"applied\"\n"
                    "body = \"a\"\nmoment_N_m = [0, {}, 0]\n",
                    moment));
    EXPECT_EQ(run.records()[0].acted, moment != 0);
  }
}

// Two bodies that drift apart with u: mu u' = -c u, mu the reduced mass. The
// damper takes the energy of the relative motion, and momentum is kept.
TEST(Damper, OfTwoBodiesDecaysExponentially) {
  constexpr double m1 = 2, m2 = 3, c = 1.5, u0 = 1.2;
  constexpr double mu = m1 * m2 / (m1 + m2);
  Simulated two(ball_text("a", m1, 1, u0) + ball_text("b", m2, 0, 0) + R"(
[[force]]; name = "damper"; kind = "damper"; body = "a"; point_m = [0, 0, 0]
other_body = "b"; other_point_m = [0.25, 0, 0]; damping_N_s_per_m = 1.5
)"_toml);
  separation::Simulation& motion = two.motion;
  const double begin = two.energy();
  for (const double t : {0.25, 0.5, 1.0, 2.0}) {
    ASSERT_EQ(motion.advance_to(t), separation::Simulation::Stop::time);
    const auto& sample = motion.sample();
    const double left = std::exp(-c * t / mu);
    const BodyMotion& a = sample.body(0);
    const BodyMotion& b = sample.body(1);
    // Tolerances of the steps: 1e-9 of a number plus 1e-8.
    EXPECT_NEAR(a.velocity.x() - b.velocity.x(), u0 * left, 2e-8) << t;
    EXPECT_NEAR(a.position.x() - b.position.x(), 1 + u0 * mu / c * (1 - left),
                2e-8);
    EXPECT_NEAR(m1 * a.velocity.x() + m2 * b.velocity.x(), m1 * u0, 1e-13);
    const multibody::EnergyBook book = sample.energy();
    EXPECT_NEAR(book.active_work, -mu * u0 * u0 / 2 * (1 - left * left), 2e-8);
    EXPECT_NEAR(book.balance(), begin, 2e-8);
  }
}

// A mass on a spring to the ground: x = x0 e^(-b t) (cos w t + b/w sin w t),
// b = c/2m, w^2 = k/m - b^2. Its logarithmic decrement is 2 pi b/w.
TEST(Damper, HasItsLogarithmicDecrement) {
  constexpr double m = 2, k = 800, c = 8, x0 = 0.1;
  constexpr double b = c / (2 * m);
  const double w = std::sqrt(k / m - b * b);
  Simulated one(ball_text("a", m, 1 + x0, 0) + R"(
[[force]]; name = "spring"; kind = "spring"; body = "a"; point_m = [0, 0, 0]
carrier_point_m = [0, 0, 0]; stiffness_N_per_m = 800; free_length_m = 1
[[force]]; name = "damper"; kind = "damper"; body = "a"; point_m = [0, 0, 0]
carrier_point_m = [-0.5, 0, 0]; damping_N_s_per_m = 8
)"_toml);
  const double begin = one.energy();
  const auto x_at = [&](double t) {
    EXPECT_EQ(one.motion.advance_to(t), separation::Simulation::Stop::time);
    return one.motion.sample().body(0).position.x() - 1;
  };
  const double period = 2 * std::numbers::pi / w;
  for (int half = 1; half <= 6; ++half) {
    const double quarter = (half - 0.75) * period / 2;
    // Tolerances of some hundred steps.
    EXPECT_NEAR(x_at(quarter),
                x0 * std::exp(-b * quarter) *
                    (std::cos(w * quarter) + b / w * std::sin(w * quarter)),
                3e-8);
    const double peak = half * period / 2;
    const double sign = half % 2 == 0 ? 1 : -1;
    EXPECT_NEAR(x_at(peak), sign * x0 * std::exp(-b * peak), 3e-8);
  }
  // The same times the spring's largest force, 80 N.
  EXPECT_NEAR(one.energy(), begin, 2.4e-6);
}

// Copies are joined one by one, and both ends have to be there.
TEST(Damper, NeedsTwoEnds) {
  const auto message = [](const std::string& keys) {
    return error_message([&] {
      separation::parse_case(
          ground + ball_text("a", 1, 0, 0) + ball_text("b", 1, 1, 0) +
              "[[body]]\nname = \"c\"\nmass_kg = 1\n"
              "principal_inertia_kg_m2 = [1, 1, 1]\n"
              "hinge = { kind = \"ball\", body_point_m = [1, 0, 0] }\n"
              "pattern = { count = 2, axis = [0, 0, 1] }\n"
              "[[force]]\nname = \"f\"\nkind = \"damper\"\n"
              "damping_N_s_per_m = 1\npoint_m = [0, 0, 0]\n" +
              keys,
          "d.toml");
    });
  };
  const std::string place = "d.toml:28: force[1].";
  for (const auto& [keys, said] :
       std::vector<std::pair<std::string, std::string>>{
           {R"(carrier_point_m = [1, 0, 0]; body = "c")"_toml, "(no error)"},
           {R"(other_point_m = [1, 0, 0]; body = "a"; other_body = "c 2")"_toml,
            "(no error)"},
           {R"(body = "a"; other_point_m = [1, 0, 0])"_toml,
            place + "other_point_m = [1, 0, 0] requires other_body"},
           {R"(body = "a"; other_body = "b"; carrier_point_m = [1, 0, 0])"_toml,
            place + "other_body = \"b\" conflicts with "
                    "force[1].carrier_point_m (line 29)"},
           {R"(body = "a"; other_body = "a")"_toml,
            place + "other_body = \"a\" must be another one than body"},
           {R"(body = "a"; other_body = "ground")"_toml,
            place + "other_body = \"ground\" must be a body, not the carrier, "
                    "whose point is carrier_point"},
           {R"(body = "a"; other_body = "c")"_toml,
            place + "other_body = \"c\" must be one body, or as many as body "
                    "names"},
           {R"(body = "a"; other_body = "bb")"_toml,
            place + "other_body = \"bb\": unknown body \"bb\" (ground, a, b, "
                    "c, c 1, c 2)"}}) {
    EXPECT_EQ(message(keys + '\n'), said);
  }
  EXPECT_EQ(message("body = \"a\"\nother_body = \"b\"\n").substr(0, 45),
            "d.toml:22: force[1] requires other_point (in ");
}

TEST(Damper, OfNoLengthIsWarnedOf) {
  const Simulated run(ball_text("a", 1, 2, 1) + R"(
[[force]]; name = "f"; kind = "damper"; body = "a"; point_m = [0, 0, 0]
carrier_point_m = [2, 0, 0]; damping_N_s_per_m = 1
)"_toml);
  EXPECT_EQ(
      separation::force_faults(run.of, run.records()),
      std::vector<std::string>{
          "force \"f\" has no direction when it starts, t = 0 s: point on "
          "a and its other end are in one place"});
}

std::string message_of(const std::string& force) {
  return error_message([&] { forces_of(force, 0); });
}

std::set<std::string> keys_of(const ForceKind& kind) {
  std::set<std::string> keys;
  for (const contact::KnownKey& key : kind.keys) keys.emplace(key.key);
  return keys;
}

// A force with a pattern is as many forces that are written out, whatever its
// kind, on bodies and carriers that lie anyhow; 120 deg about z.
TEST(Patterns, AreForcesWrittenOut) {
  const std::string bodies = R"(
name = "ring"; run = { end_time_s = 1 }
[carrier]; name = "core"; mass_kg = 10; com_m = [0, 0.1, -1]; principal_inertia_kg_m2 = [1, 1, 1]
[[body]]; name = "tip"; mass_kg = 2; com_m = [0.1, 0, 1]; principal_inertia_kg_m2 = [1, 1, 1]
[[body]]; name = "other"; mass_kg = 2; com_m = [0.1, 0.4, 1]; principal_inertia_kg_m2 = [1, 1, 1]
)"_toml;
  const auto point = [](const char* key, double x, double z, int place,
                        double first) {
    const double angle = first + 2 * std::numbers::pi * place / 3;
    return fmt::format("{} = [{:.17g}, {:.17g}, {:.17g}]\n", key,
                       x * std::cos(angle), x * std::sin(angle), z);
  };
  struct Keyed {
    const char* key;
    double x, z;
  };
  struct Kind {
    std::string numbers;
    std::vector<Keyed> vectors;
  };
  const Kind kinds[] = {
      {"kind = \"applied\"\n",
       {{"point_m", 0.7, 0.1}, {"force_N", 3, 4}, {"moment_N_m", 1, 2}}},
      {"kind = \"thrust\"\nthrust_N = 7\n",
       {{"point_m", 0.7, 0.1}, {"direction", 3, 4}}},
      {"kind = \"spring\"\nstiffness_N_per_m = 7\nfree_length_m = 0.3\n",
       {{"point_m", 0.7, 0.1}, {"carrier_point_m", 0.6, -0.2}}},
      {"kind = \"damper\"\nother_body = \"other\"\ndamping_N_s_per_m = 7\n",
       {{"point_m", 0.7, 0.1}, {"other_point_m", 0.6, -0.2}}},
      {"kind = \"pusher\"\nfirst_force_N = 9\nstroke_m = 30\n",
       {{"point_m", 0.7, 0.1},
        {"carrier_point_m", 0.6, -0.2},
        {"direction", 3, 4}}}};
  const auto turned = [](const Vector3d& about) {
    return Matrix3d(Eigen::AngleAxisd(about.norm(), about.normalized()));
  };
  const std::vector<BodyMotion> motions = {
      {{0, 0, 0}, {0, 0, 0}, turned({1, 2, 3}), {0.1, 0.2, 0.3}},
      {{1, 2, 9}, {3, 1, 2}, turned({-1, 2, 0.3}), {0.4, -0.2, 0.3}},
      {{2, 1, 7}, {1, 5, 2}, turned({2, 1, -3}), {0.1, 0.2, -0.7}}};
  const auto loads = [&](const separation::Case& c) {
    std::vector<BodyForce> forces(3);
    separation::CaseForces(c, separation::History(c))
        .add_forces(0.1, motions, forces);
    return forces;
  };
  for (const Kind& kind : kinds) {
    std::string one = bodies, all = bodies;
    for (int place = -1; place < 3; ++place) {
      std::string text = fmt::format(
          "[[force]]\nname = \"f {}\"\nbody = \"tip\"\n", place + 1);
      text += kind.numbers;
      for (const auto& [key, x, z] : kind.vectors) {
        text += point(key, x, z, place < 0 ? 0 : place, place < 0 ? 0 : 0.3);
      }
      (place < 0 ? one : all) += text;
    }
    one += "[force.pattern]\ncount = 3\naxis = [0, 0, 2]\nfirst_rad = 0.3\n";
    const auto c = separation::parse_case(one, "one.toml");
    ASSERT_EQ(c.forces.size(), 3u);
    EXPECT_EQ(c.forces[2].name, "f 0 3");
    EXPECT_EQ(c.forces[2].group, "f 0");
    const auto pattern = loads(c);
    const auto written = loads(separation::parse_case(all, "all.toml"));
    for (int body = 0; body < 3; ++body) {
      EXPECT_LT((pattern[body].force - written[body].force).norm(), 1e-12);
      EXPECT_LT((pattern[body].moment - written[body].moment).norm(), 1e-12);
    }
    EXPECT_GT(pattern[1].moment.norm(), 0.1) << kind.numbers;
  }
}

TEST(ForceKinds, UnknownOnesAreToldAll) {
  const std::string message = message_of("kind = \"glue\"\n");
  for (const ForceKind& kind : force_kinds()) {
    EXPECT_THAT(message, testing::HasSubstr(fmt::format("\"{}\"", kind.name)));
  }
}

// Every kind has keys that have to be there, and no others.
TEST(ForceKinds, HaveTheirOwnKeys) {
  std::set<std::string> all;
  for (const ForceKind& kind : force_kinds()) all.merge(keys_of(kind));
  for (const ForceKind& kind : force_kinds()) {
    const std::string text = fmt::format("kind = \"{}\"\n", kind.name);
    const std::set<std::string> keys = keys_of(kind);
    const std::string empty = message_of(text);
    EXPECT_THAT(empty, testing::HasSubstr("force[1] requires "));
    EXPECT_TRUE(std::ranges::any_of(keys, [&](const std::string& key) {
      return empty.find(" " + key) != empty.npos;
    })) << empty;
    for (const std::string& key : all) {
      if (keys.contains(key)) continue;
      EXPECT_THAT(
          message_of(text + key + " = 1\n"),
          testing::HasSubstr(fmt::format("unknown key \"force[1].{}\"", key)));
    }
  }
}

// case_file.md has a row for each kind with its keys and no others.
TEST(ForceKinds, AreOnThePage) {
  std::string page = contact::detail::file_text(
      CONTACT_SOURCE_DIR "/libcontact/docs/reference/case_file.md");
  page = page.substr(page.find("## Forces"));
  page.resize(page.find("## Clearances"));
  std::vector<std::string> rows;
  const std::regex row("\n\\| `\"(\\w+)\"` \\| (.*) \\|");
  const std::regex word("`(\\w+)`");
  const std::sregex_iterator none;
  for (std::sregex_iterator r(page.begin(), page.end(), row); r != none; ++r) {
    rows.push_back((*r)[1]);
    const std::string text = (*r)[2];
    std::set<std::string> keys;
    for (std::sregex_iterator w(text.begin(), text.end(), word); w != none;
         ++w) {
      keys.insert((*w)[1]);
    }
    for (const ForceKind& kind : force_kinds()) {
      if (kind.name == rows.back()) {
        EXPECT_EQ(keys, keys_of(kind)) << text;
      }
    }
  }
  std::vector<std::string> names;
  for (const ForceKind& kind : force_kinds()) names.emplace_back(kind.name);
  EXPECT_EQ(rows, names);
}

}  // namespace
}  // namespace contact::test::forces_test
