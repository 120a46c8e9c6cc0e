// Runs of hinge-separation that are stopped and resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>
#include <utility>

#include "programs/separation/program_runs.hpp"

namespace contact::test::checkpoint_test {
namespace {

void expect_another_case(const ProgramResult& result,
                         const std::string& checkpoint) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, "hinge-separation: " + checkpoint +
                            ": the checkpoint must be one of this case file, "
                            "these joints and these options\n");
}

// Histories, events and summaries of two runs, "a" and "b"; byte by byte, and
// too long to be printed.
void expect_same_results(const ProgramFolder& folder, const std::string& what) {
  EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv")) << what;
  EXPECT_EQ(folder.read("ae.csv"), folder.read("be.csv")) << what;
  json a = json::parse(folder.read("a.json"));
  json b = json::parse(folder.read("b.json"));
  a.erase("counts");
  b.erase("counts");
  EXPECT_EQ(a, b) << what;
}

TEST(Checkpoint, ResumedRunIsTheSame) {
  const ProgramFolder folder;
  // The last checkpoint is gone on from: wheels that slide and rest, arms that
  // have come off and others, free boosters.
  const auto compare = [&](const std::string& name, const char* every,
                           const char* column) {
    const std::string run = "hinge-separation data/cases/" + name + ".toml ";
    const std::string checkpoint =
        std::string(" --checkpoint-every ") + every + " --checkpoint ";
    folder.run_well(run + "--history a.csv --events ae.csv --output a.json" +
                    checkpoint + "c.db");
    folder.run_well(run +
                    "--history b.csv --events be.csv --output b.json "
                    "--resume c.db" +
                    checkpoint + "d.db");
    expect_same_results(folder, name);
    // Without a checkpoint: other steps, the same motion to their tolerance.
    folder.run_well(run + "--history s.csv");
    const History with(folder.read("a.csv"));
    const History without(folder.read("s.csv"));
    ASSERT_EQ(with.size(), without.size()) << name;
    const double last = without[column].back();
    EXPECT_NEAR(with[column].back(), last, 1e-6 * std::abs(last)) << name;
  };
  compare("flywheels", "21", "wheel_x.angle_deg");
  compare("platform", "2", "arm_2.friction_work_J");
  compare("soyuz", "5", "booster_1.x_m");

  expect_another_case(
      folder.run("hinge-separation data/cases/slosh.toml --resume c.db"),
      "c.db");
  folder.write("bad.db", "nonsense");
  EXPECT_EQ(
      folder.run("hinge-separation data/cases/soyuz.toml --resume bad.db").err,
      "hinge-separation: bad.db: the file must be a checkpoint of "
      "hinge-separation\n");
}

// Prolonged or cut short on resuming: as if the end had been so from the start.
TEST(Checkpoint, ResumedRunsEndWhenTheyAreTold) {
  const ProgramFolder folder;
  const std::string run = "hinge-separation data/cases/platform.toml ";
  const auto at_once = [&](const std::string& end) {
    folder.run_well(run +
                    "--history a.csv --events ae.csv --output a.json "
                    "--checkpoint-every 2 --checkpoint a.db --end-time " +
                    end);
  };
  at_once("8");
  std::rename((folder.path() / "a.db").c_str(),
              (folder.path() / "c.db").c_str());
  // 9.03 s is no output time.
  for (const std::string end : {"12", "9.03", "8"}) {
    at_once(end);
    folder.run_well(run +
                    "--history b.csv --events be.csv --output b.json "
                    "--resume c.db --end-time " +
                    end);
    expect_same_results(folder, end);
    EXPECT_EQ(json::parse(folder.read("b.json"))["end_time_s"],
              cli::parse_number(end).value());
  }
  folder.run_ill(run + "--resume c.db --end-time 7.9", 2,
                 "hinge-separation: c.db: a checkpoint at t = 8 s requires "
                 "--end-time of 8 s or above: this run ends at 7.9 s\n");
  // The row of an end that is no output time stays.
  folder.run_well(run +
                  "--end-time 8.03 --checkpoint-every 8.01 --checkpoint d.db");
  folder.run_well(run + "--resume d.db --end-time 12 --history d.csv");
  at_once("12");
  const History d(folder.read("d.csv"));
  const History a(folder.read("a.csv"));
  EXPECT_EQ(d.size(), a.size() + 1);
  EXPECT_NEAR(d["arm_2.angle_deg"].back(), a["arm_2.angle_deg"].back(), 1e-5);
}

