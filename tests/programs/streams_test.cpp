// Programs that start without standard input, output or error, or whose
// standard error cannot be written: no file gets what is meant for a stream,
// and no result is lost with a message.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"

namespace contact::test::streams_test {
namespace {

// Runs that warn and write files. The event of the case comes later.
const std::string separation =
    "hinge-separation data/cases/two_stage_turn.toml --end-time 0.2 "
    "--history h.csv --output o.json";
const std::string identification =
    "hinge-identify --joint data/duty/torque_rig.toml "
    "--data data/duty/torque_rig.csv --residuals h.csv --output o.json";

class Streams : public testing::TestWithParam<std::string> {};

TEST_P(Streams, CostNoResult) {
  const std::string how = ' ' + GetParam();
  for (const std::string& run : {separation, identification}) {
    const ProgramFolder whole;
    const ProgramResult expected = whole.run_well(run);
    ASSERT_TRUE(has_text(expected.err, "warning: ")) << run;
    const ProgramFolder folder;
    folder.run_well(run + how);
    EXPECT_EQ(folder.files(), whole.files());
    for (const std::string name : {"h.csv", "o.json"}) {
      EXPECT_TRUE(folder.read(name) == whole.read(name)) << run << ' ' << name;
    }
  }
  EXPECT_EQ(ProgramFolder().run("hinge-angle --nope" + how).status, 2);
}

INSTANTIATE_TEST_SUITE_P(Of, Streams,
                         testing::Values("<&-", ">&-", "2>&-", "<&- >&-",
                                         "<&- 2>&-", ">&- 2>&-", "<&- >&- 2>&-",
                                         "2>/dev/full", "<&- 2>/dev/full"));

TEST(StandardStreams, MissingOnesAreNotWrittenOrRead) {
  const ProgramFolder folder;
  const auto message = [&](const std::string& run) {
    const ProgramResult result = folder.run(run);
    EXPECT_EQ(result.status, 2) << run;
    EXPECT_EQ(result.out, "") << run;
    return result.err;
  };
  const std::string cannot_write =
      "hinge-table: cannot write standard output: Bad file descriptor\n";
  const std::string run = "hinge-table --theta0 45 --alpha 30 ";
  EXPECT_EQ(message(run + ">&-"), cannot_write);
  EXPECT_EQ(message(run + "<&- >&-"), cannot_write);
  EXPECT_EQ(message(run + "--output - >&-"), cannot_write);
  EXPECT_EQ(message("hinge-table --points - <&-"),
            "hinge-table: cannot read standard input: Bad file descriptor\n");
  EXPECT_TRUE(folder.files().empty());
}

TEST(StandardStreams, HelpThatCannotBeWrittenIsAnError) {
  const ProgramFolder folder;
  for (const std::string option : {"--help", "--version"}) {
    for (const auto& [where, why] :
         {std::pair{" >&-", "Bad file descriptor"},
          {" >/dev/full", "No space left on device"}}) {
      folder.run_ill("hinge-table " + option + where, 2,
                     "hinge-table: cannot write standard output: " +
                         std::string(why) + "\n");
    }
    EXPECT_TRUE(has_text(folder.run_well("hinge-table " + option).out,
                         option == "--help" ? "--theta0" : "(libcontact)"));
  }
}

// Names speak to no terminal; elsewhere they are data.
TEST(StandardStreams, TerminalsAreNotSpokenTo) {
  const ProgramFolder folder;
  folder.write("j.toml",
               "name = 'ball'\nkind = 'ball'\n"
               "geometry = { radius_mm = 50, radial_clearance_um = 100 }\n"
               "materials = { pair = 'data/materials/steel_steel.toml' }\n"
               "friction = { coefficient = 0.1 }\n");
  folder.write("s.toml",
               "name = \"\\u001b[31mred \\u202e* _red_\"\njoint = 'j.toml'\n"
               "runs = 5\nload = { reaction_kN = 100, beta_deg = 60 }\n"
               "quantities = ['M_t_N_m']\n"
               "[[factor]]\nname = \"\\u001b[2J\"\n"
               "[[dispersion]]\nkey = 'friction.coefficient'\n"
               "kind = 'uniform'\nlow = 0.05\nhigh = 0.15\n"
               "factors = [\"\\u001b[2J\"]\nloadings = [0.5]\n");
  const auto on_terminal = [&](const std::string& command) {
    return folder.run_well("script -qec '" + command + "' /dev/null").out;
  };
  folder.write("c.toml",
               "name = 'c'\nrun = { end_time_s = 0.1 }\n"
               "carrier = { name = 'a', fixed = true }\n"
               "[[body]]\nname = \"\\u001b[2J\"\nmass_kg = 1\n"
               "principal_inertia_kg_m2 = [1, 1, 1]\n");
  const std::string history =
      "hinge-separation c.toml --history - --output o.json";
  EXPECT_TRUE(has_text(folder.run_well(history).out, "\x1b[2J"));
  const std::string shown = on_terminal(history);
  EXPECT_FALSE(has_text(shown, "\x1b")) << shown;
  EXPECT_TRUE(has_text(shown, "\\x1b[2J"));
  // The table for people has none anywhere.
  const std::string page = folder.run_well("hinge-study s.toml").out;
  EXPECT_TRUE(page.starts_with(R"(# \\x1b[31mred \\xe2\\x80\\xae\* \_red\_)"))
      << page;
  const std::string report = on_terminal("hinge-study s.toml");
  EXPECT_TRUE(report.starts_with(R"(\x1b[31mred \xe2\x80\xae* _red_)"))
      << report;
  for (const std::string& text : {page, report}) {
    EXPECT_FALSE(has_text(text, "\x1b"));
  }
}

// The table that has no place to go to was written over the journal's rows.
TEST(StandardStreams, JournalsSurviveMissingOnes) {
  const ProgramFolder folder;
  const std::string study =
      "hinge-study data/studies/lined_bearing.toml --runs 5 --journal j ";
  const ProgramResult first = folder.run(study);
  ASSERT_LE(first.status, 1) << first.err;
  const auto rows = [&] {
    return folder.run_well("sqlite3 j 'SELECT * FROM rows'").out;
  };
  const std::string journal = rows();
  EXPECT_EQ(std::ranges::count(journal, '\n'), 6);
  EXPECT_EQ(folder.run(study + "--output o.json >&-").err,
            "hinge-study: cannot write standard output: Bad file "
            "descriptor\n");
  EXPECT_EQ(rows(), journal);
  EXPECT_EQ(folder.run(study + "2>&-").out, first.out);
  EXPECT_EQ(rows(), journal);
}

// Output that cannot be written or must be written once; with
// messages_test.cpp, which has the messages.
// Runs of tests/messages/options/output.txt that would say something first.
TEST(UnwritableOutput, ComesBeforeWarnings) {
  const ProgramFolder folder;
  const std::string ball =
      "--joint ball --pair data/materials/steel_bronze.toml --radius 50mm "
      "--clearance 50um --law tanh ";
  const std::string friction = "--friction 0.1 --reaction 1e4 --beta 60";
  for (const std::string& run :
       {"hinge-angle " + ball + "--load 1e4",
        "hinge-pressure " + ball + "--load 1e4",
        "hinge-joint " + ball + friction,
        "hinge-joint " + ball + friction + " --trace",
        std::string("hinge-separation data/cases/soyuz.toml --law tanh")}) {
    EXPECT_TRUE(has_text(folder.run(run).err, "warning: ")) << run;
  }
}

// A renaming would replace what writing in place could not.
TEST(UnwritableOutput, IsKept) {
  const ProgramFolder folder;
  const std::string run = "hinge-fmu data/joints/wheel_pin.toml --output ";
  folder.write("kept", "mine");
  folder.run_well("chmod 0444 kept; ln -s nowhere to_none; ln -s loop loop");
  folder.run_ill(run + "kept", 2,
                 "hinge-fmu: cannot write " +
                     (folder.path() / "kept").string() +
                     ": Permission denied\n");
  EXPECT_EQ(folder.read("kept"), "mine");
  for (const std::string link : {"to_none", "loop"}) {
    folder.run_ill(
        run + link, 2,
        "hinge-fmu: cannot write " + link + ": No such file or directory\n");
  }
  folder.run_well("ln -s there to_one; echo mine >there; " + run + "to_one");
  EXPECT_GT(folder.read("there").size(), 1000u);
  const auto files = folder.files();
  EXPECT_EQ(files.size(), 5u);
  for (const std::string& name : files) EXPECT_NE(name[0], '.') << name;
}

// The working folder of hinge-fmu is removed however it ends.
TEST(Signals, LeaveNoTemporaryFolder) {
  const ProgramFolder folder;
  int ended = 0;
  for (const std::string signal : {"TERM", "HUP", "XCPU"}) {
    for (int wait = 10; wait <= 190; wait += 60) {
      const ProgramResult result = folder.run(
          "mkdir -p tmp; TMPDIR=$PWD/tmp timeout -s " + signal + " 0." +
          (wait < 100 ? "0" : "") + std::to_string(wait) +
          " hinge-fmu data/cases/gimbal.toml --output it.fmu; "
          "status=$?; rm -f it.fmu; rmdir tmp || exit 9; exit $status");
      EXPECT_NE(result.status, 9) << signal << ' ' << wait << result.err;
      ended += result.status == 124;
    }
  }
  EXPECT_GT(ended, 3);
}

// A pipe that is inspected first still delivers the whole table.
TEST(UnwritableOutput, PipesAreNotOpenedTwice) {
  const ProgramFolder folder;
  const std::string run = "hinge-table --theta0 0:90:1 --alpha 0:90:9";
  const ProgramResult piped = folder.run_well("mkfifo pipe; cat pipe & " + run +
                                              " --output pipe; wait");
  EXPECT_EQ(piped.out, folder.run(run).out);
}

// On a full disk a program names the file that it cannot write, leaves no part
// of it under its name, and writes all others.
// A command on a disk with so much room for files.
std::string with_room(int bytes, const std::string& command) {
  return "CONTACT_TEST_ROOM=" + std::to_string(bytes) +
         " ASAN_OPTIONS=verify_asan_link_order=0"
         " LD_PRELOAD='" CONTACT_FULL_DISK "' " +
         command;
}

TEST(FullDisk, ResultsAreWholeOrNotThere) {
  const std::string joint = "data/joints/hip_cocr_uhmwpe_infinite.toml";
  const std::string duty = "data/reference/duty/cycle_hip";
  const std::string rig = "data/duty/torque_rig";
  const std::vector<std::string> runs = {
      "hinge-table --theta0 0:90:9 --alpha 0:90:9",
      "hinge-angle --joint ball --modulus-ratio 1 --x 0.1:1:0.1",
      "hinge-pressure --joint ball --modulus-ratio 1 --x 1",
      "hinge-joint --joint " + joint + " --reaction 100:900:100 --beta 30",
      "hinge-duty --law fitted --joint " + duty + ".toml --euler zxy --cycle " +
          duty + "_in.csv",
      "hinge-identify --law fitted --fit f0,A --joint " + rig +
          ".toml --data " + rig + ".csv",
      "hinge-separation data/cases/slosh.toml"};
  for (const std::string& run : runs) {
    for (const int room : {0, 100}) {
      const ProgramFolder folder;
      folder.run_ill(with_room(room, run + " --output result"), 2,
                     run.substr(0, run.find(' ')) + ": cannot write " +
                         "result: No space left on device\n");
      EXPECT_TRUE(folder.files().empty());
    }
  }
}

// A file has its name when it is on the disk and not before.
TEST(FullDisk, FilesAreKeptBeforeTheyHaveTheirNames) {
  const ProgramFolder folder;
  folder.run_ill(
      "CONTACT_TEST_LATE=1 " +
          with_room(0, "hinge-table --theta0 45 --alpha 30 --output result"),
      2, "hinge-table: cannot write result: No space left on device\n");
  EXPECT_TRUE(folder.files().empty());
}

// The history and the events of a separation cost nothing but themselves,
// wherever the disk is full: HDF5 writes some parts of a file at its end, and
// closes it again when the program ends.
TEST(FullDisk, HistoriesAreWholeOrNotThere) {
  const ProgramFolder whole;
  const std::string run = "hinge-separation data/cases/slosh.toml ";
  const ProgramResult expected =
      whole.run_well(run + "--history h.h5 --events e.csv && " + run +
                     "--history h.csv >/dev/null");
  for (const std::string name : {"h.h5", "h.csv"}) {
    const auto size = static_cast<int>(whole.read(name).size());
    for (const int room : {0, 1, 96, 800, 4096, 20000, size / 2, size - 1}) {
      const ProgramFolder folder;
      const ProgramResult result =
          folder.run(with_room(room, run + "--history " + name));
      EXPECT_EQ(result.status, 1) << name << " " << room;
      EXPECT_EQ(result.err, "hinge-separation: warning: cannot write " + name +
                                ": No space left on device\n");
      EXPECT_EQ(result.out, expected.out);
      EXPECT_TRUE(folder.files().empty());
    }
    const ProgramFolder folder;
    folder.run_well(with_room(size, run + "--history " + name));
    EXPECT_EQ(folder.files(), Texts{name});
    EXPECT_EQ(folder.read(name).size(), whole.read(name).size());
  }
  // The events have room when the history has had none.
  const ProgramFolder folder;
  const ProgramResult result =
      folder.run(with_room(1000, run + "--history /dev/full --events e.csv"));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, expected.out);
  EXPECT_EQ(folder.read("e.csv"), whole.read("e.csv"));
}

// The file behind standard output is in use too.
TEST(StandardOutput, IsNotReplacedAndNotAnother) {
  const ProgramFolder folder;
  const std::string table = "hinge-table --theta0 1 --alpha 5";
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "-"}) {
    folder.run_well("echo head >l; " + table + " --output " + name +
                    " >>l; echo end >>l");
    EXPECT_EQ(folder.read("l"), "head\n" + folder.run_well(table).out + "end\n")
        << name;
  }
  const std::string said = " must be another file than --output\n";
  folder.run_ill(
      "hinge-duty --joint data/joints/hip_cocr_uhmwpe.toml --cycle "
      "data/duty/hip_cycle.csv --euler zxy --states v >v",
      2, "hinge-duty: --states v" + said);
  folder.run_ill(
      "hinge-study data/studies/lined_bearing.toml --runs 5 --journal j >j", 2,
      "hinge-study: --journal j" + said);
  folder.run_ill(
      "hinge-separation data/cases/door.toml --end-time 0.1 --checkpoint k "
      "--checkpoint-every 0.1 >k",
      2, "hinge-separation: --checkpoint k" + said);
}

