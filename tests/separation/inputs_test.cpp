// Loads that a run takes between its steps, against closed forms.
#include "separation/simulation/inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/results/run.hpp"
#include "separation/results/saved_state.hpp"
#include "support/error_message.hpp"
#include "support/toml_text.hpp"

namespace contact::test::inputs_test {
namespace {

using separation::Case;
using separation::parse_case;
using CaseRun = separation::Run;

constexpr double pi = 3.141592653589793;

Case case_of(const std::string& bodies, double end = 10) {
  return parse_case(
      "name = \"inputs\"\n[run]\nend_time_s = " + std::to_string(end) +
          "\noutput_step_s = 1\nrelative_tolerance = 1e-13\n"
          "absolute_tolerance = 1e-13\n" +
          bodies,
      "c.toml");
}
double value(const CaseRun& run, const std::string& column) {
  return run.values()[run.memory().rows.column(column)];
}
void set(CaseRun& run, const std::string& name, double to) {
  auto values = run.input_values();
  values[run.input(name)] = to;
  run.set_inputs(values);
}

const std::string bus = R"(
[carrier]; name = "bus"; mass_kg = 20; principal_inertia_kg_m2 = [4, 5, 6]
[carrier.start]; rotation_deg = [0, 0, 90]
)"_toml;
// A hinge on the ground.
const std::string boom = R"(
[carrier]; name = "ground"; fixed = true
[[body]]; name = "boom"; mass_kg = 20; com_m = [1.5, 0, 0]; principal_inertia_kg_m2 = [1, 5, 5]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]
)"_toml;
constexpr double boom_inertia = 5 + 20 * 1.5 * 1.5;

TEST(Inputs, AreThoseOfTheBodies) {
  const Case c = case_of(bus + boom.substr(boom.find("[[body]]")));
  std::vector<std::string> names;
  for (const auto& input : separation::inputs_of(c)) {
    names.push_back(input.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "bus.applied_force_x_N", "bus.applied_force_y_N",
                       "bus.applied_force_z_N", "bus.applied_moment_x_N_m",
                       "bus.applied_moment_y_N_m", "bus.applied_moment_z_N_m",
                       "boom.applied_force_x_N", "boom.applied_force_y_N",
                       "boom.applied_force_z_N", "boom.applied_moment_x_N_m",
                       "boom.applied_moment_y_N_m", "boom.applied_moment_z_N_m",
                       "boom.applied_hinge_moment_N_m"}));
  EXPECT_EQ(separation::inputs_of(case_of(boom)).size(), 7u);
}

// A force in the body's axes and a moment: t^2/2 and t from when they are set,
// and their work.
TEST(Inputs, AreConstantOverAStep) {
  CaseRun run(case_of(bus));
  run.advance_to(1.37);
  set(run, "bus.applied_force_x_N", 3);
  set(run, "bus.applied_moment_z_N_m", 0);  // equal: nothing
  // As before, at this time.
  EXPECT_EQ(value(run, "bus.vy_m_per_s"), 0);
  run.advance_to(3.37);
  EXPECT_NEAR(value(run, "bus.vy_m_per_s"), 3. / 20 * 2, 1e-13);
  EXPECT_NEAR(value(run, "bus.y_m"), 3. / 20 * 2, 1e-12);
  EXPECT_NEAR(value(run, "bus.x_m"), 0, 1e-15);
  set(run, "bus.applied_force_x_N", 0);
  set(run, "bus.applied_moment_z_N_m", 0.5);
  run.advance_to(7.37);
  EXPECT_NEAR(value(run, "bus.wz_rad_per_s"), 0.5 / 6 * 4, 1e-13);
  const double turned =
      2 * std::atan2(value(run, "bus.qz"), value(run, "bus.qw"));
  EXPECT_NEAR(turned, pi / 2 + 0.5 / 6 * 8, 1e-11);
  EXPECT_NEAR(value(run, "energy.active_work_J"), 20 / 2. * 0.09 + 6 / 2. / 9,
              1e-12);
  EXPECT_NEAR(value(run, "energy.balance_J"), 0, 1e-12);
}

// A controller with a hold, phi -> phi + w h + M h^2/(2 J), w -> w + M h/J,
// and the same hinge with friction, which a small moment does not move.
TEST(Inputs, TurnAHinge) {
  CaseRun run(case_of(boom));
  const double h = 0.05, wanted = 0.4;
  double phi = 0, w = 0;
  for (int i = 0; i < 200; ++i) {
    run.advance_to(i * h);
    const double angle = value(run, "boom.angle_deg") * degree;
    const double rate = value(run, "boom.rate_deg_per_s") * degree;
    ASSERT_NEAR(angle, phi, 1e-11);
    ASSERT_NEAR(rate, w, 1e-11);
    set(run, "boom.applied_hinge_moment_N_m",
        60 * (wanted - angle) - 80 * rate);
    const double moment = 60 * (wanted - phi) - 80 * w;
    phi += w * h + moment / boom_inertia * h * h / 2;
    w += moment / boom_inertia * h;
  }
  EXPECT_NEAR(phi, wanted, 1e-3);
  EXPECT_LT(run.memory().largest_drift, 1e-11);
}