// Comments, blanks and the notation of numbers are not what is run.
TEST(Checkpoint, CheckpointsAreOfWhatTheCaseSays) {
  const ProgramFolder folder;
  const std::string text = pushed_case(0, 0, "");
  const auto resumed = [&](const std::string& changed) {
    folder.write("c.toml", changed);
    return folder.run("hinge-separation c.toml --history b.csv --resume c.db");
  };
  folder.write("c.toml", text);
  folder.run_well(
      "hinge-separation c.toml --history a.csv --checkpoint "
      "c.db --checkpoint-every 1.5");
  for (const std::string& same :
       {"# by hand\n\n" + text,
        exchanged(text, "mass_kg = 10", "  mass_kg=1.0e1 #"),
        exchanged(text, "[carrier]\nname = \"c\"\nmass_kg = 10",
                  "[carrier]\nmass_kg = 10\nname = \"c\"")}) {
    const ProgramResult result = resumed(same);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv"));
  }
  const ProgramResult other =
      resumed(exchanged(text, "mass_kg = 10", "mass_kg = 11"));
  expect_another_case(other, "c.db");
}

TEST(Checkpoint, CheckpointsKnowTheirJoints) {
  const ProgramFolder folder;
  std::string text = alone;
  const auto begin = text.find("name = \"ball\"");
  const auto end = text.find("[body.lock]");
  folder.write("ball.toml", text.substr(begin, end - begin));
  text.replace(begin, end - begin, "file = \"ball.toml\"\n");
  folder.write("c.toml", text);
  const std::string run = "hinge-separation c.toml --output o.json ";
  folder.run_well(run + "--checkpoint c.db --checkpoint-every 1");
  folder.run_well(run + "--resume c.db");
  const std::string ball = exchanged(folder.read("ball.toml"),
                                     "coefficient = 0.2", "coefficient = 0.3");
  folder.write("ball.toml", ball);
  const ProgramResult other = folder.run(run + "--resume c.db");
  expect_another_case(other, "c.db");

  // A wall is known by its thickness and its backing.
  const auto with_wall = [&](const std::string& thickness,
                             const std::string& backing) {
    folder.write("ball.toml",
                 ball + "wall.backing = \"" + backing +
                     "\"\n[[wall.layer]]\nthickness_mm = " + thickness + '\n');
  };
  with_wall("3", "rigid");
  folder.run_well(run +
                  "--checkpoint w.db "
                  "--checkpoint-every 1");
  folder.run_well(run + "--resume w.db");
  for (const auto& [thickness, backing] :
       {std::pair("4", "rigid"), std::pair("3", "held")}) {
    with_wall(thickness, backing);
    expect_another_case(folder.run(run + "--resume w.db"), "w.db");
  }
  EXPECT_EQ(folder.run("hinge-separation c.toml --law tanh").err,
            "hinge-separation: --law tanh: joint \"ball\": half-angle law tanh "
            "must be exact with finite walls\n");
}

