// Engines that burn the mass of their bodies, against closed forms and momentum
// balances that include the escaped mass.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case_runs.hpp"
#include "support/error_message.hpp"
#include "support/toml_text.hpp"

namespace contact::test::mass_flow_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using separation::Case;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;

std::string run_for(double end, double step) {
  return "name = \"flow\"\n[run]\nend_time_s = " + std::to_string(end) +
         "\noutput_step_s = " + std::to_string(step) +
         "\nrelative_tolerance = 1e-13\nabsolute_tolerance = 1e-13\n";
}

const std::string stage = R"(
[carrier]; name = "stage"; mass_kg = 4300; principal_inertia_kg_m2 = [900, 2000, 2000]
[[force]]; name = "engine"; kind = "thrust"; body = "stage"; point_m = [-2, 0, 0]
direction = [1, 0, 0]; thrust_kN = 60; specific_impulse_s = 310
)"_toml;

// Tsiolkovsky: m = m0 - T t/v, v ln(m0/m), v t - (v m/q) ln(m0/m).
TEST(MassFlow, RocketEquation) {
  const Outcome outcome = run_of(run_for(20, 1) + stage);
  EXPECT_NEAR(last(outcome, "stage.mass_kg"), 3905.271143363, 1e-9);
  EXPECT_NEAR(last(outcome, "stage.vx_m_per_s"), 292.720854670529, 1e-9);
  EXPECT_NEAR(last(outcome, "stage.x_m"), 2880.240055357653, 1e-8);
  EXPECT_NEAR(last(outcome, "energy.balance_J"), 0,
              1e-11 * outcome.memory.largest_energy);
}

// Turning across the axis of the nozzle, l behind the centre of mass: (I w)' =
// -q l^2 w, I = I0 - s q t.
TEST(MassFlow, JetDamping) {
  const Outcome outcome = run_of(run_for(20, 20) + stage +
                                 R"(
propellant_kg = 1000; empty_principal_inertia_kg_m2 = [700, 1500, 1500]
[carrier.start]; angular_velocity_deg_per_s = [0, 0, 5]
)"_toml);
  const double burned = 60e3 * 20 / (310 * 9.80665);
  const double s = 0.5, l = 2;
  EXPECT_NEAR(last(outcome, "stage.wz_rad_per_s") / degree,
              5 * std::pow(1 - s * burned / 2000, (l * l - s) / s), 1e-9);
  // About the axis, on which nothing leaves with it, I w stays.
  const Outcome rolls = run_of(run_for(20, 20) + stage +
                               R"(
propellant_kg = 1000; empty_principal_inertia_kg_m2 = [700, 1500, 1500]
[carrier.start]; angular_velocity_deg_per_s = [5, 0, 0]
)"_toml);
  EXPECT_NEAR(last(rolls, "stage.wx_rad_per_s") / degree,
              5 / (1 - 0.2 * burned / 900), 1e-11);
}

// On a hinge on the ground, b from the centre of mass and L from the nozzle:
// J w' = T L + q (s - L^2) w, J = J0 - s q t.
TEST(MassFlow, OnAHinge) {
  const std::string boom = R"(
[carrier]; name = "ground"; fixed = true
[[body]]; name = "boom"; mass_kg = 20; com_m = [1.5, 0, 0]; principal_inertia_kg_m2 = [1, 5, 5]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]
[[force]]; name = "engine"; kind = "thrust"; body = "boom"; point_m = [2, 0, 0]
direction = [0, 1, 0]; thrust_N = 30; exhaust_speed_m_per_s = 100
)"_toml;
  const double s = 0.25 + 1.5 * 1.5, l = 2, q = 0.3, j0 = 5 + 20 * 1.5 * 1.5;
  const auto rate = [&](double t) {
    const double p = (l * l - s) / s;
    return 30 * l / (q * (l * l - s)) * (1 - std::pow(1 - s * q * t / j0, p));
  };
  const Outcome outcome = run_of(run_for(10, 10) + boom);
  EXPECT_NEAR(last(outcome, "boom.rate_deg_per_s") * degree, rate(10), 1e-10);
  EXPECT_NEAR(last(outcome, "energy.balance_J"), 0,
              1e-11 * outcome.memory.largest_energy);
  // The impulse of a latch takes J w of then.
  const Outcome caught = run_of(run_for(5, 5) + boom +
                                R"(
[[event]]; name = "catch"; locks = "hinge"; time_s = 4
)"_toml);
  EXPECT_NEAR(caught.memory.bodies[0].latch_impulse, (j0 - s * q * 4) * rate(4),
              1e-8);
  EXPECT_EQ(last(caught, "boom.rate_deg_per_s"), 0);
}

