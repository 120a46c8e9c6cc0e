// Runs of hinge-separation whose balls are confined to their seats.
#include <gtest/gtest.h>

#include <string>

#include "libcontact/files/joint_file.hpp"
#include "libcontact/seat/joint.hpp"
#include "libcontact/seat/table.hpp"
#include "programs/separation/program_runs.hpp"

namespace contact::test {
namespace {

// A load of 12 t, the first two steps of its swing about the axis of its ring.
std::string swinging(const std::string& joint, const std::string& mass = "12") {
  return R"(name = "load"
gravity_m_per_s2 = [0, -9.81, 0]
[run]
end_time_s = 0.04
output_step_s = 0.02
integrator = "rk4"
step_s = 0.02
[carrier]
name = "crane"
fixed = true
[[body]]
name = "load"
mass_t = )" +
         mass + R"(
com_m = [0, -1, 0]
principal_inertia_kg_m2 = [3000, 3000, 3000]
[body.start]
angular_velocity_rad_per_s = [0, 0, 0.2]
[body.hinge]
kind = "ball"
[[body.hinge.joint]]
file = ")" CONTACT_DATA_DIR R"(/joints/spherical_plain_bearing_ge50.toml"
)" + joint;
}

TEST(SeparationSeat, SaysHowNearTheRimsContactsCome) {
  const ProgramFolder folder;
  folder.write("in.toml", swinging("in_seat = true\n"));
  const auto confined = folder.run_well("hinge-separation in.toml --output -");
  const json joint = json::parse(confined.out)["bodies"][0]["joints"][0];
  EXPECT_EQ(joint["least_rim_gap_m"], 0);
  for (const char* rim : {"lower", "upper"}) {
    EXPECT_NE(confined.err.find("the contact is at its " + std::string(rim) +
                                " rim, where the side face"),
              std::string::npos)
        << confined.err;
  }
  EXPECT_EQ(confined.err.find("not confined"), std::string::npos);
  folder.write("whole.toml", swinging(""));
  const auto whole = folder.run_well("hinge-separation whole.toml --output -");
  const json unbounded = json::parse(whole.out)["bodies"][0]["joints"][0];
  EXPECT_FALSE(unbounded.contains("least_rim_gap_m"));
  EXPECT_NE(whole.err.find("its pressures are not confined here"),
            std::string::npos);
  // By the confined law's own test: the peak at the rims, and more moment.
  EXPECT_GT(joint["peak_pressure_Pa"], unbounded["peak_pressure_Pa"]);
}

// A table that was kept answers as the contacts themselves, to its accuracy.
TEST(SeparationSeat, TakesATableThatWasKept) {
  const ProgramFolder folder;
  const JointSpec spec =
      read_joint(CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml");
  const SeatJoint seat(spec);
  const SeatTable table(seat.contact(),
                        {.least_load = 1e5, .most_load = 1.2e5});
  folder.write("ge50.table", table.bytes(spec));
  const auto moment = [&](const std::string& keys) {
    folder.write("in.toml", swinging("in_seat = true\n" + keys));
    const auto run = folder.run_well("hinge-separation in.toml --output -");
    const json joint = json::parse(run.out)["bodies"][0]["joints"][0];
    EXPECT_DOUBLE_EQ(joint["time_at_rim_s"], 0.04);
    return double(joint["largest_friction_moment_N_m"]);
  };
  const double kept = moment("seat_table = \"ge50.table\"\n");
  const double found = moment("");
  EXPECT_NEAR(kept / found, 1, 2e-3);  // two errors of 1e-3
  EXPECT_NE(kept, found);
  EXPECT_EQ(moment("seat_loads_kN = [100, 120]\n"), kept);
}

TEST(SeparationSeat, RefusesWhatIsNoSeat) {
  const ProgramFolder folder;
  const auto refused = [&](const std::string& text) {
    folder.write("c.toml", text);
    return folder.run("hinge-separation c.toml").err;
  };
  EXPECT_NE(refused(swinging("seat_loads_kN = [10, 100]\n"))
                .find("seat_loads_kN = [10, 100] requires in_seat = true"),
            std::string::npos)
      << refused(swinging("seat_loads_kN = [10, 100]\n"));
  EXPECT_NE(refused(swinging("in_seat = true\nseat_loads_kN = [100, 10]\n"))
                .find("must be a load and a larger one"),
            std::string::npos)
      << refused(swinging("in_seat = true\nseat_loads_kN = [100, 10]\n"));
  const auto said = [&](const std::string& keys) {
    return refused(swinging(keys));
  };
  EXPECT_NE(said("seat_table = \"t\"\n").find("requires in_seat = true"),
            std::string::npos)
      << said("seat_table = \"t\"\n");
  const std::string both =
      "in_seat = true\nseat_table = \"t\"\nseat_loads_kN = [10, 100]\n";
  EXPECT_NE(said(both).find("must be left out beside seat_table"),
            std::string::npos)
      << said(both);
  const std::string none = "in_seat = true\nseat_table = \"t\"\n";
  EXPECT_NE(said(none).find("t: cannot be read"), std::string::npos)
      << said(none);
  folder.write("t", "no table");
  EXPECT_NE(said(none).find("seat_table = \"t\": "), std::string::npos)
      << said(none);
  std::string pin = swinging("in_seat = true\n");
  const std::string ring = "spherical_plain_bearing_ge50";
  pin.replace(pin.find(ring), ring.size(), "gimbal_ball");
  EXPECT_NE(refused(pin).find("in_seat = true requires a ball with a [seat]"),
            std::string::npos)
      << refused(pin);
}

// As without in_seat, a warning says that.
TEST(SeparationSeat, TraditionalFrictionKnowsNoRims) {
  const ProgramFolder folder;
  std::string text = swinging("in_seat = true\n");
  text.insert(text.find("end_time_s"), "friction = \"traditional\"\n");
  folder.write("c.toml", text);
  EXPECT_NE(folder.run_well("hinge-separation c.toml")
                .err.find("its pressures are not confined here"),
            std::string::npos);
}

}  // namespace
}  // namespace contact::test