TEST(Checkpoint, CheckpointsStayWholeAndSmall) {
  const ProgramFolder folder;
  const std::string run = "hinge-separation data/cases/slosh.toml ";
  const auto checkpoints = [&](const char* name, const char* every) {
    folder.run_well(run + "--output o.json --history h.csv --checkpoint " +
                    name + " --checkpoint-every " + every);
  };
  // 0.3 s is no multiple of the output step of 0.05 s in doubles.
  checkpoints("c.db", "0.3");
  const std::string history = folder.read("h.csv");
  EXPECT_EQ(folder.files(), (Texts{"c.db", "h.csv", "o.json"}));
  // States at 11 s and at 19.9 s: they grow only by numbers that have more
  // digits.
  checkpoints("early.db", "11");
  checkpoints("late.db", "19.9");
  const auto ask = [&](const std::string& name, const std::string& what) {
    const ProgramResult said =
        folder.run_well("sqlite3 " + name + " 'SELECT " + what + "'");
    return std::stod(said.out);
  };
  const std::string state = "length(state) FROM state";
  EXPECT_NEAR(ask("late.db", state), ask("early.db", state), 100);
  // Rows once, 8 bytes and a sign for each number, and little else.
  const std::size_t rows = std::count(history.begin(), history.end(), '\n') - 1;
  const std::size_t columns = csv_rows(history)[0].size();
  EXPECT_EQ(ask("c.db", "count(*) FROM blocks"), 66);
  EXPECT_LT(ask("c.db", "sum(length(block)) FROM blocks"),
            10.0 * static_cast<double>(rows * columns));

  // Resumed with the same interval by default, and into the same file.
  const auto resumed = [&](const std::string& more) {
    return folder.run(run + "--output r.json --history r.csv --resume " + more);
  };
  EXPECT_EQ(resumed("c.db").status, 0);
  EXPECT_TRUE(folder.read("r.csv") == history);
  checkpoints("m.db", "13");
  EXPECT_EQ(resumed("m.db --checkpoint m.db --checkpoint-every 3").status, 0);
  EXPECT_EQ(resumed("m.db").status, 0);
  EXPECT_EQ(ask("m.db", "count(*) FROM blocks"), 2);
  checkpoints("m.db", "13");
  EXPECT_EQ(ask("m.db", "count(*) FROM blocks"), 1);

  const auto refused = [&](const std::string& expected) {
    const ProgramResult result = resumed("m.db");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "hinge-separation: m.db: " + expected + '\n');
  };
  folder.run_well("mv m.db moved.db");
  EXPECT_EQ(resumed("moved.db").status, 0);
  refused("cannot open: No such file or directory");
  folder.run_well("mkdir m.db");
  refused("cannot open: Is a directory");
  // Something else is not overwritten.
  folder.write("mine.txt", "mine");
  EXPECT_EQ(folder
                .run(run + "--checkpoint mine.txt --checkpoint-every 1 "
                           "--output x.json")
                .err,
            "hinge-separation: mine.txt: the file must be a checkpoint of "
            "hinge-separation\n");
  EXPECT_EQ(folder.read("mine.txt"), "mine");
}

// A run that is killed as soon as its checkpoint has been seen to change so
// many times goes on to the same bytes.
void expect_same_after_kills(const ProgramFolder& folder,
                             const std::string& file,
                             const std::string& interval) {
  const std::string run =
      "hinge-separation " + file + " --output o.json --history ";
  const std::string every =
      " --events e.csv --checkpoint-every " + interval + " --checkpoint c.db";
  folder.run_well(run + "a.csv" + every);
  folder.run_well("mv e.csv ae.csv");
  for (const char* changes : {"1", "2", "5", "10", "20"}) {
    const ProgramResult killed =
        folder.run("cp c.db seen\n" + run + "k.csv" + every + " & run=$!\n" +
                   "left=" + changes +
                   "\n"
                   "while [ $left -gt 0 ] && kill -0 $run 2>/dev/null; do\n"
                   "  cmp -s c.db seen || left=$((left - 1))\n"
                   "  cp c.db seen\n"
                   "done\n"
                   "kill -KILL $run\n"
                   "wait $run");
    EXPECT_EQ(killed.status, 128 + SIGKILL) << changes;
    folder.run_well(run + "b.csv --events e.csv --resume c.db");
    EXPECT_TRUE(folder.read("b.csv") == folder.read("a.csv")) << changes;
    EXPECT_EQ(folder.read("e.csv"), folder.read("ae.csv")) << changes;
  }
}

// Killed at any instant a run leaves a checkpoint that leads to the same
// bytes; so it does if it writes over one of an earlier run.
TEST(Checkpoint, KilledRunsGoOn) {
  const ProgramFolder folder;
  expect_same_after_kills(folder, "data/cases/slosh.toml", "0.05");
}

