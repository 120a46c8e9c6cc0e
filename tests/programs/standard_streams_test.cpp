// Programs that start without standard input, output or error, or whose
// standard error cannot be written: no file gets what is meant for a stream,
// and no result is lost with a message.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/program.hpp"

namespace {

using contact::test::ProgramFolder;
using contact::test::ProgramResult;

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
    const ProgramResult expected = whole.run(run);
    ASSERT_EQ(expected.status, 0) << expected.err;
    ASSERT_NE(expected.err.find("warning: "), std::string::npos) << run;
    const ProgramFolder folder;
    EXPECT_EQ(folder.run(run + how).status, 0) << run;
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

// The table that has no place to go to was written over the journal's rows.
TEST(StandardStreams, JournalsSurviveMissingOnes) {
  const ProgramFolder folder;
  const std::string study =
      "hinge-study data/studies/lined_bearing.toml --runs 5 --journal j ";
  const ProgramResult first = folder.run(study);
  ASSERT_LE(first.status, 1) << first.err;
  const auto rows = [&] {
    const ProgramResult read = folder.run("sqlite3 j 'SELECT * FROM rows'");
    EXPECT_EQ(read.status, 0) << read.err;
    return read.out;
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

}  // namespace