TEST(FullDisk, ReplaysAreWholeOrNotThere) {
  const std::string run = "hinge-separation data/cases/soyuz.toml ";
  const ProgramResult expected = ProgramFolder().run(run);
  for (const int room : {0, 1000, 100000}) {
    const ProgramFolder folder;
    const ProgramResult result =
        folder.run(with_room(room, run + "--replay a.glb"));
    EXPECT_EQ(result.status, 1) << room;
    EXPECT_EQ(result.err,
              "hinge-separation: warning: cannot write a.glb: No space left on "
              "device\n");
    EXPECT_EQ(result.out, expected.out);
    EXPECT_TRUE(folder.files().empty());
  }
}

// A checkpoint that cannot be written costs nothing but itself; the one before
// it stays good.
TEST(FullDisk, CheckpointsAreWholeOrNotThere) {
  const std::string run = "hinge-separation data/cases/slosh.toml ";
  const std::string checkpoints =
      "--checkpoint state --checkpoint-every 0.5 --events /dev/null";
  const ProgramFolder whole;
  const ProgramResult expected = whole.run_well(run + checkpoints);
  // A run writes more than it leaves: what is renewed is kept meanwhile.
  const auto size = static_cast<int>(whole.read("state").size());
  for (const int room : {0, 1000, size / 2, 2 * size}) {
    const ProgramFolder folder;
    const ProgramResult result = folder.run(with_room(room, run + checkpoints));
    EXPECT_EQ(result.status, 1) << room;
    EXPECT_EQ(result.out, expected.out);
    EXPECT_TRUE(has_text(result.err,
                         "hinge-separation: warning: no checkpoints from "
                         "t = "));
    EXPECT_TRUE(has_text(result.err, "No space left on device"));
    if (room < size / 2) {
      EXPECT_TRUE(folder.files().empty());
      continue;
    }
    folder.run_well(run + "--resume state");
  }
}

