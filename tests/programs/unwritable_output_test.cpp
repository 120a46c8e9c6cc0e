// Output that cannot be written or must be written once; with
// messages_test.cpp, which has the messages.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"

namespace contact::test {
namespace {

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

// A pipe that is looked at first still has all of the table.
TEST(UnwritableOutput, PipesAreNotOpenedTwice) {
  const ProgramFolder folder;
  const std::string run = "hinge-table --theta0 0:90:1 --alpha 0:90:9";
  const ProgramResult piped = folder.run_well("mkfifo pipe; cat pipe & " + run +
                                              " --output pipe; wait");
  EXPECT_EQ(piped.out, folder.run(run).out);
}

}  // namespace
}  // namespace contact::test