const std::string rubbing = boom + R"(
[[body.hinge.joint]]; name = "pin"; kind = "pin"
geometry = { radius_mm = 30, radial_clearance_um = 60, length_mm = 80 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.2 }
[[force]]; name = "weight"; kind = "applied"; body = "boom"; axes = "inertial"; force_N = [200, 0, 0]
)"_toml;

// Friction about f R r = 1.2 N m: what is below does not move it, what is above
// does so at once, which is an event.
TEST(Inputs, OvercomeFriction) {
  CaseRun run(case_of(rubbing));
  set(run, "boom.applied_hinge_moment_N_m", 1);
  run.advance_to(2.5);
  EXPECT_EQ(value(run, "boom.angle_deg"), 0);
  EXPECT_TRUE(run.memory().notes.empty());
  set(run, "boom.applied_hinge_moment_N_m", 1.6);
  run.advance_to(4);
  ASSERT_FALSE(run.memory().notes.empty());
  EXPECT_EQ(run.memory().notes[0].time, 2.5);
  EXPECT_EQ(run.memory().notes[0].what, "begins to slide");
  EXPECT_GT(value(run, "boom.angle_deg"), 0);
}

// On two free bodies the moment of a hinge conserves angular momentum, and it
// ends with the hinge.
TEST(Inputs, OfAHingeActOnBothAndEndWithIt) {
  CaseRun run(case_of(bus + boom.substr(boom.find("[[body]]")) + R"(
[[event]]; name = "off"; breaks = "hinge"; time_s = 2
)"_toml));
  set(run, "boom.applied_hinge_moment_N_m", 3);
  const auto momentum = [&] {
    const auto& motions = run.sample().motions();
    double sum = 6 * motions[0].angular_velocity.z() +
                 5 * motions[1].angular_velocity.z();
    for (const auto& motion : motions) {
      sum += 20 * motion.position.cross(motion.velocity).z();
    }
    return sum;
  };
  run.advance_to(1.9);
  EXPECT_GT(value(run, "boom.rate_deg_per_s"), 10);
  EXPECT_NEAR(momentum(), 0, 1e-11);
  run.advance_to(2.1);
  const double rate = value(run, "boom.wz_rad_per_s");
  run.advance_to(9);
  EXPECT_NEAR(value(run, "boom.wz_rad_per_s"), rate, 1e-12);
  EXPECT_NEAR(momentum(), 0, 1e-10);
}

// Saved with inputs, also with those that are to act from here on.
TEST(Inputs, AreSaved) {
  for (const bool pending : {false, true}) {
    const Case c = case_of(rubbing);
    CaseRun run(c), other(c);
    set(run, "boom.applied_hinge_moment_N_m", 1.6);
    run.advance_to(1.23);
    if (pending) set(run, "boom.applied_force_y_N", 7);
    const std::string identity = separation::identity_of(c, {});
    other.restore(separation::saved_state(
        separation::saved_bytes(run.save(), identity), identity));
    EXPECT_EQ(other.input_values(), run.input_values());
    CaseRun copy(run);
    for (CaseRun* of : {&run, &other, &copy}) {
      of->advance_to(5);
      set(*of, "boom.applied_hinge_moment_N_m", -1);
      of->advance_to(10);
      EXPECT_EQ(of->memory().rows.numbers, run.memory().rows.numbers);
      EXPECT_EQ(of->memory().notes.size(), run.memory().notes.size());
    }
  }
}

TEST(Inputs, RefuseWhatTheyCannotBe) {
  CaseRun run(case_of(boom));
  EXPECT_EQ(error_message([&] { run.input("boom.applied_force_x"); }),
            "unknown input \"boom.applied_force_x\": did you mean "
            "\"boom.applied_force_x_N\"?");
  EXPECT_EQ(error_message([&] {
              run.set_inputs({1, 2});
            }),
            "2 inputs must be 7");
  EXPECT_EQ(error_message([&] { set(run, "boom.applied_force_z_N", NAN); }),
            "boom.applied_force_z_N = nan must be finite");
  EXPECT_EQ(run.input_values(), std::vector<double>(7));
}

}  // namespace
}  // namespace contact::test::inputs_test
