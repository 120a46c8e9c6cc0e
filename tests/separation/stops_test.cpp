// Stops and latches of cases against closed forms, momenta and energies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case_runs.hpp"
#include "support/toml_text.hpp"

namespace contact::test::stops_test {
namespace {

using Eigen::Vector3d;
using separation::Case;
using separation::Note;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::run_case;
using std::numbers::pi;

// J = 15 kg m^2 on the ground, driven from -90 deg by 2 N m.
// @param hinge  what else is said of its hinge
std::string boom(const std::string& hinge = "",
                 const std::string& start = "angle_deg = -90",
                 bool driven = true) {
  const std::string motor = R"(
[[force]]; name = "motor"; kind = "motor"; body = "boom"; moment_N_m = 2
)"_toml;
  return R"(
[carrier]; name = "ground"; fixed = true
[[body]]; name = "boom"; mass_kg = 1; principal_inertia_kg_m2 = [15, 15, 15]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]
)"_toml + hinge +
         "\n[body.start]\n" + start + "\n" + (driven ? motor : "");
}

// Impacts, rest and the energy of the book: a constant moment makes flights
// that last 2 e^n w1/a, w1 = sqrt(pi a) at the first impact, a = 2/15 rad/s^2.
TEST(CaseStops, BoomOnTheGround) {
  const Outcome outcome =
      run_of(run_for(13) + boom(stop("angle_deg = 0\nrestitution = 0.4")));
  const auto hits = notes_of(outcome, "hits its stop");
  ASSERT_GT(hits.size(), 8u);
  EXPECT_NEAR(hits[0].time, 4.854064781389, 1e-10);
  EXPECT_NEAR(hits[0].rate / degree, 37.0823233942, 1e-8);
  EXPECT_NEAR(hits[0].impulse, 13.5913813879, 1e-8);
  EXPECT_NEAR(hits[1].time, 8.737316606501, 1e-9);
  EXPECT_NEAR(hits[2].time, 10.290617336545, 1e-9);
  const auto rests = notes_of(outcome, "rests on its stop");
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_NEAR(rests[0].time, 11.326151156575, 1e-8);
  EXPECT_NEAR(last(outcome, "energy.impacts_J"), pi, 1e-9);
  EXPECT_NEAR(last(outcome, "energy.balance_J"), 0, 1e-9);
  EXPECT_NEAR(last(outcome, "boom.stop_moment_N_m"), 2, 1e-11);
  const auto& record = outcome.memory.bodies[0];
  EXPECT_NEAR(record.peak_stop, 2, 1e-11);
  EXPECT_EQ(record.impacts, static_cast<double>(hits.size()));
  EXPECT_EQ(record.largest_impulse, hits[0].impulse);
  EXPECT_NEAR(record.stop_loss, pi, 1e-9);
  EXPECT_NEAR(record.rest_on_stop, 13 - rests[0].time, 1e-12);
  EXPECT_EQ(record.rest_on_stop, record.rest_time);
  // (1 + e) J w1 (1 + e + e^2 + ...), less bounces that are not followed: J (1
  // + e)/(1 - e) sqrt(2 a 1e-11 rad) at most.
  EXPECT_NEAR(record.stop_impulses,
              1.4 * 15 * std::sqrt(pi * 2 / 15) / (1 - 0.4), 6e-5);
  EXPECT_EQ(last(outcome, "boom.stop_impulses_N_m_s"), record.stop_impulses);
}

// It goes off as soon as it is driven the other way, by an event of the case.
TEST(CaseStops, ReleasedByTheMoment) {
  std::string text = run_for(16) + boom(stop("angle_deg = 0\nrestitution = 0"));
  text +=
      "[[force]]\nname = \"back\"\nkind = \"motor\"\nbody = \"boom\"\n"
      "moment_N_m = -3\nstarts_at_s = 14\n";
  const Outcome outcome = run_of(text);
  EXPECT_EQ(notes_of(outcome, "hits its stop").size(), 1u);
  const auto leaves = notes_of(outcome, "leaves its stop");
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_NEAR(leaves[0].time, 14, 1e-12);
  EXPECT_NEAR(last(outcome, "boom.angle_deg"), -0.5 / 15 * 4 / degree, 1e-9);
}

