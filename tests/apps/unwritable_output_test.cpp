// Every program finds out that its output cannot be written before it reads,
// warns or works.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program.hpp"

namespace {

using contact::test::ProgramFolder;
using contact::test::ProgramResult;

// A run whose law is used outside its range, which is said; and a file that it
// reads: a run without that file.
struct Program {
  std::string name;
  std::string warns;
  std::string reads;
};

const std::string ball =
    "--joint ball --pair data/materials/steel_bronze.toml --radius 50mm "
    "--clearance 50um --law tanh ";

const std::vector<Program> programs = {
    {"hinge-angle", ball + "--load 1e4", "--joint none.toml --load 1"},
    {"hinge-pressure", ball + "--load 1e4", "--joint none.toml --load 1"},
    {"hinge-joint", ball + "--friction 0.1 --reaction 1e4 --beta 60",
     "--joint none.toml --reaction 1 --beta 1"},
    {"hinge-joint", ball + "--friction 0.1 --reaction 1e4 --beta 60 --trace",
     "--joint none.toml --reaction 1 --beta 1 --trace"},
    {"hinge-table", "", "--points none.csv"},
    {"hinge-separation", "data/cases/soyuz.toml --law tanh", "none.toml"}};

TEST(UnwritableOutput, IsFoundFirst) {
  const ProgramFolder folder;
  for (const auto& [name, warns, reads] : programs) {
    std::vector<std::string> runs = {name + ' ' + reads};
    if (!warns.empty()) {
      runs.push_back(name + ' ' + warns);
      EXPECT_NE(folder.run(runs.back()).err.find("warning: "),
                std::string::npos);
    }
    for (const std::string& run : runs) {
      const ProgramResult result = folder.run(run + " --output no/where.txt");
      EXPECT_EQ(result.status, 2) << run;
      EXPECT_EQ(result.err, name +
                                ": cannot create no/where.txt: "
                                "No such file or directory\n");
      const ProgramResult closed = folder.run(run + " >&-");
      EXPECT_EQ(closed.status, 2) << run;
      EXPECT_EQ(closed.err, name +
                                ": cannot write standard output: "
                                "Bad file descriptor\n");
    }
  }
  EXPECT_TRUE(folder.files().empty());
}

// So of the files that hinge-separation alone has.
TEST(UnwritableOutput, OfASeparationToo) {
  const ProgramFolder folder;
  for (const std::string file :
       {"--history no/where.csv", "--events no/where.csv",
        "--checkpoint no/where.csv --checkpoint-every 1"}) {
    const ProgramResult result =
        folder.run("hinge-separation none.toml " + file);
    EXPECT_EQ(result.status, 2) << file;
    EXPECT_EQ(result.err,
              "hinge-separation: cannot create no/where.csv: "
              "No such file or directory\n");
  }
  EXPECT_TRUE(folder.files().empty());
}

// A file that is looked at first does not stay in its place.
TEST(UnwritableOutput, ClosedStandardOutputStaysClosed) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run(
      "hinge-separation data/cases/slosh.toml --output s.json --history - "
      ">&-");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err,
            "hinge-separation: cannot write standard output: "
            "Bad file descriptor\n");
  EXPECT_TRUE(folder.files().empty());
}

// A pipe that is looked at first still has all of the table.
TEST(UnwritableOutput, PipesAreNotOpenedTwice) {
  const ProgramFolder folder;
  const std::string run = "hinge-table --theta0 0:90:1 --alpha 0:90:9";
  const ProgramResult piped =
      folder.run("mkfifo pipe; cat pipe & " + run + " --output pipe; wait");
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(piped.out, folder.run(run).out);
}

}  // namespace