// Wherever the disk is full, earlier rows are kept, and the same command
// continues to identical bytes.
TEST(FullDisk, JournalsGoOn) {
  const ProgramFolder folder;
  const std::string run =
      "hinge-study data/studies/lined_bearing.toml --runs 40 ";
  ASSERT_LE(folder.run(run + "--csv whole.csv --journal whole").status, 1);
  const std::string whole = folder.read("whole.csv");
  std::size_t rows = 0;
  int stopped = 0;
  for (int room = 0; room < 400'000; room += 9'001) {
    const ProgramResult full =
        folder.run(with_room(room, run + "--rows 0:40 --journal j"));
    if (full.status == 0) break;
    ++stopped;
    EXPECT_EQ(full.status, 2);
    EXPECT_EQ(full.err,
              "hinge-study: j: cannot write: No space left on device\n");
    // None before the table has been made.
    const std::string now =
        folder.run("sqlite3 j 'SELECT count(*) FROM rows'").out;
    EXPECT_GE(now.empty() ? 0 : std::stoul(now), rows);
    rows = now.empty() ? 0 : std::stoul(now);
  }
  EXPECT_GT(stopped, 3);
  EXPECT_LE(folder.run(run + "--csv j.csv --journal j").status, 1);
  EXPECT_EQ(folder.read("j.csv"), whole);
}

