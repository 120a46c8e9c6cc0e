// Every example in every program's --help runs as it is printed.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"

namespace contact::test {
namespace {

class HelpExamples : public testing::TestWithParam<const char*> {};

TEST_P(HelpExamples, Run) {
  const auto examples = help_examples(GetParam());
  EXPECT_GE(examples.size(), 3U);
  for (const std::string& example : examples) {
    const auto result = ProgramFolder().run(example);
    EXPECT_EQ(result.status, 0) << example << '\n' << result.err;
    EXPECT_TRUE(result.out.find('\n') != std::string::npos ||
                example.find("--output") != std::string::npos)
        << example;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, HelpExamples,
                         testing::Values("hinge-table", "hinge-angle",
                                         "hinge-joint", "hinge-pressure",
                                         "hinge-separation", "hinge-duty",
                                         "hinge-identify", "hinge-study"));

}  // namespace
}  // namespace contact::test