// Friction of a thrust face on the ground, M_f = f0 m g (2/3)(...), where the
// pins carry nothing: what comes back from a flight has lost sqrt(a1/a2), a1 =
// (M - M_f)/J on the way in, a2 = (M + M_f)/J on the way out.
TEST(CaseStops, WithConstantFriction) {
  const double ro = 0.2, ri = 0.1, f = 0.2, g = 9.81, m = 1;
  const double face =
      f * m * g * 2 / 3 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri);
  const std::string pin = "[[body.hinge.joint]]\nfile = \"" CONTACT_DATA_DIR
                          "/joints/pin_joint.toml\"\nposition_m = ";
  std::string text =
      run_for(18) + boom(stop("angle_deg = 0\nrestitution = 0.6") +
                         R"(
[body.hinge.thrust_face]; inner_radius_m = 0.1; outer_radius_m = 0.2; coefficient = 0.2
)"_toml + pin + "0.1\n" + pin +
                         "-0.1\n");
  text.insert(text.find("[run]"), "gravity_m_per_s2 = [0, 0, -9.81]\n");
  const Outcome outcome = run_of(text);
  const double in = (2 - face) / 15, out = (2 + face) / 15;
  const auto hits = notes_of(outcome, "hits its stop");
  ASSERT_GT(hits.size(), 6u);
  double time = std::sqrt(pi / in), rate = std::sqrt(pi * in);
  for (int n = 0; n < 4; ++n) {
    EXPECT_NEAR(hits[n].time, time, 1e-8) << n;
    EXPECT_NEAR(hits[n].rate, rate, 1e-8) << n;
    const double up = 0.6 * rate;
    rate = up * std::sqrt(in / out);
    time += up / out + rate / in;
  }
  EXPECT_EQ(notes_of(outcome, "rests on its stop").size(), 1u);
  EXPECT_NEAR(last(outcome, "energy.balance_J"), 0, 1e-8);
  const auto& book = outcome.memory.bodies[0];
  EXPECT_NEAR(book.stop_loss + book.work, pi, 1e-8);
}

// Linear momentum, angular momentum about the origin, kinetic energy.
struct Motions {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
  double energy = 0, size = 0;  // size: angular momenta
};
Motions motions_of(const Case& c, const Rows& rows, std::size_t row) {
  Motions sum;
  for (int i = 0; i <= static_cast<int>(c.bodies.size()); ++i) {
    const separation::RigidBody& body = c.rigid_body(i);
    const std::size_t at =
        rows.column(separation::column_name(body.name) + ".x_m");
    const auto vector = [&](std::size_t k) {
      return Vector3d(rows.at(row, at + k), rows.at(row, at + k + 1),
                      rows.at(row, at + k + 2));
    };
    const Eigen::Quaterniond q(rows.at(row, at + 6), rows.at(row, at + 7),
                               rows.at(row, at + 8), rows.at(row, at + 9));
    const Vector3d w = vector(10), p = body.mass * vector(3);
    const Vector3d own = body.inertia * w;
    sum.linear += p;
    const Vector3d angular = vector(0).cross(p) + q * own;
    sum.angular += angular;
    sum.size += angular.norm();
    sum.energy += (p.dot(vector(3)) + w.dot(own)) / 2;
  }
  return sum;
}

const std::string bus = R"(
[carrier]; name = "bus"; mass_kg = 200; principal_inertia_kg_m2 = [35, 35, 35]
[[body]]; name = "boom"; mass_kg = 5; com_m = [1.5, 0, 0]
principal_inertia_kg_m2 = [3.75, 3.75, 3.75]; start = { angle_deg = -90 }
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [0.5, 0, 0] }
[[force]]; name = "motor"; kind = "motor"; body = "boom"; moment_N_m = 2
)"_toml;
std::string latch(const std::string& more) {
  return "[[event]]\nname = \"latch\"\nlocks = \"hinge\"\n" + more;
}