// Momentum and angular momentum of a tumbling body whose centre of mass moves,
// including the escaped mass; steady flow needs no impulse of its own. Accurate
// to the order of Simpson's rule over the rows.
TEST(MassFlow, KeepsMomentaWithWhatLeaves) {
  const double step = 0.001, end = 1;
  const Outcome outcome = run_of(run_for(end, step) +
                                 R"(
[carrier]; name = "tank"; mass_kg = 50; com_m = [0.2, 0, 0]; inertia_kg_m2 = [[9, 1, 0], [1, 12, 2], [0, 2, 14]]
[carrier.start]; velocity_m_per_s = [3, -4, 5]; angular_velocity_rad_per_s = [0.7, -0.4, 0.9]
[[force]]; name = "engine"; kind = "thrust"; body = "tank"; point_m = [-1, 0.3, 0.1]
direction = [2, 0.1, -0.2]; thrust_N = 120; exhaust_speed_m_per_s = 40
propellant_kg = 20; empty_com_m = [0.5, -0.1, 0.05]; empty_principal_inertia_kg_m2 = [5, 7, 8]
)"_toml);
  const double thrust = 120, q = 3, m0 = 50;
  Matrix3d full;
  full << 9, 1, 0, 1, 12, 2, 0, 2, 14;
  const Matrix3d slope = (full - Matrix3d(Vector3d(5, 7, 8).asDiagonal())) / 20;
  const Vector3d moves = q * Vector3d(0.3, -0.1, 0.05) / 20;  // c'
  const Vector3d nozzle(-1.2, 0.3, 0.1),
      along = Vector3d(2, 0.1, -0.2).normalized();
  const Rows& rows = outcome.memory.rows;
  const std::size_t x = rows.column("tank.x_m");
  const auto vector = [&](std::size_t row, std::size_t from) {
    return Vector3d(rows.at(row, from), rows.at(row, from + 1),
                    rows.at(row, from + 2));
  };
  Vector3d left = Vector3d::Zero(), left_turn = left;
  Vector3d first, first_turn;
  const std::size_t count = rows.size();
  ASSERT_EQ(count % 2, 1u);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = rows.at(i, 0), m = m0 - q * t;
    const Matrix3d r = Eigen::Quaterniond(rows.at(i, x + 6), rows.at(i, x + 7),
                                          rows.at(i, x + 8), rows.at(i, x + 9))
                           .toRotationMatrix();
    const Vector3d w = vector(i, x + 10);
    const Vector3d c = moves * t, arm = nozzle - c;
    const Vector3d place = vector(i, x) + r * c;
    const Vector3d v = vector(i, x + 3) + r * w.cross(c);
    const Vector3d flow = r * (q * arm + m * moves);
    const Vector3d momentum = m * v + flow;
    const Vector3d turn =
        place.cross(momentum) + r * (full - slope * q * t) * w;
    // Momentum of the mass that leaves in a second, and of the flow that
    // begins.
    const Vector3d out = q * (v + r * w.cross(arm)) - thrust * (r * along);
    const Vector3d begins = -2 * q * (r * moves);
    const Vector3d out_turn = (place + r * arm).cross(out) -
                              place.cross(begins) - q * (r * moves.cross(arm));
    const double weight = i == 0 || i + 1 == count ? 1 : i % 2 == 1 ? 4 : 2;
    left += weight * step / 3 * (out - begins);
    left_turn += weight * step / 3 * out_turn;
    if (i == 0) {
      first = momentum;
      first_turn = turn;
    }
    if (i + 1 < count) continue;
    EXPECT_NEAR(rows.at(i, rows.column("tank.mass_kg")), m, 1e-12);
    // h^4/180 of the fourth derivatives, (5 rad/s)^4 of 1e3 N or N m, and the
    // tolerance.
    EXPECT_LT((momentum + left - first).norm(), 1e-8);
    EXPECT_LT((turn + left_turn - first_turn).norm(), 1e-8);
  }
  EXPECT_NEAR(outcome.memory.largest_drift, 0,
              1e-10 * outcome.memory.largest_energy);
}