// Also between bounces, on a rigid stop and on a compliant one, of which there
// are some dozens.
TEST(Checkpoint, RunsKilledBetweenBouncesGoOn) {
  const ProgramFolder folder;
  const auto boom = [](const char* name, const char* stop) {
    return std::string("\n[[body]]\nname = \"") + name +
           R"("
mass_kg = 5; com_m = [1, 0, 0]; principal_inertia_kg_m2 = [1, 2, 2]
[body.hinge]; kind = "axis"; axis = [0, 0, 1]
[[body.hinge.joint]]; name = "pin"; kind = "pin"
geometry = { radius_mm = 5, radial_clearance_um = 10, length_mm = 20 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.1 }
[[body.hinge.stop]]; angle_deg = -90; from = "above"
)"_toml + stop +
           "[body.start]\nangle_deg = -40\n";
  };
  folder.write("c.toml", R"(
name = "bounces"; gravity_m_per_s2 = [0, -9.81, 0]
run = { end_time_s = 20, output_step_s = 0.1 }
)"_toml + carrier_at_rest("base") +
                             boom("rigid", "restitution = 0.98\n") +
                             boom("soft",
                                  "restitution = 0.98\n"
                                  "stiffness_N_m_per_rad = 2e4\n"));
  expect_same_after_kills(folder, "c.toml", "0.05");
  const std::string events = folder.read("e.csv");
  std::size_t hits = 0;
  for (auto at = events.find("hits its stop"); at != events.npos;
       at = events.find("hits its stop", at + 1)) {
    ++hits;
  }
  EXPECT_GT(hits, 20u);
}

// A station of 1e9 kg m^2 that begins to turn on its ball joint: its direction
// of sliding follows the direction of the moment, also after a checkpoint.
TEST(Checkpoint, GoesOnInTheMiddleOfASlowOnset) {
  const ProgramFolder folder;
  folder.write("c.toml", R"(
name = "onset"; gravity_m_per_s2 = [0, -9.81, 0]
run = { end_time_s = 20, output_step_s = 1, absolute_tolerance = 1e-14 }
)"_toml + carrier_at_rest("base") +
                             R"(
[[body]]; name = "station"; mass_kg = 50
principal_inertia_kg_m2 = [1e9, 1e9, 1e9]
[body.hinge]; kind = "ball"; carrier_point_m = [0, 0, 0]
[[body.hinge.joint]]; name = "ball"; kind = "ball"
geometry = { radius_mm = 50, radial_clearance_um = 50 }
materials.inner = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
materials.outer = { youngs_modulus_GPa = 200, poissons_ratio = 0.3 }
friction = { coefficient = 0.3 }
[[force]]; name = "torque"; body = "station"; kind = "applied"
time_s = [0, 20]; moment_N_m = [[6.9, 0, 0], [7.3, 0, 1.5]]
)"_toml);
  const std::string run = "hinge-separation c.toml ";
  folder.run_well(run + "--history s.csv --output s.json");
  folder.run_well(run +
                  "--history a.csv --output a.json --checkpoint "
                  "c.db --checkpoint-every 12");
  folder.run_well(run + "--history b.csv --output b.json --resume c.db");
  EXPECT_TRUE(folder.read("b.csv") == folder.read("a.csv"));
  const History without(folder.read("s.csv"));
  const History with(folder.read("a.csv"));
  EXPECT_EQ(with.texts("station.mode")[5], "resting");
  EXPECT_EQ(with.texts("station.mode")[12], "sliding");
  for (const char* column : {"station.wx_rad_per_s", "station.wz_rad_per_s"}) {
    const double last = without[column].back();
    EXPECT_NEAR(with[column].back(), last, 1e-8 * std::abs(last)) << column;
  }
}