// Everything stands still once the boom is latched: by quadrature of the
// energy.
TEST(CaseLatches, BoomOnAFreeBus) {
  const Case c =
      parse_case(run_for(6) + bus + latch("angle_deg = 0\n"), "c.toml");
  const Outcome outcome = run_case(c, {});
  const auto latches = notes_of(outcome, "latch: hinge latches");
  ASSERT_EQ(latches.size(), 1u);
  EXPECT_NEAR(latches[0].time, 3.92142495076, 1e-10);
  EXPECT_NEAR(latches[0].impulse, 7.488338235624, 1e-9);
  EXPECT_NEAR(latches[0].loss, pi, 1e-9);
  EXPECT_NEAR(last(outcome, "energy.impacts_J"), pi, 1e-9);
  EXPECT_NEAR(last(outcome, "boom.latch_moment_N_m"), 2, 1e-9);
  EXPECT_NEAR(outcome.memory.bodies[0].peak_latch, 2, 1e-9);
  EXPECT_EQ(outcome.memory.bodies[0].latch_impulse, latches[0].impulse);
  EXPECT_NEAR(
      2 * std::atan2(last(outcome, "bus.qz"), last(outcome, "bus.qw")) / degree,
      -27.575692697172, 1e-8);
  EXPECT_EQ(outcome.modes[0], multibody::HingeMode::latched);
  const Rows& rows = outcome.memory.rows;
  const Motions end = motions_of(c, rows, rows.size() - 1);
  EXPECT_NEAR(end.energy, 0, 1e-20);
}

// Three booms, one of them on another, that latch at one time: one impulse,
// which keeps all momenta and takes the energy that the event says.
TEST(CaseLatches, SeveralAtOnceKeepMomenta) {
  const Case c = parse_case(run_for(3) + R"(
[carrier]; name = "bus"; mass_kg = 200; principal_inertia_kg_m2 = [35, 30, 40]
start = { angular_velocity_rad_per_s = [0.02, -0.05, 0.03], velocity_m_per_s = [0.1, 0, 0.2] }
[[body]]; name = "wing"; mass_kg = 5; com_m = [1.5, 0, 0.1]
principal_inertia_kg_m2 = [1, 3.75, 4]; start = { angle_deg = -90 }
hinge = { kind = "axis", axis = [0, 0, 1], carrier_point_m = [0.5, 0, 0] }
[[body]]; name = "tip"; mass_kg = 2; com_m = [1, 0, 0]
principal_inertia_kg_m2 = [0.1, 0.7, 0.7]; start = { angle_deg = 60 }
hinge = { kind = "axis", axis = [0, 1, 1], on = "wing", parent_point_m = [2.5, 0, 0] }
[[body]]; name = "dish"; mass_kg = 7; com_m = [0, 0, 0.8]
principal_inertia_kg_m2 = [1, 1, 2]
hinge = { kind = "ball", carrier_point_m = [0, 0.3, 0.5] }
start = { angular_velocity_rad_per_s = [0.3, 0.1, -0.2] }
[[force]]; name = "motor"; kind = "motor"; body = "wing"; moment_N_m = 2
[[force]]; name = "other"; kind = "motor"; body = "tip"; moment_N_m = -0.4
[[event]]; name = "latch"; locks = "hinge"; time_s = 2
)"_toml,
                            "c.toml");
  const Outcome outcome = run_case(c, {});
  ASSERT_EQ(outcome.failure, "");
  const auto latches = notes_of(outcome, "latch: hinge latches");
  ASSERT_EQ(latches.size(), 3u);
  const Rows& rows = outcome.memory.rows;
  std::size_t after = 1;
  while (rows.at(after, 0) != 2 || rows.at(after - 1, 0) != 2) ++after;
  // An output time too: its rows.
  while (after + 1 < rows.size() && rows.at(after + 1, 0) == 2) ++after;
  std::size_t before = after;
  while (rows.at(before, rows.column("wing.mode")) != 0) --before;
  const Motions a = motions_of(c, rows, before), b = motions_of(c, rows, after);
  EXPECT_LE((a.linear - b.linear).norm(), 1e-12 * a.linear.norm());
  EXPECT_LE((a.angular - b.angular).norm(), 1e-12 * a.size);
  double loss = 0;
  for (const Note& note : latches) loss += note.loss;
  EXPECT_NEAR(a.energy - b.energy, loss, 1e-12 * a.energy);
  EXPECT_GT(loss, 0.1 * a.energy);
  for (const char* body : {"wing", "tip", "dish"}) {
    EXPECT_EQ(
        rows.at(after, rows.column(std::string(body) + ".rate_deg_per_s")), 0);
    EXPECT_EQ(last(outcome, std::string(body) + ".rate_deg_per_s"), 0);
  }
}