// A list of thrusts, a cutoff with its decay, and the end at the propellant.
TEST(MassFlow, EndsWhereItIsUsedUp) {
  const std::string body = R"(
[carrier]; name = "bus"; mass_kg = 100; principal_inertia_kg_m2 = [10, 10, 10]
[[force]]; name = "engine"; kind = "thrust"; body = "bus"; point_m = [-1, 0, 0]
direction = [1, 0, 0]; exhaust_speed_m_per_s = 10; starts_at_s = 0.5
time_s = [0, 1, 1, 3]; thrust_N = [0, 20, 40, 80]
)"_toml;
  const auto run = [&](const std::string& keys) {
    std::string text = run_for(6, 1) + body + keys;
    text.insert(text.find("[run]"), "gravity_m_per_s2 = [0, 0, -9.81]\n");
    return run_of(text);
  };
  // 10 N s by 1 s, then 40 u + 10 u^2 N s: 60 N s more after u s.
  const Outcome empty = run("propellant_kg = 7\n");
  const double u = -2 + std::sqrt(10.);
  ASSERT_EQ(empty.memory.notes.size(), 1u);
  EXPECT_EQ(empty.memory.notes[0].what, "engine: propellant is used up");
  EXPECT_EQ(empty.memory.notes[0].body, "bus");
  EXPECT_NEAR(empty.memory.notes[0].time, 1.5 + u, 1e-13);
  EXPECT_EQ(last(empty, "bus.mass_kg"), 93);
  EXPECT_NEAR(last(empty, "bus.vx_m_per_s"), 10 * std::log(100 / 93.), 1e-10);
  EXPECT_NEAR(last(empty, "energy.balance_J"), 0, 1e-7);
  // 70 N s by 2 s after the beginning, then 60 N exp(-t/0.5 s).
  const std::string cut = "cutoff_at_s = 2.5\ndecay_s = 0.5\n";
  const Outcome decays = run(cut);
  EXPECT_NEAR(last(decays, "bus.mass_kg"),
              100 - (60 + 30 * (1 - std::exp(-3.5 / 0.5))) / 10, 1e-12);
  const Outcome late = run(cut + "propellant_kg = 8\n");
  ASSERT_EQ(late.memory.notes.size(), 1u);
  EXPECT_NEAR(late.memory.notes[0].time, 2.5 + 0.5 * std::log(3), 1e-13);
  EXPECT_EQ(run("propellant_kg = 9.5\n" + cut).memory.notes.size(), 0u);
}

// A saved run continues bit-identically, before and after the end of the
// engine.
TEST(MassFlow, SavedRunsGoOnTheSame) {
  const Case c = parse_case(run_for(8, 1) + stage +
                                R"(
propellant_kg = 100
[carrier.start]; angular_velocity_deg_per_s = [1, 2, 3]
)"_toml,
                            "c.toml");
  for (const double time : {2.0, 7.0}) {
    separation::Run run(c), other(c);
    run.advance_to(time);
    const std::string identity = separation::identity_of(c, {});
    other.restore(separation::saved_state(
        separation::saved_bytes(run.save(), identity), identity));
    run.advance_to(8);
    other.advance_to(8);
    EXPECT_EQ(run.memory().rows.numbers, other.memory().rows.numbers);
    ASSERT_EQ(other.memory().notes.size(), 1u);
    EXPECT_EQ(run.memory().notes[0].time, other.memory().notes[0].time);
  }
}