// A damper that makes explicit steps as short as 1e-7 s, in a motion of 1000 s:
// what has been computed is there however the run is stopped, and it is said
// what held it.
class RunsThatCannotGetOn : public testing::Test {
 protected:
  RunsThatCannotGetOn() {
    const std::string text = pushed_case(0, 0, R"(ends_at_s = 0.2
[[force]]; name = "damper"; body = "s"; kind = "spring"; point_m = [-0.2, 0, 0]
carrier_point_m = [0.5, 0, 0]; stiffness_N_per_m = 0; free_length_m = 0.3
damping_N_s_per_m = 1e8; starts_at_s = 0.5
)"_toml);
    folder_.write("c.toml",
                  exchanged(text, "end_time_s = 2",
                            "end_time_s = 1000\noutput_step_s = 0.25"));
  }
  // Its results equal the results of a stopped run, and are complete.
  void expect_results(const ProgramResult& result, int status,
                      const std::string& why) {
    EXPECT_EQ(result.status, status) << result.err;
    const json summary = json::parse(folder_.read("o.json"));
    const std::string failure = summary["failure"];
    EXPECT_TRUE(has_text(failure, ": stopped by " + why + " after "));
    EXPECT_TRUE(has_text(failure,
                         "the fastest force is \"damper\" on \"s\" (5e-08 "
                         "s)"));
    EXPECT_TRUE(
        has_text(result.err,
                 "hinge-separation: warning: ended early: " + failure + "\n"));
    const History h(folder_.read("h.csv"));
    EXPECT_EQ(h["time_s"].back(), summary["end_time_s"].get<double>());
    EXPECT_GE(h["time_s"].back(), 0.5);
    EXPECT_EQ(h["s.x_m"].size(), h.size());
    EXPECT_TRUE(folder_.read("e.csv").starts_with("time_s,body,what\n"));
    for (const std::string& file : folder_.files()) {
      EXPECT_FALSE(file.starts_with(".")) << file;
    }
  }

  ProgramFolder folder_;
  const std::string run_ =
      "hinge-separation c.toml --history h.csv --events e.csv --output o.json ";
};

TEST_F(RunsThatCannotGetOn, StopAtLimits) {
  const ProgramResult steps = folder_.run(run_ + "--step-limit 3000");
  expect_results(steps, 1, "--step-limit 3000");
  EXPECT_EQ(json::parse(folder_.read("o.json"))["counts"]["steps"], 3000);
  EXPECT_FALSE(has_text(steps.err, "--resume"));
  expect_results(folder_.run(run_ + "--time-limit 2"), 1, "--time-limit 2 s");
}

// Off a terminal too.
TEST_F(RunsThatCannotGetOn, SayHowFarTheyAreEveryTenSeconds) {
  const ProgramResult result = folder_.run(run_ + "--time-limit 11");
  expect_results(result, 1, "--time-limit 11 s");
  EXPECT_TRUE(result.err.starts_with("hinge-separation: 0.")) << result.err;
  EXPECT_TRUE(has_text(result.err, " s of 1000 s, "));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2)
      << result.err;
}

// A signal that a shell without job control would have its child ignore comes
// by way of the program env.
TEST_F(RunsThatCannotGetOn, StopAtSignals) {
  for (const auto& [name, status] : {std::pair("INT", 130), {"TERM", 143}}) {
    const ProgramResult result =
        folder_.run("rm -f c.db; env --default-signal=INT " + run_ +
                    "--checkpoint c.db --checkpoint-every 0.5 & program=$!\n"
                    "while ! [ -s c.db ]; do sleep 0.02; done; sleep 0.2; "
                    "kill -" +
                    name + " $program; wait $program");
    expect_results(result, status, std::string("SIG") + name);
    EXPECT_TRUE(
        has_text(result.err, "; --resume c.db continues from t = 0.5 s\n"));
    expect_results(folder_.run(run_ + "--resume c.db --step-limit 3000"), 1,
                   "--step-limit 3000");
  }
}

// All links to a checkpoint have one writer.
TEST(Checkpoint, HasOneWriterAtATime) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-separation data/cases/slosh.toml --checkpoint-every 0.5 "
      "--output /dev/null --checkpoint ";
  const auto expect_locked_out = [&](const std::string& name) {
    folder.run_ill("flock c.db " + run + name, 2,
                   "hinge-separation: " + name +
                       ": another program writes to this "
                       "checkpoint\n");
  };
  expect_locked_out("c.db");
  // Remains of a program killed at its start do not lock the file.
  EXPECT_EQ(folder.read("c.db"), "");
  folder.run_well(run + "c.db && ln -s c.db link.db");
  expect_locked_out("link.db");
  // However they meet.
  folder.run_well(run + "d.db & " + run + "d.db & wait");
  folder.run_well(
      "hinge-separation data/cases/slosh.toml --output o.json --resume d.db");
}

}  // namespace
}  // namespace contact::test::checkpoint_test