// Booms that mirror each other reach their angles within rounding of each
// other, whatever copies make of their numbers: one impulse, alike for both.
TEST(CaseLatches, MirroredBoomsLatchTogether) {
  std::string text = run_for(6) + bus + latch("angle_deg = 0\n");
  text.insert(text.find("hinge ="),
              "pattern = { count = 3, axis = [0, 0, 1] }\n");
  const Outcome outcome = run_of(text);
  const auto latches = notes_of(outcome, "latch: hinge latches");
  ASSERT_EQ(latches.size(), 3u);
  for (const Note& note : latches) {
    EXPECT_EQ(note.time, latches[0].time);
    EXPECT_NEAR(note.impulse, latches[0].impulse, 1e-9);
    EXPECT_GT(note.impulse, 1);
  }
}

// Faster than it takes at first, then off the stop and back, until it is slow
// enough; or caught where it has come to rest.
TEST(CaseLatches, EngageBelowARate) {
  const auto run = [&](const char* e, const char* rate) {
    return run_of(run_for(13) +
                  boom(stop(std::string("angle_deg = 0\nrestitution = ") + e)) +
                  latch(std::string("angle_deg = 0\nrate_below_deg_per_s = ") +
                        rate + "\n"));
  };
  const Outcome outcome = run("0.4", "7");
  // 37.08, 14.83 and 5.93 deg/s.
  const auto fails = notes_of(outcome, "latch: hinge does not engage");
  ASSERT_EQ(fails.size(), 2u);
  EXPECT_NEAR(fails[1].rate / degree, 0.4 * 37.0823233942, 1e-7);
  const auto latches = notes_of(outcome, "latch: hinge latches");
  ASSERT_EQ(latches.size(), 1u);
  EXPECT_NEAR(latches[0].time, 10.290617336545, 1e-9);
  EXPECT_NEAR(latches[0].rate / degree, 0.16 * 37.0823233942, 1e-7);
  EXPECT_EQ(notes_of(outcome, "hits its stop").size(), 2u);

  const Outcome rests = run("0", "7");
  EXPECT_EQ(notes_of(rests, "latch: hinge does not engage").size(), 1u);
  EXPECT_EQ(rests.modes[0], multibody::HingeMode::latched);
  // Without a stop it goes by.
  const Outcome past =
      run_of(run_for(13) + boom() +
             latch("angle_deg = 0\nrate_below_deg_per_s = 7\n"));
  EXPECT_EQ(notes_of(past, "latch: hinge does not engage").size(), 1u);
  EXPECT_GT(last(past, "boom.angle_deg"), 90);
}

// A body released by a later event moves on; its lock is not the latch.
TEST(CaseLatches, OpenAgain) {
  const Outcome outcome = run_of(
      run_for(10) + boom() + latch("angle_deg = 0\n") +
      "[[event]]\nname = \"open\"\nbreaks = \"latch\"\nafter = \"latch\"\n"
      "delay_s = 2\n");
  const auto opens = notes_of(outcome, "open: latch of hinge opens");
  ASSERT_EQ(opens.size(), 1u);
  EXPECT_NEAR(opens[0].time, 6.854064781389, 1e-10);
  const double t = 10 - opens[0].time;
  EXPECT_NEAR(last(outcome, "boom.angle_deg"), t * t / 15 / degree, 1e-7);
}