// An end before the beginning: nothing burns, and nothing comes back.
TEST(MassFlow, OfAnEmptyWindowIsNone) {
  const Outcome outcome = run_of(run_for(10, 10) + R"(
[carrier]; name = "core"; mass_kg = 1000; principal_inertia_kg_m2 = [900, 900, 900]
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[body.hinge]; kind = "ball"
[[event]]; name = "go"; time_s = 3; breaks = "hinge"
[[force]]; name = "e"; kind = "thrust"; body = "b"; point_m = [-1, 0, 0]
direction = [1, 0, 0]; thrust_N = 200; exhaust_speed_m_per_s = 100; propellant_kg = 30
starts_at_s = 5; ends_at_event = "go"
)"_toml);
  EXPECT_EQ(last(outcome, "b.mass_kg"), 50);
}

// More than there is, with all engines of a body: by the reader, which knows
// the place.
TEST(MassFlow, RefusesToBurnTheBody) {
  const auto message = [](const std::string& keys, double end = 20) {
    return error_message(
        [&] { parse_case(run_for(end, end) + stage + keys, "c.toml"); });
  };
  EXPECT_EQ(
      message("propellant_kg = 4300\n"),
      "c.toml:20: force[1].propellant_kg = 4300: what may be burned, 4300 "
      "kg, must be less than the mass that other engines leave, 4300 kg "
      "of 4300");
  EXPECT_EQ(message("", 300),
            "c.toml:18: force[1].thrust_kN = 60: what may be burned, 5920.93 "
            "kg, must be less than the mass that other engines leave, 4300 kg "
            "of 4300");
  EXPECT_EQ(
      message(
          "propellant_kg = 2000\n" +
          stage.substr(stage.find("[[force]]")).replace(17, 8, "\"second\"") +
          "propellant_kg = 2500\n"),
      "c.toml:29: force[2].propellant_kg = 2500: what may be burned, 2500 kg, "
      "must be less than the mass that other engines leave, 2300 kg of 4300");
  EXPECT_EQ(
      message("propellant_kg = 9\nempty_principal_inertia_kg_m2 = [900, "
              "2000, 2001]\n"),
      "c.toml:21: force[1].empty_principal_inertia_kg_m2 = [900, 2000, "
      "2001] must be about no axis above the inertia of the body with its "
      "propellant");
}

// An engine without propellant that an event ends: until then it may burn what
// it wants, up to the whole body.
TEST(MassFlow, EndsByAnEvent) {
  const std::string text = R"(
[carrier]; name = "core"; mass_kg = 1000; principal_inertia_kg_m2 = [900, 900, 900]
[[body]]; name = "b"; mass_kg = 50; principal_inertia_kg_m2 = [5, 5, 5]
[body.hinge]; kind = "ball"
[[force]]; name = "e"; kind = "thrust"; body = "b"; point_m = [-1, 0, 0]
direction = [1, 0, 0]; thrust_N = 200; exhaust_speed_m_per_s = 100
ends_at_event = "off"
[[event]]; name = "off"; breaks = "hinge"; time_s = )"_toml;
  const Outcome outcome = run_of(run_for(30, 30) + text + "3\n");
  EXPECT_NEAR(last(outcome, "b.mass_kg"), 50 - 2 * 3, 1e-12);
  const Outcome all =
      run_case(parse_case(run_for(30, 30) + text + "29\n", "c.toml"));
  EXPECT_EQ(all.failure,
            "t = 25 s: an engine has burned all of its body: give it a "
            "propellant, or an end before");
}

// A point on a thread does not spin, which masses that change cannot have.
TEST(MassFlow, RefusesAThreadByItsName) {
  EXPECT_EQ(
      error_message([&] {
        parse_case(run_for(1, 1) + stage + R"(
[[body]]; name = "bob"; mass_kg = 5; com_m = [0, 0, 1]; principal_inertia_kg_m2 = [1, 1, 0]
[body.hinge]; kind = "ball"
)"_toml,
                   "c.toml");
      }),
      "c.toml:25: body[1].principal_inertia_kg_m2 = [1, 1, 0] must be "
      "above 0 about the line from the hinge to the centre of mass, where "
      "engines burn mass");
}

}  // namespace
}  // namespace contact::test::mass_flow_test