TEST(FullDisk, PicturesAreWholeOrNotThere) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  for (const std::string name : {"p.svg", "p.png", "p.pdf"}) {
    for (const int room : {0, 1000}) {
      const ProgramResult result = folder.run(with_room(
          room, "hinge-table --theta0 45 --alpha 0:90:9 --plot " + name));
      EXPECT_EQ(result.status, 1);
      EXPECT_EQ(result.err, "hinge-table: warning: no picture " + name +
                                ": cannot write " + name +
                                ": No space left on device\n");
      EXPECT_EQ(csv_rows(result.out).size(), 12U);
      EXPECT_TRUE(folder.files().empty());
    }
  }
}

// The same on a file system that is full for gnuplot too.
TEST(FullDisk, PicturesOnASmallFileSystem) {
  const ProgramFolder folder;
  if (!folder.has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  // Pages of 4 KiB, one for the folder.
  const auto small = [&folder](int pages, const std::string& command) {
    return folder.run(
        "mkdir -p small; unshare -rm sh -c 'mount -t tmpfs -o size=" +
        std::to_string(4 * pages) + "k tmpfs small || exit 77; cd small; " +
        command + "; status=$?; ls -A; exit $status'");
  };
  if (small(4, "true").status != 0) {
    GTEST_SKIP() << "no file system can be mounted in a namespace here";
  }
  for (const std::string name : {"p.svg", "p.png", "p.pdf"}) {
    bool was_refused = false;
    bool was_drawn = false;
    for (const int pages : {1, 2, 4, 6, 8, 12, 16, 64}) {
      const ProgramResult result =
          small(pages, "hinge-table --theta0 5:85:10 --alpha 0:90:0.5 --plot " +
                           name + " >/dev/null");
      if (result.status == 0) {
        was_drawn = true;
        EXPECT_EQ(result.out, name + '\n');
        EXPECT_EQ(result.err, "");
      } else {
        was_refused = true;
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.out, "") << "left there";
        const std::string end = name + ": No space left on device\n";
        const std::string begin =
            "hinge-table: warning: no picture " + name + ": cannot ";
        EXPECT_TRUE(result.err == begin + "create " + end ||
                    result.err == begin + "write " + end)
            << result.err;
      }
    }
    EXPECT_TRUE(was_refused && was_drawn) << name;
  }
}

}  // namespace
}  // namespace contact::test::streams_test