// Restitution of a compliant stop is exact in free flight, at any stiffness and
// speed; pressed on by a moment it comes to the rigid one as it gets stiffer.
TEST(CaseStops, CompliantOnesHaveTheirRestitution) {
  for (const char* rate : {"20", "40"}) {
    for (const char* e : {"1", "0.7", "0.2"}) {
      const Outcome outcome =
          run_of(run_for(8) +
                 boom(stop(std::string("angle_deg = 0\nrestitution = ") + e +
                           "\nstiffness_N_m_per_rad = 500"),
                      std::string("angle_deg = -90\nrate_deg_per_s = ") + rate,
                      false));
      const auto hits = notes_of(outcome, "hits its stop");
      ASSERT_EQ(hits.size(), 1u);
      EXPECT_NEAR(hits[0].rate / degree, std::stod(rate), 1e-9);
      EXPECT_NEAR(last(outcome, "boom.rate_deg_per_s"),
                  -std::stod(e) * std::stod(rate), 2e-8);
      EXPECT_GT(outcome.memory.bodies[0].peak_stop, 1);
    }
  }
}

TEST(CaseStops, SteepCompliantOnesAreRigid) {
  double before = 1e9;
  for (const char* k : {"1e4", "1e6", "1e8"}) {
    const Outcome outcome = run_of(
        run_for(13) + boom(stop(std::string("angle_deg = 0\nrestitution = 0.4\n"
                                            "stiffness_N_m_per_rad = ") +
                                k)));
    const auto hits = notes_of(outcome, "hits its stop");
    ASSERT_GT(hits.size(), 2u);
    EXPECT_NEAR(hits[0].time, 4.854064781389, 1e-9);
    // A touch takes some pi sqrt(J/k).
    const double off = std::abs(hits[2].time - 10.290617336545);
    EXPECT_LT(off, 12 * std::sqrt(15 / std::stod(k)));
    EXPECT_LT(off, 0.2 * before);
    before = off;
    EXPECT_NEAR(last(outcome, "boom.stop_moment_N_m"), 2, 1e-3);
    EXPECT_NEAR(last(outcome, "boom.angle_deg"), 2 / std::stod(k) / degree,
                1e-3 * 2 / std::stod(k) / degree);
  }
}

// A ball hinge has compliant ones: a spherical pendulum of no weight that turns
// about x comes back with e times its rate.
TEST(CaseStops, OnBallHinges) {
  const Outcome outcome = run_of(run_for(6) + R"(
[carrier]; name = "ground"; fixed = true
direction = [{ name = "up", vector = [0, 0, 1] }]
[[body]]; name = "ball"; mass_kg = 1; principal_inertia_kg_m2 = [2, 2, 2]
direction = [{ name = "up", vector = [0, 0, 1] }]
start = { angular_velocity_rad_per_s = [0.5, 0, 0] }
[body.hinge]; kind = "ball"; body_direction = "up"; carrier_direction = "up"
[[body.hinge.stop]]; angle_deg = 30; restitution = 0.5; stiffness_N_m_per_rad = 1e4
)"_toml);
  EXPECT_EQ(notes_of(outcome, "hits its stop").size(), 2u);
  EXPECT_NEAR(std::abs(last(outcome, "ball.wx_rad_per_s")), 0.125, 1e-8);
}

// A run that is saved in the middle of bounces, while what is left of them is
// counted, or on a compliant stop goes on to the same bytes.
TEST(CaseStops, SavedRunsGoOnTheSame) {
  const std::string rigid =
      run_for(13) + boom(stop("angle_deg = 0\nrestitution = 0.4"));
  const std::string soft = run_for(13) +
                           boom(stop("angle_deg = 0\nrestitution = 0.4\n"
                                     "stiffness_N_m_per_rad = 1000")) +
                           latch("angle_deg = 0.2\nrate_below_deg_per_s = 3\n");
  for (const std::string& text : {rigid, soft}) {
    const Case c = parse_case(text, "c.toml");
    const std::string identity = separation::identity_of(c, {});
    for (const double time : {4.9, 9.0, 11.3, 11.326151, 12.0}) {
      separation::Run whole(c, {});
      whole.advance_to(time);
      const std::string bytes = separation::saved_bytes(whole.save(), identity);
      whole.advance_to(13);
      separation::Run other(c, {});
      other.restore(separation::saved_state(bytes, identity));
      other.advance_to(13);
      EXPECT_EQ(separation::saved_bytes(other.save(), identity),
                separation::saved_bytes(whole.save(), identity))
          << time;
    }
  }
}

}  // namespace
}  // namespace contact::test::stops_test
