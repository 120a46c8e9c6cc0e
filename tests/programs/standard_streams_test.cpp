// Programs that start without standard input, output or error, or whose
// standard error cannot be written: no file gets what is meant for a stream,
// and no result is lost with a message.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"

namespace contact::test {
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
  const std::string journal = folder.read("j");
  EXPECT_EQ(folder.run(study + "--output o.json >&-").err,
            "hinge-study: cannot write standard output: Bad file "
            "descriptor\n");
  EXPECT_TRUE(folder.read("j") == journal);
  EXPECT_EQ(folder.run(study + "2>&-").out, first.out);
  EXPECT_TRUE(folder.read("j") == journal);
}

}  // namespace
}  // namespace contact::test
