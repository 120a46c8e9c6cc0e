// Runs of hinge-separation whose balls are in seats that end.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libcontact/files/joint_file.hpp"
#include "libcontact/joint/joint.hpp"
#include "programs/separation/program_runs.hpp"

namespace contact::test::seat_test {
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

json joint_of(const ProgramResult& run) {
  return json::parse(run.out)["bodies"][0]["joints"][0];
}

// A ball on a ball hinge is in its seat by default.
TEST(SeparationSeat, SaysHowNearTheRimsContactsCome) {
  const ProgramFolder folder;
  folder.write("in.toml", swinging(""));
  const auto confined =
      folder.run_well("hinge-separation in.toml --output - --history h.csv");
  const json joint = joint_of(confined);
  EXPECT_EQ(joint["least_rim_gap_m"], 0);
  EXPECT_NE(
      confined.err.find("the contact is at both its rims. The model neglects"),
      std::string::npos)
      << confined.err;
  EXPECT_EQ(confined.err.find("is not confined"), std::string::npos);
  // A contact at a rim has no half-angle.
  EXPECT_TRUE(joint["largest_theta0_deg"].is_null());
  const History history(folder.read("h.csv"));
  for (std::size_t i = 0; i < history["time_s"].size(); ++i) {
    EXPECT_TRUE(std::isnan(history["load.theta0_deg"][i]));
    EXPECT_GT(history["load.peak_pressure_Pa"][i], 1e8);
  }
  folder.write("whole.toml", swinging("without_seat = true\n"));
  const auto whole = folder.run_well("hinge-separation whole.toml --output -");
  const json unbounded = joint_of(whole);
  EXPECT_FALSE(unbounded.contains("least_rim_gap_m"));
  EXPECT_GT(unbounded["largest_theta0_deg"], 25);
  EXPECT_NE(whole.err.find("the contact is not confined here"),
            std::string::npos);
  // By the confined law's own test: the peak at the rims, and more moment.
  EXPECT_GT(joint["peak_pressure_Pa"], unbounded["peak_pressure_Pa"]);
}

// A table that was kept answers as the contacts themselves, to its accuracy.
TEST(SeparationSeat, TakesATableThatWasKept) {
  const ProgramFolder folder;
  const JointSpec spec =
      read_joint(CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml");
  folder.write(
      "ge50.table",
      Joint(spec).tabulated({.least_load = 1e5, .most_load = 1.2e5}).table());
  const auto moment = [&](const std::string& keys) {
    folder.write("in.toml", swinging(keys));
    const auto run = folder.run_well("hinge-separation in.toml --output -");
    const json joint = joint_of(run);
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
  const auto refused = [&](const std::string& keys,
                           const std::string& options = "") {
    folder.write("c.toml", swinging(keys));
    const ProgramResult run =
        folder.run("hinge-separation c.toml --output s.json" + options);
    EXPECT_EQ(run.status, 2);
    EXPECT_FALSE(folder.has("s.json"));
    return run.err;
  };
  folder.write("t", "no table");
  const struct {
    std::string keys, said;
  } cases[] = {
      {"in_seat = true\n",
       "in_seat = true must be left out: a ball with a [seat] is in it; "
       "without_seat = true for the endless one"},
      {"without_seat = true\nseat_loads_kN = [10, 100]\n",
       "seat_loads_kN = [10, 100] requires a ball in a [seat]"},
      {"without_seat = true\nseat_table = \"t\"\n",
       "seat_table = \"t\" requires a ball in a [seat]"},
      {"seat_loads_kN = [100, 10]\n", "must be a load and a larger one"},
      {"seat_table = \"t\"\nseat_loads_kN = [10, 100]\n",
       "must be left out beside seat_table"},
      {"seat_table = \"none\"\n", "none: cannot be read"},
      {"seat_table = \"t\"\n", "seat_table = \"t\": not a table of a seat"},
  };
  for (const auto& [keys, said] : cases) {
    EXPECT_TRUE(has_text(refused(keys), said)) << refused(keys);
  }
  // R in the place of R_n knows no rims; the laws are exact.
  const std::string traditional =
      "friction traditional of joint \"spherical plain bearing, 66 mm ball in "
      "a ring of 28 mm\" requires without_seat = true";
  for (const char* options : {" --friction traditional", " --compare"}) {
    EXPECT_TRUE(has_text(refused("", options), traditional));
  }
  EXPECT_TRUE(has_text(
      folder.run("hinge-separation data/cases/crane.toml --law fitted").err,
      "a joint in a seat that ends requires the laws exact, or without_seat"));
  folder.run_well("hinge-separation c.toml --friction ideal");
}

// There is no peak, not 0, if every contact hides its own: of 120 N on the
// lined ring, 20 deg from its axis, in a contact of 1 deg.
TEST(SeparationSeat, HiddenPeaksAreNoNumber) {
  const ProgramFolder folder;
  std::string text = swinging("", "0.012");
  const std::string down = "[0, -9.81, 0]";
  text.replace(text.find(down), down.size(), "[0, -3.4, -9.2]");
  folder.write("in.toml", text);
  const auto run =
      folder.run_well("hinge-separation in.toml --output - --history h.csv");
  EXPECT_TRUE(joint_of(run)["peak_pressure_Pa"].is_null());
  EXPECT_GT(joint_of(run)["largest_friction_moment_N_m"], 0);
  EXPECT_TRUE(has_text(run.err,
                       "no largest pressure: at the reported distance of 0.66"))
      << run.err;
  const History history(folder.read("h.csv"));
  EXPECT_TRUE(std::isnan(history["load.peak_pressure_Pa"][0]));
}

// Both solve their contacts again where the run was saved.
TEST(SeparationSeat, GoesOnFromACheckpointAtARim) {
  const ProgramFolder folder;
  folder.write("c.toml", swinging(""));
  const std::string run = "hinge-separation c.toml --output ";
  folder.run_well(run +
                  "a.json --history a.csv --checkpoint c.cbor "
                  "--checkpoint-every 0.02");
  folder.run_well(run + "b.json --history b.csv --resume c.cbor");
  EXPECT_EQ(folder.read("a.csv"), folder.read("b.csv"));
  const auto bodies = [&](const char* file) {
    return json::parse(folder.read(file))["bodies"];
  };
  EXPECT_EQ(bodies("a.json"), bodies("b.json"));
}

}  // namespace
}  // namespace contact::test::seat_test
